// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/dialogs/preferences.h"
#include "ui/workbench/axis_tuner.h"
#include "ui/workbench/device_tester.h"
#include "ui/workbench/view_device.h"

#include <QDialog>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace burin {

class DeviceGains;
class FieldRow;
class Notice;
class QuantityField;
class RowList;

/// Lists the styluses found and the drivers whose library is missing; tests a device before it is used for a job, and
/// edits its force rendering.
class DeviceDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param styluses, tester, tuner, view, settings outlive the dialog
    DeviceDialog(StylusController& styluses, DeviceTester& tester, AxisTuner& tuner, ViewDevice& view,
                 UserSettings& settings, QWidget* parent);
    ~DeviceDialog() override; ///< ends a test

signals:
    void feltEdited();       ///< share of the cutting force or friction; already stored
    void gainsEdited();      ///< of any device; already stored
    void stockLayerEdited(); ///< already stored

private:
    void layOut();
    QuantityField* addShare(QBoxLayout& column, const QString& label, const char* name, double FeltCutting::*value,
                            const QString& toolTip);
    void addStockDistance(QBoxLayout& column);
    void addGains(QBoxLayout& column);
    void showFelt();
    void keepFelt();
    void showState();
    void showRows();
    void showTest();
    const StylusController::Choice* current() const;
    void choose(int row);
    void testOrStop();
    void moveViewOrNot();
    void assignAxes();
    void showUses();

    StylusController& styluses_;
    DeviceTester& tester_;
    AxisTuner& tuner_;
    ViewDevice& view_;
    UserSettings& settings_;
    RowList* list_ = nullptr;
    QLabel *limits_ = nullptr, *figures_ = nullptr;
    QuantityField *force_ = nullptr, *share_ = nullptr, *friction_ = nullptr, *assist_ = nullptr;
    QPushButton *test_ = nullptr, *use_ = nullptr, *moveView_ = nullptr, *axes_ = nullptr;
    DeviceGains* gains_ = nullptr;
    Notice* notice_ = nullptr;
    int row_ = 0;
    double pushed_ = 0.0; ///< N
    FeltCutting felt_;    ///< of the selected device
};

} // namespace burin
