// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"
#include "core/recording/sample.h"
#include "ui/panels/quantity.h"

#include <vector>

namespace burin {

/// One parameter of an edit, as a panel shows it.
struct EditParameter {
    EditField field; ///< from core: key, value and range, in the internal unit
    QString label, toolTip;
    Quantity quantity = Quantity::length; ///< of a number
    bool drawn = false;                   ///< whether it can be drawn in the view
    glm::dvec3 zero{0.0}; ///< mm, setup frame: the origin for displayed positions; for a single coordinate, in x
    QString text{};       ///< description of a moment, an interval or points; empty for parameters with a field
};

/// Returns all parameters of an edit, in order; empty if it has none.
/// @param zero program zero, mm, setup frame
/// @param takes whose names and times are shown
std::vector<EditParameter> parametersOf(const EditParameters& edit, const glm::dvec3& zero,
                                        const std::vector<TakeInfo>& takes = {});

} // namespace burin
