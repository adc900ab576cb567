// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSpinBox>

namespace burin {

/// A field for a whole number without a unit; it looks as QuantityField does.
class CountField final : public QSpinBox {
public:
    CountField(int low, int high, int value, QWidget* parent) : QSpinBox(parent) {
        setRange(low, high);
        setValue(value);
        setButtonSymbols(QAbstractSpinBox::NoButtons);
        setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
};

} // namespace burin
