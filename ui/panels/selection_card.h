// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/path_states.h"

#include <QFrame>

class QPushButton;
class QToolButton;

namespace burin {

class ChoiceBox;
class ElidedLabel;

/// What is chosen of the path in the view, and what the pointer does to it.
class SelectionCard : public QFrame {
    Q_OBJECT
public:
    explicit SelectionCard(QWidget* parent = nullptr);
    void setState(const PathState& state); ///< never emits

signals:
    void dragChosen(burin::DragChoice drag);
    void drawingWanted(bool wanted);
    void cleared();

private:
    ElidedLabel* chosen_;
    QToolButton* clear_;
    ChoiceBox* drag_;
    QPushButton* draw_;
};

} // namespace burin
