// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/gl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string_view>

#include "renderer/base/error.h"

namespace obscura::renderer {
namespace {

constexpr std::string_view kRemedy =
    "An OpenGL 4.5 driver with EGL is needed: install libegl-mesa0 and libgl1-mesa-dri for Mesa "
    "(its software renderer needs no graphics card), or the vendor's driver with its EGL library";

/// A display that needs no window system. Mesa's surfaceless platform first, then the first device
/// (NVIDIA's driver has no surfaceless platform), then the default.
EGLDisplay open_display() {
    const bool has_client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) != nullptr;
    EGLint major = 0;
    EGLint minor = 0;
    if (has_client_extensions &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (eglQueryDevicesEXT(16, devices, &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                EGLDisplay display =
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
                if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor)) {
                    return display;
                }
            }
        }
    }
    if (has_client_extensions &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor)) return display;
    }
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor)) return display;
    throw base::failure("no EGL display could be opened (EGL error 0x{:x}). {}", eglGetError(),
                        kRemedy);
}

}  // namespace

HeadlessContext::HeadlessContext() {
    EGLDisplay display = open_display();
    display_ = display;
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        throw base::failure("EGL offers no desktop OpenGL (error 0x{:x}). {}", eglGetError(),
                            kRemedy);
    }
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                  EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    if (eglChooseConfig(display, kConfig, &config, 1, &count) != EGL_TRUE || count == 0) {
        config = EGL_NO_CONFIG_KHR;
    }
    constexpr EGLint kContext[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext);
    if (context == EGL_NO_CONTEXT) {
        const EGLint reason = eglGetError();
        const char* vendor = eglQueryString(display, EGL_VENDOR);
        const std::string name = vendor != nullptr ? vendor : "unknown";
        eglTerminate(display);
        throw base::failure(
            "the EGL driver \"{}\" could not make an OpenGL 4.5 core context (error 0x{:x}). {}",
            name, reason, kRemedy);
    }
    context_ = context;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        const EGLint reason = eglGetError();
        eglDestroyContext(display, context);
        eglTerminate(display);
        throw base::failure(
            "the OpenGL context could not be used without a window (error 0x{:x}). "
            "{}",
            reason, kRemedy);
    }
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string gpu_renderer() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

std::string gpu_description() {
    return gpu_renderer() + ", " + reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

}  // namespace obscura::renderer
