// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"

#include <QWidget>

namespace burin {

/// How a device's movements become the tool's, what its buttons do, and how it is doing.
class HandPanel : public QWidget {
    Q_OBJECT
public:
    explicit HandPanel(QWidget* parent = nullptr);
    void setState(const HandState& state); ///< never emits

signals:
    void clutchToggled(bool on);
    void recentreRequested();
    void alignmentRequested();      ///< with the view
    void scaleEdited(double scale); ///< mm of the setup per mm of the device
    void rateToggled(bool on);
    // A button's number, from 1; 0: none.
    void clutchButtonChosen(int button);
    void levelButtonChosen(int button);
    void forceButtonChosen(int button);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
