// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <memory>

namespace burin {

/// An OpenGL context of this thread that draws without a display. Current from `make` on, until it is let go of or
/// destroyed.
class OffscreenContext {
public:
    /// Errors: notSupported with what EGL lacks.
    static Result<OffscreenContext> make(int width, int height);
    ~OffscreenContext();
    void makeCurrent();
    void release(); ///< none is current then: others may be made so
    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;

private:
    struct Handles;
    explicit OffscreenContext(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

} // namespace burin
