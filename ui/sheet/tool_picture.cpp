// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/tool_picture.h"

#include "ui/panels/texts.h"
#include "ui/panels/tool_drawing.h"
#include "ui/sheet/sheet_text.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double margin = 14.0, labels = 110.0; // pixels

class Drawing {
public:
    Drawing(const Tool& tool, double scale, LengthUnit unit) : cutter_(tool.cutter), scale_(scale), unit_(unit) {
        widest_ = std::max(cutter_.diameter, cutter_.shankDiameter);
        for (const HolderSegment& segment : cutter_.holder)
            widest_ = std::max({widest_, segment.lowerDiameter, segment.upperDiameter});
        axis_ = margin + 0.5 * widest_ * scale_;
        height_ = cutter_.length() * scale_ + 2.0 * margin;
    }

    QString svg() {
        double bottom = cutter_.stickOut;
        for (const HolderSegment& segment : cutter_.holder) {
            frustum(bottom, segment.lowerDiameter, bottom + segment.length, segment.upperDiameter, "holder");
            bottom += segment.length;
        }
        if (cutter_.stickOut > cutter_.fluteLength)
            frustum(cutter_.fluteLength, cutter_.shankDiameter, cutter_.stickOut, cutter_.shankDiameter, "shank");
        for (const QPolygonF& outline : fluteOutline(cutter_).toSubpathPolygons()) polygon(outline, "flutes");
        double free = height_; // labels must not overlap
        label(0.0, QStringLiteral("Ø ") + shortLength(cutter_.diameter, unit_), free);
        label(cutter_.fluteLength, SheetText::tr("flutes %1").arg(shortLength(cutter_.fluteLength, unit_)), free);
        label(cutter_.stickOut, SheetText::tr("stick-out %1").arg(shortLength(cutter_.stickOut, unit_)), free);
        const double width = 2.0 * axis_ + labels;
        return QStringLiteral("<svg class=\"tool\" width=\"%1\" height=\"%2\">%3</svg>")
            .arg(number(width), number(height_), shapes_);
    }

private:
    static QString number(double value) { return QString::number(value, 'f', 2); }
    double level(double mm) const { return height_ - margin - mm * scale_; }

    void polygon(const QPolygonF& outline, const char* kind) {
        QString points;
        for (const QPointF& point : outline)
            points += number(axis_ + point.x() * scale_) + ',' + number(level(point.y())) + ' ';
        shapes_ += QStringLiteral("<polygon class=\"%1\" points=\"%2\"/>").arg(QLatin1String(kind), points.trimmed());
    }

    void frustum(double bottom, double lower, double top, double upper, const char* kind) {
        polygon(QPolygonF({{-0.5 * lower, bottom}, {0.5 * lower, bottom}, {0.5 * upper, top}, {-0.5 * upper, top}}),
                kind);
    }

    void label(double mm, const QString& text, double& free) {
        constexpr double line = 14.0; // pixels
        const double at = level(mm), written = std::min(at, free - line);
        const double from = axis_ + 0.5 * widest_ * scale_ + 3.0;
        shapes_ += QStringLiteral("<path class=\"measure\" d=\"M%1 %2 L%3 %2 L%4 %5\"/>")
                       .arg(number(axis_), number(at), number(from), number(from + 12.0), number(written));
        shapes_ += QStringLiteral("<text x=\"%1\" y=\"%2\">%3</text>")
                       .arg(number(from + 15.0), number(written + 4.0), text.toHtmlEscaped());
        free = written;
    }

    const Cutter& cutter_;
    double scale_, widest_ = 0.0, axis_ = 0.0, height_ = 0.0;
    LengthUnit unit_;
    QString shapes_;
};

} // namespace

QString toolPicture(const Tool& tool, double pixels, LengthUnit unit) {
    return Drawing(tool, pixels, unit).svg();
}

} // namespace burin
