// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/panel_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Force, removal rate, haptic rate and p99.9 as bars and numbers with their units.
class Meters : public QWidget {
    Q_OBJECT
public:
    explicit Meters(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const MeterState& state);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
