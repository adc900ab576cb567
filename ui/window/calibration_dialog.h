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

/// Fits K and Kr to a file of measured forces, shows the result with its confidence, and keeps it on request.
class CalibrationDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param materials from which a new one may take its other values
    /// @param like      the one of these that is preselected
    CalibrationDialog(const std::vector<Property>& materials, const std::string& like, QWidget* parent);

    /// The materials that the user keeps; valid after the dialog was accepted.
    const std::vector<Property>& calibrated() const noexcept { return calibrated_; }

private:
    void layOut();
    void chooseFile();
    void fit();
    CalibrationRequest request() const;

    std::vector<std::string> ids_; ///< ids of the entries of `like_` from the second on
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
