// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <optional>

namespace burin {

/// Where the hand was when a stroke begins, and where it went from there.
struct HandStart {
    glm::dvec3 tip{0.0};       ///< mm, setup frame
    glm::dvec3 direction{0.0}; ///< level, of unit length
};

/// Of the recording, which no edit changes, as long as the stroke lies where the hand was; of a stroke that was moved,
/// turned or copied, its own, over the same length. Nothing where it goes straight up or down.
std::optional<HandStart> startOf(const PathStroke& stroke, const PathUnderEdit& state);

} // namespace burin
