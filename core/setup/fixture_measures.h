// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_kind.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace burin {

/// A view of a fixture in its own frame.
enum class FixtureView : std::uint8_t {
    side, ///< from -Y: X to the right, Z up
    top   ///< from +Z: X to the right, Y up
};

/// Where a drawing shows a parameter of a fixture: between two points, in one of the views.
struct FixtureMeasure {
    FixtureView view = FixtureView::side;
    glm::dvec3 from{0.0}, to{0.0}; ///< mm, own frame; the parameter's value apart, in the plane of the view
};

/// Returns the measures of all parameters, in the order of the kind's parameters.
std::vector<FixtureMeasure> measuresOf(const FixtureDesign& design);

} // namespace burin
