// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <optional>

namespace burin {

/// The position of the hand when a stroke begins, and its direction of motion.
struct HandStart {
    glm::dvec3 tip{0.0};       ///< mm, setup frame
    glm::dvec3 direction{0.0}; ///< horizontal, unit length
};

/// Taken from the recording, which no edit changes, as long as the stroke lies where the hand was; for a stroke that
/// was moved, rotated or copied, from the stroke itself, over the same length. Empty if it goes straight up or down.
std::optional<HandStart> startOf(const PathStroke& stroke, const PathUnderEdit& state);

} // namespace burin
