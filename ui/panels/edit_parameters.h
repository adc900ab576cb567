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
    EditField field; ///< core's: key, value and range, in the inner unit
    QString label, toolTip;
    Quantity quantity = Quantity::length; ///< of a number
    bool drawn = false;                   ///< it may be drawn in the view
    glm::dvec3 zero{0.0};                 ///< mm, setup frame: what a place is shown from; of a single coordinate, in x
    QString text{};                       ///< a moment, a stretch or places in words; empty for what has a field
};

/// Every parameter of an edit, in order; none for one that has none.
/// @param zero  mm, of the program, in the setup frame
/// @param takes  whose names and times are told
std::vector<EditParameter> parametersOf(const EditParameters& edit, const glm::dvec3& zero,
                                        const std::vector<TakeInfo>& takes = {});

} // namespace burin
