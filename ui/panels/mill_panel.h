// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// Milling: the main button first, then how the tool follows the hand, the takes, and how to mill with mouse and
/// keyboard.
class MillPanel : public QWidget {
    Q_OBJECT
public:
    explicit MillPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const MillState& state); ///< never emits

signals:
    void millModeToggled(bool on);
    void stylusChosen(int index); ///< index in MillState::styluses
    void undoStrokeRequested();
    void redoStrokeRequested();
    void depthRuleChosen(burin::DepthChoice rule);
    void depthOfCutEdited(double millimetres);
    void pressEdited(double millimetres);
    void penRuleChosen(burin::PenChoice rule);
    void sinkSpeedEdited(double millimetresPerSecond);
    void speedEdited(double millimetresPerSecond);
    void rasterChosen(bool on);
    void stepOverEdited(double millimetres);
    void repeatRequested(burin::RepeatChoice how);
    void showMeRequested();
    void takeRemovalRequested(qint64 take);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
