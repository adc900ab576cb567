// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/quantity_field.h"

namespace burin {

/// A field for a length: in mm internally, displayed in mm or inches.
class LengthField final : public QuantityField {
    Q_OBJECT
public:
    explicit LengthField(QWidget* parent = nullptr) : QuantityField(Quantity::length, parent) {}
};

} // namespace burin
