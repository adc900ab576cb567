// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/workbench/score_controller.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace burin {

class ChoiceBox;
class Notice;

/// Shows the values of a take next to those of a reference chosen in the dialog, with a verdict on each. The controller
/// holds the choice and the scores; closing the dialog cancels the work and discards the scores. Its combo boxes are
/// "scoreTake" and "scoreReference"; its labels are "score_duration_s", "reference_duration_s", "verdict_duration_s"
/// and so on.
class ScoreDialog final : public QDialog {
    Q_OBJECT
public:
    ScoreDialog(ScoreController& score, const MillController& mill, const TaskRunner& tasks, LengthUnit unit,
                QWidget* parent);
    ~ScoreDialog() override;

private:
    struct Row {
        QLabel *own = nullptr, *reference = nullptr, *verdict = nullptr;
    };
    void layOut();
    void layOutRows(QGridLayout& grid);
    void layOutFoot();
    ChoiceBox* makeChoice(const char* name, const QString& label);
    void offerTakes();
    void choose();
    void showState();
    void showRow(ScoreValue value);
    void showProgress();

    ScoreController& score_;
    const MillController& mill_;
    LengthUnit unit_;
    ChoiceBox *take_ = nullptr, *reference_ = nullptr;
    std::array<Row, scoreValues> rows_;
    QCheckBox* drawn_ = nullptr;
    Notice* notice_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

} // namespace burin
