// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Linked into every program that is built with the sanitizers. What graphics drivers and libraries
// allocate once and never give back is no leak of this project; it is told by the library it comes
// from, which is only known while the library is still loaded when the program ends.
extern "C" {

/// Instead of the C library's: nothing is unloaded.
int dlclose(void* /*handle*/) { return 0; }

/// The sanitizer guesses where the thread-local memory of a library that was loaded late lies, and
/// with the drivers here at times wrongly: it then falls over itself.
const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }  // NOLINT

const char* __lsan_default_suppressions() {  // NOLINT: the sanitizer's own name
    return "leak:swrast_dri.so\n"
           "leak:libEGL\n"
           "leak:libGLX\n"
           "leak:libLLVM\n"
           "leak:libfontconfig\n"
           "leak:ImageInput::geterror\n";  // OpenImageIO keeps the last message of each thread
}
}
