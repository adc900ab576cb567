// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/torque_table.h"

#include "core/machine/machine_ranges.h"
#include "ui/panels/buttons.h"
#include "ui/panels/quantity_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace burin {

namespace {

constexpr int torqueFieldWidth = 116; // pixels
enum TorqueColumn { speedColumn, torqueColumn, buttonColumn, torqueColumns };

QuantityField* makeTorqueField(Quantity quantity, const QString& name, const QString& label, QWidget* parent) {
    auto* field = new QuantityField(quantity, parent);
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setToolTip(label);
    field->setFixedWidth(torqueFieldWidth);
    return field;
}

} // namespace

TorqueTable::TorqueTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    setObjectName(QStringLiteral("spindle_torque"));
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(6);
    grid_->setColumnStretch(buttonColumn, 1);
    newSpeed_ = makeTorqueField(Quantity::rotation, QStringLiteral("newTorqueSpeed"), tr("Speed of a new point"), this);
    newSpeed_->limit(0.0, machine_range::spindleSpeed.high);
    newTorque_ = makeTorqueField(Quantity::torque, QStringLiteral("newTorqueValue"), tr("Torque at that speed"), this);
    newTorque_->limit(0.0, machine_range::spindleTorque.high);
    add_ = makeButton(tr("Add"), QStringLiteral("add"), QStringLiteral("addTorqueButton"), this);
    add_->setAutoDefault(false); // Enter is handled by the fields
    message_ = new QLabel(this);
    message_->setObjectName(QStringLiteral("torqueMessage"));
    message_->setProperty("look", "message");
    message_->setWordWrap(true);
    message_->hide();
    layOutEntry();
    connect(newSpeed_, &QuantityField::valueEdited, this, [this] {
        message_->hide();
        followEntry();
    });
    connect(newTorque_, &QuantityField::valueEdited, this, &TorqueTable::followEntry);
    connect(newTorque_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &TorqueTable::addPoint,
            Qt::QueuedConnection); // once the number is entered
    connect(add_, &QPushButton::clicked, this, &TorqueTable::addPoint);
    followEntry();
}

void TorqueTable::showPoints(const std::vector<SpindlePoint>& points) {
    points_ = points;
    while (rows_.size() > points.size()) removeRow();
    while (rows_.size() < points.size()) addRow();
    for (std::size_t i = 0; i < points.size(); ++i) {
        rows_[i].speed->showValue(points[i].speed);
        rows_[i].torque->showValue(points[i].torque);
    }
    layOutEntry();
    setReadOnly(readOnly_);
}

void TorqueTable::setReadOnly(bool readOnly) {
    readOnly_ = readOnly;
    for (const Row& row : rows_) {
        row.speed->setReadOnly(readOnly);
        row.torque->setReadOnly(readOnly);
        row.remove->setVisible(!readOnly);
    }
    newSpeed_->setVisible(!readOnly);
    newTorque_->setVisible(!readOnly);
    add_->setVisible(!readOnly);
    if (readOnly) message_->hide();
}

void TorqueTable::addRow() {
    const std::size_t at = rows_.size();
    const int number = static_cast<int>(at);
    Row row;
    row.speed = makeTorqueField(Quantity::rotation, QStringLiteral("torqueSpeed%1").arg(number),
                                tr("Speed of point %1").arg(number + 1), this);
    row.speed->limit(machine_range::spindleTorque.low, machine_range::spindleSpeed.high); // above 0
    row.torque = makeTorqueField(Quantity::torque, QStringLiteral("torqueValue%1").arg(number),
                                 tr("Torque of point %1").arg(number + 1), this);
    row.torque->limit(machine_range::spindleTorque.low, machine_range::spindleTorque.high);
    row.remove = makeIconButton(QStringLiteral("remove"), tr("Delete point %1").arg(number + 1),
                                QStringLiteral("removeTorque%1").arg(number), this);
    grid_->addWidget(row.speed, number, speedColumn);
    grid_->addWidget(row.torque, number, torqueColumn);
    grid_->addWidget(row.remove, number, buttonColumn, Qt::AlignLeft);
    connect(row.speed, &QuantityField::valueEdited, this, [this, at](double speed) { changeSpeed(at, speed); });
    connect(row.torque, &QuantityField::valueEdited, this, [this, at](double torque) { changeTorque(at, torque); });
    connect(row.remove, &QToolButton::clicked, this, [this, at] { removePoint(at); });
    QWidget* before = rows_.empty() ? nullptr : rows_.back().remove;
    if (before != nullptr) setTabOrder(before, row.speed);
    setTabOrder(row.speed, row.torque);
    setTabOrder(row.torque, row.remove);
    setTabOrder(row.remove, newSpeed_);
    rows_.push_back(row);
}

