// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"
#include "ui/panels/quantity.h"

#include <vector>

namespace burin {

/// One number of an edit, as a panel shows it.
struct EditParameter {
    EditNumber number; ///< core's: key, value and range, in the inner unit
    QString label, toolTip;
    Quantity quantity = Quantity::length;
};

/// Every number of an edit, in order; none for one that has none.
std::vector<EditParameter> parametersOf(const EditParameters& edit);

} // namespace burin
