// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QPushButton;
class QToolButton;

namespace burin {

class QuantityField;

/// The segments of a holder, one per row, from its face upwards: lower and upper diameter, length. Object names of the
/// fields: "segmentLower0", "segmentUpper0", "segmentLength0", "removeSegment0", …
class SegmentTable final : public QWidget {
    Q_OBJECT
public:
    explicit SegmentTable(QWidget* parent = nullptr);
    void showSegments(const std::vector<HolderSegment>& segments); ///< emits no signal
    void setReadOnly(bool readOnly);
    void setUnit(LengthUnit unit);

signals:
    void edited(const std::vector<HolderSegment>& segments); ///< by the user

private:
    struct Row {
        QuantityField *lower, *upper, *length;
        QToolButton* remove;
    };
    QuantityField* makeField(const char* name, const QString& label, double HolderSegment::*value);
    void addRow();
    void removeRow();
    void layOutEntry();
    void removeSegment(std::size_t row);
    void addSegment();

    QGridLayout* grid_;
    QPushButton* add_;
    std::vector<Row> rows_;
    std::vector<HolderSegment> segments_;
    LengthUnit unit_ = LengthUnit::millimetre;
    bool readOnly_ = false;
};

} // namespace burin
