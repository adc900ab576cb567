// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Force, removal rate and position as bars and numbers with their units; when unfolded, also the haptic loop's
/// statistics.
class Meters : public QWidget {
    Q_OBJECT
public:
    explicit Meters(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const MeterState& state);
    void setFolded(bool folded); ///< never emits
    bool folded() const;

signals:
    void foldedChanged(bool folded); ///< by the user

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
