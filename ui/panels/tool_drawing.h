// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "ui/theme/length_unit.h"

#include <QPainterPath>
#include <QWidget>

#include <optional>

namespace burin {

/// A side view of a tool, to scale, tip down: flutes, shank and holder in their colours, with its height dimensions.
class ToolDrawing : public QWidget {
    Q_OBJECT
public:
    explicit ToolDrawing(QWidget* parent = nullptr);
    void setTool(const std::optional<Tool>& tool);
    void setUnit(LengthUnit unit);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintHeights(QPainter& painter, double left) const;
    double scale() const;              ///< pixels per mm
    double level(double height) const; ///< pixels from the top for a height above the tip, mm

    std::optional<Tool> tool_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

/// The outline of the flutes, x across and y up from the tip, mm.
QPainterPath fluteOutline(const Cutter& cutter);
/// The same of what is hollow within them, in a section through the axis.
QPainterPath hollowOutline(const Cutter& cutter);

} // namespace burin