void TorqueTable::removeRow() {
    for (QWidget* widget : {static_cast<QWidget*>(rows_.back().speed), static_cast<QWidget*>(rows_.back().torque),
                            static_cast<QWidget*>(rows_.back().remove)}) {
        grid_->removeWidget(widget);
        widget->hide();
        widget->setObjectName({}); // it must no longer be found by name
        widget->deleteLater();     // it may be the widget that was clicked
    }
    rows_.pop_back();
}

void TorqueTable::layOutEntry() {
    for (QWidget* widget : {static_cast<QWidget*>(newSpeed_), static_cast<QWidget*>(newTorque_),
                            static_cast<QWidget*>(add_), static_cast<QWidget*>(message_)})
        grid_->removeWidget(widget);
    const int row = static_cast<int>(rows_.size());
    grid_->addWidget(newSpeed_, row, speedColumn);
    grid_->addWidget(newTorque_, row, torqueColumn);
    grid_->addWidget(add_, row, buttonColumn, Qt::AlignLeft);
    grid_->addWidget(message_, row + 1, speedColumn, 1, torqueColumns);
}

bool TorqueTable::hasSpeed(double speed) const {
    return std::ranges::find(points_, speed, &SpindlePoint::speed) != points_.end();
}

void TorqueTable::refuse(const QString& sentence) {
    message_->setText(sentence);
    message_->show();
}

void TorqueTable::changeSpeed(std::size_t row, double speed) {
    message_->hide();
    if (hasSpeed(speed)) {
        refuse(tr("There is a point at %1 already. The value stays.").arg(quantityText(speed, Quantity::rotation, {})));
        rows_[row].speed->showValue(points_[row].speed);
        return;
    }
    const bool entered = rows_[row].speed->hasFocus(); // committed by Enter rather than by leaving the field
    std::vector<SpindlePoint> points = points_;
    points[row].speed = speed;
    std::ranges::sort(points, {}, &SpindlePoint::speed);
    showPoints(points);
    const auto moved =
        static_cast<std::size_t>(std::ranges::find(points, speed, &SpindlePoint::speed) - points.begin());
    if (entered) rows_[moved].speed->setFocus();
    followEntry();
    emit edited(points);
}

void TorqueTable::changeTorque(std::size_t row, double torque) {
    std::vector<SpindlePoint> points = points_;
    points[row].torque = torque;
    showPoints(points);
    emit edited(points);
}

void TorqueTable::removePoint(std::size_t row) {
    if (readOnly_ || row >= points_.size()) return;
    message_->hide();
    std::vector<SpindlePoint> points = points_;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(row));
    if (row + 1 == points_.size()) newSpeed_->setFocus(); // its row is removed
    showPoints(points);
    followEntry();
    emit edited(points);
}

void TorqueTable::addPoint() {
    if (readOnly_ || !(newSpeed_->value() > 0.0) || newTorque_->value() < machine_range::spindleTorque.low) return;
    if (hasSpeed(newSpeed_->value())) {
        refuse(tr("There is a point at %1 already; change that one.")
                   .arg(quantityText(newSpeed_->value(), Quantity::rotation, {})));
        return;
    }
    std::vector<SpindlePoint> points = points_;
    points.push_back({newSpeed_->value(), newTorque_->value()});
    std::ranges::sort(points, {}, &SpindlePoint::speed);
    newSpeed_->setFocus(); // for the next one
    newSpeed_->showValue(0.0);
    newTorque_->showValue(0.0);
    newSpeed_->selectAll();
    showPoints(points);
    followEntry();
    emit edited(points);
}

void TorqueTable::followEntry() {
    const bool complete = newSpeed_->value() > 0.0 && newTorque_->value() >= machine_range::spindleTorque.low;
    enableUnless(add_, complete ? QString() : tr("Enter a speed and a torque above 0."),
                 tr("Add this point to the curve (Enter in the torque field)"));
}

} // namespace burin
