// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/axis_tuner.h"

#include <QDialog>

#include <string>
#include <vector>

class QPushButton;
class QScrollArea;

namespace burin {

class AxisRows;
class Notice;

/// Assigns the axes and buttons of one device and calibrates them. Nothing is stored here: on acceptance, `kept` is
/// what the user wants.
class AxisDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param tuner outlives the dialog @param kept as StylusController::axisMap
    AxisDialog(AxisTuner& tuner, const StylusController::Choice& device, std::string kept, QWidget* parent);
    ~AxisDialog() override; ///< ends the reading

    /// The assignment as toJson has it; empty: the usual one.
    std::string kept() const;

private:
    void layOut();
    void build();
    void change(const AxisMap& map);
    void undo();
    void calibrateOrFinish();
    void noteMotion();
    void takeCalibration(const AxisMap& map);
    void tryAccept();
    void showState();

    AxisTuner& tuner_;
    std::string kept_;
    AxisMap map_;
    std::vector<AxisMap> earlier_; ///< for undo, the newest last
    AxisRows* rows_ = nullptr;
    QScrollArea* area_ = nullptr;
    Notice* notice_ = nullptr;
    QPushButton *calibrate_ = nullptr, *stop_ = nullptr, *undo_ = nullptr, *usual_ = nullptr, *keep_ = nullptr;
    QString fault_;           ///< why the assignment can't be kept; empty: it can
    QString unmeasured_;      ///< what the last calibration left as it was; empty: nothing
    std::vector<bool> moved_; ///< axes that were seen away from 0 before the ends were measured
};

} // namespace burin
