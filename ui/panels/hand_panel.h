// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"

#include <QWidget>

namespace burin {

/// How device motion is mapped to tool motion, the functions of the device's buttons, and the device's status.
class HandPanel : public QWidget {
    Q_OBJECT
public:
    explicit HandPanel(QWidget* parent = nullptr);
    void setState(const HandState& state); ///< never emits

signals:
    void clutchToggled(bool on);
    void recentreRequested();
    void alignmentRequested();      ///< aligns the device with the view
    void scaleEdited(double scale); ///< mm of the setup per mm of the device
    void rateToggled(bool on);
    // `button`: number of the button, from 1; 0: none.
    void clutchButtonChosen(int button);
    void levelButtonChosen(int button);
    void forceButtonChosen(int button);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
