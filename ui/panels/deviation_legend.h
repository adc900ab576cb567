// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_scale.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <optional>

namespace burin {

/// The scale of the deviation map, with excess stock at the top: its colours, the values at the band limits, the range
/// within tolerance, and a pointer at the value under the cursor.
class DeviationLegend : public QWidget {
    Q_OBJECT
public:
    explicit DeviationLegend(QWidget* parent = nullptr);
    void setTolerance(const DeviationTolerance& tolerance);
    void setUnit(LengthUnit unit);
    /// @param deviation mm; std::nullopt: no pointer
    void setPointer(std::optional<double> deviation);
    /// The position of a deviation (mm) in the widget, device-independent pixels from its top.
    double heightOf(double deviation) const;

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double heightAt(double position) const;
    void paintBar(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintSides(QPainter& painter) const;
    void paintPointer(QPainter& painter) const;
    void paintUnmeasured(QPainter& painter) const;
    void describe();

    DeviationScale scale_{DeviationTolerance{}};
    LengthUnit unit_ = LengthUnit::millimetre;
    std::optional<double> pointer_;
};

} // namespace burin
