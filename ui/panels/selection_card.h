// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/path_states.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace burin {

class ChoiceBox;
class ElidedLabel;
class LengthField;

/// The part of the path that is selected in the view, and what dragging it with the pointer changes.
class SelectionCard : public QFrame {
    Q_OBJECT
public:
    explicit SelectionCard(QWidget* parent = nullptr);
    void setState(const PathState& state, LengthUnit unit);        ///< never emits
    void setStylus(const StylusEditState& state, LengthUnit unit); ///< never emits

signals:
    void dragChosen(burin::DragChoice drag);
    void drawingRequested(bool wanted);
    void cleared();
    void stylusRequested(bool wanted);
    void stylusReachEdited(double reach); ///< mm

private:
    void addStylus(QVBoxLayout& column);
    void showTimelinesPlace(const PathState& state, LengthUnit unit);

    ElidedLabel *chosen_, *shown_; ///< the selection, and the point at the timeline's time
    QToolButton* clear_;
    ChoiceBox* drag_;
    QPushButton *draw_, *stylus_;
    LengthField* reach_;
    QWidget* reachRow_ = nullptr;
    ElidedLabel* stylusText_;
};

} // namespace burin
