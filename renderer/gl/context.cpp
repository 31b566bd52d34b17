// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/gl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "renderer/base/error.h"

namespace obscura::renderer {
namespace {

constexpr std::string_view kRemedy =
    "An OpenGL 4.5 driver with EGL is needed: install libegl-mesa0 and libgl1-mesa-dri for Mesa "
    "(its software renderer needs no graphics card), or the vendor's driver with its EGL library";

/// A display and a context on it.
struct Made {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

/// Every display that needs no window system, best first: the devices (a graphics card's driver,
/// then Mesa's software renderer), Mesa's surfaceless platform, whatever EGL takes for its default.
std::vector<EGLDisplay> displays() {
    std::vector<EGLDisplay> list;
    const bool has_client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) != nullptr;
    if (has_client_extensions &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (eglQueryDevicesEXT(16, devices, &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                list.push_back(
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
            }
        }
    }
    if (has_client_extensions &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        list.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    list.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return list;
}

/// A current OpenGL 4.5 core context on that display; where there is none, `why` says so. The
/// display stays open as long as the program runs: a driver may keep files of every display that is
/// opened and closed, and another context may be on it.
Made make_on(EGLDisplay display, std::string& why) {
    if (display == EGL_NO_DISPLAY) return {};
    EGLint major = 0;
    EGLint minor = 0;
    if (eglInitialize(display, &major, &minor) != EGL_TRUE) {
        why += fmt::format("; a display could not be opened (EGL error 0x{:x})", eglGetError());
        return {};
    }
    const char* vendor = eglQueryString(display, EGL_VENDOR);
    const std::string name = vendor != nullptr ? vendor : "unknown";
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                  EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    if (eglChooseConfig(display, kConfig, &config, 1, &count) != EGL_TRUE || count == 0) {
        config = EGL_NO_CONFIG_KHR;
    }
    // The last pair asks that a driver that was reset says so, where it can (GL_CONTEXT_LOST).
    constexpr EGLint kContext[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                   EGL_LOSE_CONTEXT_ON_RESET,
                                   EGL_NONE};
    constexpr EGLint kPlainContext[] = {kContext[0], kContext[1], kContext[2], kContext[3],
                                        kContext[4], kContext[5], EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext);
        if (context == EGL_NO_CONTEXT) {
            context = eglCreateContext(display, config, EGL_NO_CONTEXT, kPlainContext);
        }
    }
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return {display, context};
    }
    why +=
        fmt::format("; the driver \"{}\" made no context (EGL error 0x{:x})", name, eglGetError());
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    return {};
}

}  // namespace

HeadlessContext::HeadlessContext() {
    std::string why;
    for (EGLDisplay display : displays()) {
        const Made made = make_on(display, why);
        if (made.context == EGL_NO_CONTEXT) continue;
        display_ = made.display;
        context_ = made.context;
        return;
    }
    throw base::failure("no OpenGL 4.5 core context could be made without a window{}. {}", why,
                        kRemedy);
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglReleaseThread();
}

std::string gpu_renderer() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

bool is_software_renderer() {
    const std::string name = gpu_renderer();
    constexpr std::string_view kNames[] = {"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                           "Software Rasterizer"};
    return std::any_of(std::begin(kNames), std::end(kNames), [&name](std::string_view known) {
        return name.find(known) != std::string::npos;
    });
}

std::string gpu_description() {
    return gpu_renderer() + ", " + reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

}  // namespace obscura::renderer
