// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"

#include <QDialog>

#include <array>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace burin {

class ChoiceBox;
class Notice;
class QuantityField;

/// A value of both paths, and the second minus the first. "–" if there is no value.
struct ComparedValue {
    QString first, second, difference;
};

/// What the dialog shows, as text.
struct ComparisonState {
    QStringList versions;
    int version = 0;
    double tolerance = 0.0; ///< mm
    LengthUnit unit = LengthUnit::millimetre;
    bool known = false; ///< whether both paths are compared and the values valid
    ComparedValue cutting, plunging, air, points, arcs, time, largest, mean, farther;
    bool deviates = false; ///< whether there is a largest deviation
    QString news;          ///< why there are no values or deviations yet; empty if there are
    bool problem = false;  ///< whether `news` is an error
};

/// A modeless dialog that shows the values of two paths side by side. Its object name is "comparisonDialog"; it
/// contains "comparedVersion", "comparedTolerance", "largestFirst", "largestSecond", "comparisonNotice".
class ComparisonDialog final : public QDialog {
    Q_OBJECT
public:
    explicit ComparisonDialog(QWidget* parent);
    void setState(const ComparisonState& state);

signals:
    void versionChosen(int place);
    void toleranceEdited(double tolerance); ///< mm
    void largestRequested(bool ofSecond);   ///< the user asked to see it in the view

private:
    using Member = ComparedValue ComparisonState::*;
    struct Row {
        Member value = nullptr;
        std::array<QLabel*, 3> cells{}; ///< first, second, difference
    };
    void addRow(QGridLayout& grid, const QString& title, const char* name, Member value);
    void addLargest(QGridLayout& grid);

    ChoiceBox* version_ = nullptr;
    QuantityField* tolerance_ = nullptr;
    std::array<QPushButton*, 2> largest_{};
    std::vector<Row> rows_;
    Notice* notice_ = nullptr;
};

} // namespace burin
