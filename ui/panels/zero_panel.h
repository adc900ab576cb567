// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The position of program zero, and the work offset of the control in which it is stored.
class ZeroPanel : public QWidget {
    Q_OBJECT
public:
    explicit ZeroPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const ZeroState& state); ///< never emits

signals:
    void zeroChosen(const burin::ProgramZero& zero);
    void pickRequested(bool wanted); ///< picking of a point in the view; false: stop picking

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
