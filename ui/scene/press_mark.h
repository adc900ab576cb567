// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// Where pressing the button would move the tool, setup frame, mm.
struct PressMark {
    glm::dvec3 tip{0.0};               ///< position of the tip
    glm::dvec3 axis{0.0, 0.0, 1.0};    ///< unit, of the tool
    double radius = 0.0;               ///< of the cutter
    double depth = 0.0;                ///< of the tip below the workpiece's surface, along the axis
    std::optional<glm::dvec3> contact; ///< point where the cutter would touch the part; empty: it stays clear of it
    friend bool operator==(const PressMark&, const PressMark&) = default;
};

} // namespace burin
