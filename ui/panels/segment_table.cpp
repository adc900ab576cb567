// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/segment_table.h"

#include "core/tool/tool_ranges.h"
#include "ui/panels/buttons.h"
#include "ui/panels/quantity_field.h"

#include <QGridLayout>

namespace burin {

namespace {

constexpr int segmentFieldWidth = 116;   // pixels
constexpr double shortestLength = 0.001; // mm
constexpr HolderSegment usualSegment{40.0, 40.0, 30.0};
enum SegmentColumn { lowerColumn, upperColumn, lengthColumn, removeColumn, segmentColumns };

} // namespace

SegmentTable::SegmentTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    setObjectName(QStringLiteral("holderSegments"));
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(6);
    grid_->setColumnStretch(removeColumn, 1);
    add_ = makeButton(tr("Add a segment"), QStringLiteral("add"), QStringLiteral("addSegmentButton"), this);
    add_->setToolTip(tr("On top, as wide as the one below"));
    add_->setAutoDefault(false); // Enter is handled by the fields
    connect(add_, &QPushButton::clicked, this, &SegmentTable::addSegment);
    layOutEntry();
}

void SegmentTable::showSegments(const std::vector<HolderSegment>& segments) {
    segments_ = segments;
    while (rows_.size() > segments.size()) removeRow();
    while (rows_.size() < segments.size()) addRow();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        rows_[i].lower->showValue(segments[i].lowerDiameter);
        rows_[i].upper->showValue(segments[i].upperDiameter);
        rows_[i].length->showValue(segments[i].length);
    }
    layOutEntry();
    setReadOnly(readOnly_);
}

void SegmentTable::setReadOnly(bool readOnly) {
    readOnly_ = readOnly;
    for (const Row& row : rows_) {
        for (QuantityField* field : {row.lower, row.upper, row.length}) field->setReadOnly(readOnly);
        row.remove->setVisible(!readOnly);
    }
    add_->setVisible(!readOnly);
}

void SegmentTable::setUnit(LengthUnit unit) {
    unit_ = unit;
    for (const Row& row : rows_)
        for (QuantityField* field : {row.lower, row.upper, row.length}) field->setLengthUnit(unit);
}

QuantityField* SegmentTable::makeField(const char* name, const QString& label, double HolderSegment::*value) {
    const std::size_t at = rows_.size();
    auto* field = new QuantityField(Quantity::length, this);
    field->setObjectName(QLatin1String(name) + QString::number(at));
    field->setAccessibleName(label);
    field->setToolTip(label);
    field->setFixedWidth(segmentFieldWidth);
    field->limit(shortestLength, tool_range::length.high);
    field->setLengthUnit(unit_);
    connect(field, &QuantityField::valueEdited, this, [this, at, value](double entered) {
        segments_[at].*value = entered;
        emit edited(std::vector<HolderSegment>(segments_));
    });
    return field;
}

void SegmentTable::addRow() {
    const int number = static_cast<int>(rows_.size()) + 1;
    Row row{makeField("segmentLower", tr("Segment %1, diameter below").arg(number), &HolderSegment::lowerDiameter),
            makeField("segmentUpper", tr("Segment %1, diameter above").arg(number), &HolderSegment::upperDiameter),
            makeField("segmentLength", tr("Segment %1, length").arg(number), &HolderSegment::length), nullptr};
    row.remove = makeIconButton(QStringLiteral("remove"), tr("Delete segment %1").arg(number),
                                QStringLiteral("removeSegment%1").arg(number - 1), this);
    grid_->addWidget(row.lower, number - 1, lowerColumn);
    grid_->addWidget(row.upper, number - 1, upperColumn);
    grid_->addWidget(row.length, number - 1, lengthColumn);
    grid_->addWidget(row.remove, number - 1, removeColumn, Qt::AlignLeft);
    connect(row.remove, &QToolButton::clicked, this, [this, at = rows_.size()] { removeSegment(at); });
    rows_.push_back(row);
}

void SegmentTable::removeRow() {
    const Row& row = rows_.back();
    for (QWidget* widget : std::initializer_list<QWidget*>{row.lower, row.upper, row.length, row.remove}) {
        grid_->removeWidget(widget);
        widget->hide();
        widget->setObjectName({}); // it must no longer be found by name
        widget->deleteLater();     // it may be the widget that was clicked
    }
    rows_.pop_back();
}

void SegmentTable::layOutEntry() {
    grid_->removeWidget(add_);
    grid_->addWidget(add_, static_cast<int>(rows_.size()), lowerColumn, 1, segmentColumns, Qt::AlignLeft);
}

void SegmentTable::removeSegment(std::size_t row) {
    if (readOnly_ || row >= segments_.size()) return;
    std::vector<HolderSegment> segments = segments_;
    segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(row));
    add_->setFocus(); // the last row is removed
    showSegments(segments);
    emit edited(segments);
}

void SegmentTable::addSegment() {
    if (readOnly_) return;
    std::vector<HolderSegment> segments = segments_;
    HolderSegment next = usualSegment;
    if (!segments.empty()) next.lowerDiameter = next.upperDiameter = segments.back().upperDiameter;
    segments.push_back(next);
    showSegments(segments);
    rows_.back().length->setFocus();
    emit edited(segments);
}

} // namespace burin
