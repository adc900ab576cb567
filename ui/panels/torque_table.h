// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace burin {

class QuantityField;

/// The torque of a spindle over its speed: one row per point, in ascending order of speed, and one to enter another
/// point. No two points have the same speed; an entry with a speed that exists already is rejected with a message
/// below. Object names of the fields: "torqueSpeed" and "torqueValue" with the row's number from 0, "newTorqueSpeed",
/// "newTorqueValue".
class TorqueTable final : public QWidget {
    Q_OBJECT
public:
    explicit TorqueTable(QWidget* parent = nullptr);
    /// Never emits. @param points in ascending order of speed
    void showPoints(const std::vector<SpindlePoint>& points);
    void setReadOnly(bool readOnly);

signals:
    void edited(const std::vector<burin::SpindlePoint>& points); ///< by the user; in ascending order of speed

private:
    struct Row {
        QuantityField* speed = nullptr;
        QuantityField* torque = nullptr;
        QToolButton* remove = nullptr;
    };
    void addRow();
    void removeRow();
    void layOutEntry();                                ///< below the rows
    void changeSpeed(std::size_t row, double speed);   ///< 1/min
    void changeTorque(std::size_t row, double torque); ///< N m
    void removePoint(std::size_t row);
    void addPoint();
    void followEntry();
    bool hasSpeed(double speed) const; ///< whether a point has this speed; if so, the message says so
    void refuse(const QString& sentence);

    std::vector<SpindlePoint> points_;
    std::vector<Row> rows_;
    QGridLayout* grid_;
    QuantityField *newSpeed_, *newTorque_;
    QPushButton* add_;
    QLabel* message_;
    bool readOnly_ = false;
};

} // namespace burin
