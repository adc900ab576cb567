// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Stock to leave on the part.
class AllowancePanel : public QWidget {
    Q_OBJECT
public:
    explicit AllowancePanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const AllowanceState& state); ///< never emits

signals:
    void allowanceEdited(double millimetres);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
