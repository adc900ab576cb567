// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/calibrated_materials.h"

#include <QDialog>

#include <vector>

class QLabel;
class QPushButton;

namespace burin {

class ChoiceBox;
class NamedSwitch;
class Notice;

/// Fits K and Kr to a file of measured forces, shows what came of it with its confidence, and keeps it where the user
/// says so.
class CalibrationDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param materials those that a new one may take its other values from
    /// @param like      the first of these that is offered
    CalibrationDialog(const std::vector<Property>& materials, const std::string& like, QWidget* parent);

    /// What the user keeps, once the dialog was accepted.
    const std::vector<Property>& calibrated() const noexcept { return calibrated_; }

private:
    void layOut();
    void chooseFile();
    void fit();
    CalibrationRequest request() const;

    std::vector<std::string> ids_; ///< of what `like_` offers, from its second entry on
    std::vector<Property> calibrated_;
    QString file_;
    bool onWorkpiece_ = false;
    ChoiceBox *law_ = nullptr, *projection_ = nullptr, *like_ = nullptr;
    NamedSwitch* workpiece_ = nullptr;
    QPushButton *choose_ = nullptr, *keep_ = nullptr;
    QLabel* result_ = nullptr;
    Notice* notice_ = nullptr;
};

} // namespace burin
