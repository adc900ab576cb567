// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"
#include "ui/panels/quantity.h"

#include <functional>
#include <vector>

namespace burin {

/// One number of an edit, as a panel shows it.
struct EditParameter {
    QString key; ///< as in the edit's JSON: "tolerance_mm"
    QString label, toolTip;
    Quantity quantity = Quantity::length;
    double low = 0.0, high = 0.0; ///< what core allows, in the inner unit
    std::function<double(const EditParameters&)> value;
    std::function<void(EditParameters&, double)> setValue;
};

/// Every number of a kind of edit, in order; none for one that has none.
std::vector<EditParameter> parametersOf(const EditParameters& edit);

} // namespace burin
