// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/offscreen_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

namespace burin {

struct OffscreenContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
OffscreenContext::~OffscreenContext() = default;
void OffscreenContext::makeCurrent() {
    eglMakeCurrent(handles_->display, handles_->surface, handles_->surface, handles_->context);
}
void OffscreenContext::release() {
    eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

Result<OffscreenContext> OffscreenContext::make(int width, int height) {
    const auto lacking = [](const char* what) {
        return Error{ErrorCode::notSupported, "a picture without a display", "a machine with Mesa's EGL", what};
    };
    auto handles = std::make_unique<Handles>();
    handles->display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handles->display == EGL_NO_DISPLAY || eglInitialize(handles->display, nullptr, nullptr) == EGL_FALSE)
        return lacking("no surfaceless display");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return lacking("no desktop OpenGL");

    constexpr std::array<EGLint, 13> wanted{EGL_SURFACE_TYPE,
                                            EGL_PBUFFER_BIT,
                                            EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT,
                                            EGL_RED_SIZE,
                                            8,
                                            EGL_GREEN_SIZE,
                                            8,
                                            EGL_BLUE_SIZE,
                                            8,
                                            EGL_DEPTH_SIZE,
                                            24,
                                            EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(handles->display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        return lacking("no fitting configuration");
    constexpr std::array<EGLint, 7> version{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    handles->context = eglCreateContext(handles->display, config, EGL_NO_CONTEXT, version.data());
    if (handles->context == EGL_NO_CONTEXT) return lacking("no OpenGL 3.2 core profile");
    const std::array<EGLint, 5> size{EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    handles->surface = eglCreatePbufferSurface(handles->display, config, size.data());
    if (handles->surface == EGL_NO_SURFACE) return lacking("no off-screen surface");
    if (eglMakeCurrent(handles->display, handles->surface, handles->surface, handles->context) == EGL_FALSE)
        return lacking("the context can't be made current");
    return OffscreenContext(std::move(handles));
}

} // namespace burin
