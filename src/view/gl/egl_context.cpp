// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include "view/gl/messages.h"

namespace tactooth {

namespace {

/// Only Mesa obeys LIBGL_ALWAYS_SOFTWARE; other drivers ignore it.
bool softwareIsWanted() {
    const char* const value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    return value != nullptr && *value != '\0' && std::string_view(value) != "0" && std::string_view(value) != "false";
}

bool drawsBySoftware(EGLDeviceEXT device) {
    const char* const extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr && std::string_view(extensions).find("EGL_MESA_device_software") != std::string::npos;
}

/// Mesa's surfaceless platform, on a graphics card with a Mesa driver or in software.
void addSurfaceless(std::vector<EGLDisplay>& displays) {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return;
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
}

/// The graphics cards, including those with vendor drivers.
void addCards(std::vector<EGLDisplay>& displays) {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) return;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) return;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) return;
    for (const EGLDeviceEXT device : std::span(devices).first(static_cast<std::size_t>(count))) {
        if (!drawsBySoftware(device)) {
            displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        }
    }
}

/// Every EGL display that can draw without a screen.
std::vector<EGLDisplay> candidates() {
    std::vector<EGLDisplay> displays;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
        addSurfaceless(displays);
        if (!softwareIsWanted()) addCards(displays);
    }
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

    /// A current context on `display`; null if it has no usable one.
    static std::unique_ptr<Handles> on(EGLDisplay display);
    [[nodiscard]] bool makeCurrent() const {
        return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
    }

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

std::unique_ptr<EglContext::Handles> EglContext::Handles::on(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return nullptr;
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) return nullptr;
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return nullptr;
    auto handles = std::make_unique<Handles>();
    handles->display = display;
    handles->context = coreContext(display);
    if (handles->context == EGL_NO_CONTEXT || !handles->makeCurrent()) return nullptr;
    return handles;
}

Expected<EglContext> EglContext::create() {
    std::unique_ptr<Handles> found;  // a software context, kept until a better one is found
    for (const EGLDisplay display : candidates()) {
        auto handles = Handles::on(display);
        if (!handles) continue;
        const bool isCard = !isSoftwareRenderer(rendererName());
        if (isCard || !found) found = std::move(handles);
        if (isCard) break;
    }
    if (!found) found = Handles::on(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    // Make it current again: the release of another context leaves no context current.
    if (found && found->makeCurrent()) return EglContext(std::move(found));
    return unexpected(msg::kNoOffscreenOpenGl);
}

std::string rendererName() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

bool isSoftwareRenderer(std::string_view rendererName) {
    constexpr std::array<std::string_view, 4> kNames = {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"};
    return std::any_of(kNames.begin(), kNames.end(),
                       [&](std::string_view name) { return rendererName.find(name) != std::string_view::npos; });
}

}  // namespace tactooth
