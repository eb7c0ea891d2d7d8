// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/egl_context.h"

#include <epoxy/egl.h>

#include <array>
#include <vector>

namespace tactooth {

namespace {

/// Every display that could draw without a screen, best first: graphics cards, then Mesa's surfaceless platform (which
/// also has software drawing), then whatever the system takes as default.
std::vector<EGLDisplay> candidates() {
    std::vector<EGLDisplay> displays;
    const bool platforms = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
    if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                displays.push_back(
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr));
            }
        }
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLContext coreContext(EGLDisplay display) {
    constexpr std::array<EGLint, 7> kConfig = {
        EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_NONE};
    constexpr std::array<EGLint, 7> kVersion = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                                4,
                                                EGL_CONTEXT_MINOR_VERSION_KHR,
                                                1,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                                EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, kConfig.data(), &config, 1, &found) != EGL_TRUE || found == 0) return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
}

}  // namespace

struct EglContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Handles() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    }
};

EglContext::EglContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;
EglContext::~EglContext() = default;

Expected<EglContext> EglContext::create() {
    for (const EGLDisplay display : candidates()) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) continue;
        if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) continue;
        if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) continue;
        auto handles = std::make_unique<Handles>();
        handles->display = display;
        handles->context = coreContext(display);
        if (handles->context == EGL_NO_CONTEXT) continue;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles->context) == EGL_TRUE) {
            return EglContext(std::move(handles));
        }
    }
    return unexpected(
        "no OpenGL 4.1 without a screen was found on this computer: install the packages libegl1 and libgl1-mesa-dri, "
        "which draw without a graphics card");
}

}  // namespace tactooth
