// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/tool_drawing.h"

#include "core/tool/tool_solid.h"
#include "ui/panels/texts.h"
#include "ui/theme/colour.h"
#include "ui/theme/number_font.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin {

namespace {

constexpr double margin = 12.0, axisShare = 0.3; // position of the axis, share of the width
constexpr double labelSize = 0.88;

double widest(const Cutter& cutter) {
    double diameter = std::max(cutter.diameter, cutter.shankDiameter);
    for (const HolderSegment& segment : cutter.holder)
        diameter = std::max({diameter, segment.lowerDiameter, segment.upperDiameter});
    return diameter;
}

QPainterPath frustum(double bottom, double lowerDiameter, double top, double upperDiameter) {
    QPainterPath path;
    path.moveTo(-0.5 * lowerDiameter, bottom);
    path.lineTo(0.5 * lowerDiameter, bottom);
    path.lineTo(0.5 * upperDiameter, top);
    path.lineTo(-0.5 * upperDiameter, top);
    path.closeSubpath();
    return path;
}

/// Two cutting edges that wind up the flutes; a sketch, not the real helix.
QPainterPath edges(const Cutter& cutter) {
    QPainterPath path;
    const double radius = cutter.radius(), lead = 2.2 * cutter.diameter;
    for (double start = -lead; start < cutter.fluteLength; start += 0.5 * lead) {
        path.moveTo(-radius, start);
        path.cubicTo(-0.4 * radius, start + 0.1 * lead, 0.4 * radius, start + 0.4 * lead, radius, start + 0.5 * lead);
    }
    return path;
}

} // namespace

QPainterPath fluteOutline(const Cutter& cutter) {
    constexpr int steps = 24; // of a corner radius
    std::vector<QPointF> side{{0.0, 0.0}};
    for (const RevolvedPiece& piece : flutePieces(cutter)) {
        const double rounded = piece.bulges() ? piece.top : piece.bottom + piece.cornerRadius;
        for (int i = 0; i <= steps && rounded > piece.bottom; ++i) {
            // Evenly spaced in the angle of a quarter circle: close together where the rounding is horizontal.
            const double part = 1.0 - std::cos(std::numbers::pi / 2.0 * i / steps);
            const double height = piece.bottom + part * (rounded - piece.bottom);
            side.emplace_back(radiusAt(piece, height), height);
        }
        if (rounded == piece.bottom) side.emplace_back(piece.bottomRadius, piece.bottom);
        side.emplace_back(piece.topRadius, piece.top);
    }
    QPainterPath path(side.front());
    for (const QPointF& point : side) path.lineTo(point);
    for (auto point = side.rbegin(); point != side.rend(); ++point) path.lineTo(-point->x(), point->y());
    path.closeSubpath();
    return path;
}

QPainterPath hollowOutline(const Cutter& cutter) {
    QPainterPath solid;
    for (const double side : {1.0, -1.0}) {
        QPainterPath half;
        for (const PlanRing& ring : cutter.solid->section.rings) {
            half.moveTo(side * ring.front().x, ring.front().y);
            for (const glm::dvec2& corner : ring) half.lineTo(side * corner.x, corner.y);
            half.closeSubpath();
        }
        solid = solid.united(half);
    }
    return fluteOutline(cutter).subtracted(solid);
}

ToolDrawing::ToolDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Drawing of the tool, to scale"));
}

void ToolDrawing::setTool(const std::optional<Tool>& tool) {
    tool_ = tool;
    update();
}

void ToolDrawing::setUnit(LengthUnit unit) {
    unit_ = unit;
    update();
}

QSize ToolDrawing::sizeHint() const {
    return {240, 208};
}

double ToolDrawing::scale() const {
    const double high = (height() - 2.0 * margin) / tool_->cutter.length();
    const double wide = 2.0 * (axisShare * width() - margin) / widest(tool_->cutter);
    return std::min(high, wide);
}

double ToolDrawing::level(double mm) const {
    const double length = tool_->cutter.length() * scale();
    return 0.5 * (height() + length) - mm * scale();
}

void ToolDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& colours = activePalette();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.field);
    painter.drawRoundedRect(rect(), 8.0, 8.0);
    if (!tool_ || !(tool_->cutter.length() > 0.0)) return;

    const Cutter& cutter = tool_->cutter;
    const double axis = std::floor(axisShare * width());
    QTransform toScreen;
    toScreen.translate(axis, level(0.0));
    toScreen.scale(scale(), -scale());
    const auto fill = [&](const QPainterPath& shape, const QColor& colour) {
        QLinearGradient round(axis - 0.5 * widest(cutter) * scale(), 0.0, axis + 0.5 * widest(cutter) * scale(), 0.0);
        round.setColorAt(0.0, mixed(colour, Qt::black, 0.25));
        round.setColorAt(0.45, mixed(colour, Qt::white, 0.12));
        round.setColorAt(1.0, mixed(colour, Qt::black, 0.3));
        painter.setPen(QPen(mixed(colours.field, colour, 0.5), 1.0));
        painter.setBrush(round);
        painter.drawPath(toScreen.map(shape));
    };
    double bottom = cutter.stickOut;
    for (const HolderSegment& segment : cutter.holder) {
        fill(frustum(bottom, segment.lowerDiameter, bottom + segment.length, segment.upperDiameter), colours.holder);
        bottom += segment.length;
    }
    if (cutter.stickOut > cutter.fluteLength)
        fill(frustum(cutter.fluteLength, cutter.shankDiameter, cutter.stickOut, cutter.shankDiameter), colours.shank);
    fill(fluteOutline(cutter), colours.flutes);
    if (cutter.isHollow()) {
        painter.setPen(QPen(mixed(colours.field, colours.flutes, 0.5), 1.0, Qt::DashLine));
        painter.setBrush(mixed(colours.flutes, colours.field, 0.6));
        painter.drawPath(toScreen.map(hollowOutline(cutter)));
    }
    if (!cutter.turns()) return paintHeights(painter, axis);
    painter.save();
    painter.setClipPath(toScreen.map(fluteOutline(cutter)));
    painter.setPen(QPen(mixed(colours.flutes, colours.holder, 0.7), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(toScreen.map(edges(cutter)));
    painter.restore();
    paintHeights(painter, axis);
}

void ToolDrawing::paintHeights(QPainter& painter, double axis) const {
    const Cutter& cutter = tool_->cutter;
    const Palette& colours = activePalette();
    struct Mark {
        QString text;
        double line, label;
    };
    std::vector<Mark> marks{{tr("Tip"), level(0.0), 0.0}};
    marks.push_back({tr("Flutes %1").arg(shortLength(cutter.fluteLength, unit_)), level(cutter.fluteLength), 0.0});
    marks.push_back({tr("Stick-out %1").arg(shortLength(cutter.stickOut, unit_)), level(cutter.stickOut), 0.0});
    if (!cutter.holder.empty())
        marks.push_back({tr("Overall %1").arg(shortLength(cutter.length(), unit_)), level(cutter.length()), 0.0});

    QFont font = numberFont(this->font());
    font.setPointSizeF(labelSize * font.pointSizeF());
    painter.setFont(font);
    const double lineHeight = painter.fontMetrics().height();
    double free = height() - 0.5 * margin; // labels don't overlap, from the tip upwards
    for (Mark& mark : marks) {
        mark.label = std::max(std::min(mark.line, free - 0.5 * lineHeight), 0.5 * lineHeight);
        free = mark.label - 0.5 * lineHeight;
    }
    const double reach = axis + 0.5 * widest(cutter) * scale() + 6.0;
    const double text = reach + 28.0;
    for (const Mark& mark : marks) {
        painter.setPen(QPen(colours.border, 1.0));
        const double y = std::floor(mark.line) + 0.5, labelY = std::floor(mark.label) + 0.5;
        painter.drawLine(QPointF(axis + 0.5 * cutter.diameter * scale() + 3.0, y), QPointF(reach + 8.0, y));
        painter.drawLine(QPointF(reach + 8.0, y), QPointF(text - 4.0, labelY));
        painter.setPen(colours.quietText);
        const QRectF place(text, mark.label - 0.5 * lineHeight, width() - text - 4.0, lineHeight);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(mark.text, Qt::ElideRight, static_cast<int>(place.width())));
    }
}

} // namespace burin
