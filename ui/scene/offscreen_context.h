// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <memory>

namespace burin {

/// An OpenGL context of the calling thread that renders without a display. It is current from `make` until it is
/// released or destroyed.
class OffscreenContext {
public:
    /// Errors: notSupported, with the missing EGL feature.
    static Result<OffscreenContext> make(int width, int height);
    ~OffscreenContext();
    void makeCurrent();
    void release(); ///< afterwards no context is current, so another one can be made current
    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;

private:
    struct Handles;
    explicit OffscreenContext(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

} // namespace burin
