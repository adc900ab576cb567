// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/fixture_drawing.h"

#include "core/setup/fixture_library.h"
#include "core/setup/fixture_solid.h"
#include "ui/messages/messages.h"
#include "ui/panels/texts.h"
#include "ui/theme/colour.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {

namespace {

constexpr double drawingMargin = 16.0, betweenViews = 18.0; // device-independent pixels
constexpr double tick = 3.5;                                // half the length of the end of a measure
constexpr double letterSize = 0.85;                         // of the font

/// A point of the fixture's frame as a view shows it, mm, y up.
QPointF inView(const glm::dvec3& point, FixtureView view) {
    return {point.x, view == FixtureView::side ? point.z : point.y};
}

QRectF inView(const Box& box, FixtureView view) {
    return QRectF(inView(box.low, view), inView(box.high, view));
}

Box stepBox(const RoundBody& body, const RoundStep& step) {
    return {{body.centre - step.radius, step.low}, {body.centre + step.radius, step.high}};
}

Box solidBounds(const FixtureSolids& solids) {
    Box bounds;
    for (const Box& box : solids.boxes) bounds.include(box);
    for (const RoundBody& body : solids.rounds)
        for (const RoundStep& step : body.steps) bounds.include(stepBox(body, step));
    return bounds;
}

/// A shape of a view, drawn the later the nearer it is to the eye.
struct FixtureShape {
    double nearness = 0.0;
    QRectF room;
    bool round = false, hole = false;
};

std::vector<FixtureShape> shapesOf(const FixtureSolids& solids, FixtureView view) {
    std::vector<FixtureShape> shapes;
    const auto nearness = [view](const Box& box) { return view == FixtureView::side ? -box.low.y : box.high.z; };
    for (const Box& box : solids.boxes) shapes.push_back({nearness(box), inView(box, view)});
    for (const Box& box : solids.cutAway)
        if (view == FixtureView::top) shapes.push_back({nearness(box), inView(box, view), false, true});
    for (const RoundBody& body : solids.rounds)
        for (const RoundStep& step : body.steps) {
            const Box box = stepBox(body, step);
            shapes.push_back({nearness(box), inView(box, view), view == FixtureView::top});
        }
    std::ranges::stable_sort(shapes, {}, &FixtureShape::nearness);
    return shapes;
}

void paintSolids(QPainter& painter, const FixtureSolids& solids, FixtureView view, const QTransform& toScreen) {
    const Palette& colours = activePalette();
    painter.setPen(QPen(mixed(colours.field, colours.text, 0.55), 1.0));
    for (const FixtureShape& shape : shapesOf(solids, view)) {
        painter.setBrush(shape.hole ? colours.field : mixed(colours.field, colours.holder, 0.7));
        const QRectF room = toScreen.mapRect(shape.room);
        shape.round ? painter.drawEllipse(room) : painter.drawRect(room);
    }
}

/// Both views in a rectangle, beside or below each other, whichever shows them larger.
struct DrawingLayout {
    QTransform side, top;
};

DrawingLayout drawingLayout(const Box& bounds, const QRectF& room) {
    const glm::dvec3 size = bounds.size();
    const double beside =
                     std::min((room.width() - betweenViews) / (2.0 * size.x), room.height() / std::max(size.y, size.z)),
                 below = std::min(room.width() / size.x, (room.height() - betweenViews) / (size.y + size.z));
    const double scale = std::max(beside, below);
    const auto at = [&](const QPointF& middle, const QPointF& of) {
        return QTransform::fromTranslate(-of.x(), -of.y()) * QTransform::fromScale(scale, -scale) *
               QTransform::fromTranslate(middle.x(), middle.y());
    };
    const glm::dvec3 centre = bounds.centre();
    const QPointF sideCentre = inView(centre, FixtureView::side), topCentre = inView(centre, FixtureView::top);
    if (beside >= below) {
        const QPointF apart(0.5 * (size.x * scale + betweenViews), 0.0);
        return {at(room.center() - apart, sideCentre), at(room.center() + apart, topCentre)};
    }
    const double rise = size.z * scale, depth = size.y * scale,
                 upper = room.center().y() - 0.5 * (rise + depth + betweenViews);
    return {at({room.center().x(), upper + 0.5 * rise}, sideCentre),
            at({room.center().x(), upper + rise + betweenViews + 0.5 * depth}, topCentre)};
}

void paintMeasure(QPainter& painter, const QPointF& from, const QPointF& to) {
    painter.drawLine(from, to);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length == 0.0) return;
    const QPointF across = QPointF(-way.y(), way.x()) * (tick / length);
    for (const QPointF& end : {from, to}) painter.drawLine(end - across, end + across);
}

/// A text on a plate, within a rectangle.
void paintPlate(QPainter& painter, const QPointF& middle, const QString& text, const QColor& colour,
                const QRectF& room) {
    QRectF plate(QPointF(0.0, 0.0), QSizeF(painter.fontMetrics().size(0, text)) + QSizeF(4.0, 0.0));
    plate.moveCenter(middle);
    plate.moveLeft(std::clamp(plate.left(), room.left(), std::max(room.left(), room.right() - plate.width())));
    plate.moveTop(std::clamp(plate.top(), room.top(), std::max(room.top(), room.bottom() - plate.height())));
    QColor ground = activePalette().field;
    ground.setAlphaF(0.8F);
    painter.fillRect(plate, ground);
    painter.setPen(colour);
    painter.drawText(plate, Qt::AlignCenter, text);
}

} // namespace

QString measureLetter(std::size_t parameter) {
    return QChar(static_cast<char16_t>(u'A' + parameter));
}

QPixmap fixturePicture(FixtureKind kind, const QSize& size, double ratio) {
    QPixmap picture((QSizeF(size) * ratio).toSize());
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    const FixtureSolids solids = solidsOf(standardFixture(kind));
    const Box bounds = solidBounds(solids);
    const QRectF room = QRectF(QPointF(0.0, 0.0), QSizeF(size)).adjusted(1.5, 1.5, -1.5, -1.5);
    const double scale = std::min(room.width() / bounds.size().x, room.height() / bounds.size().z);
    const QPointF middle = inView(bounds.centre(), FixtureView::side);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSolids(painter, solids, FixtureView::side,
                QTransform::fromTranslate(-middle.x(), -middle.y()) * QTransform::fromScale(scale, -scale) *
                    QTransform::fromTranslate(room.center().x(), room.center().y()));
    return picture;
}

FixtureDrawing::FixtureDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Drawing of the fixture, to scale"));
}

void FixtureDrawing::setDesign(const std::optional<FixtureDesign>& design) {
    design_ = design;
    update();
}

void FixtureDrawing::setUnit(LengthUnit unit) {
    unit_ = unit;
    update();
}

void FixtureDrawing::mark(const std::optional<std::size_t>& parameter) {
    marked_ = parameter;
    update();
}

QSize FixtureDrawing::sizeHint() const {
    return {360, 136};
}

void FixtureDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& colours = activePalette();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.field);
    painter.drawRoundedRect(rect(), 8.0, 8.0);
    if (!design_) return;
    const FixtureSolids solids = solidsOf(*design_);
    const QRectF room = QRectF(rect()).adjusted(drawingMargin, drawingMargin, -drawingMargin, -drawingMargin);
    const DrawingLayout layout = drawingLayout(solidBounds(solids), room);
    paintSolids(painter, solids, FixtureView::side, layout.side);
    paintSolids(painter, solids, FixtureView::top, layout.top);

    QFont small = font();
    small.setPointSizeF(letterSize * small.pointSizeF());
    painter.setFont(small);
    const std::vector<FixtureMeasure> measures = measuresOf(*design_);
    const auto paint = [&](std::size_t i, const QColor& colour, double width, const QString& text) {
        const FixtureMeasure& measure = measures[i];
        const QTransform& toScreen = measure.view == FixtureView::side ? layout.side : layout.top;
        const QPointF from = toScreen.map(inView(measure.from, measure.view)),
                      to = toScreen.map(inView(measure.to, measure.view));
        painter.setPen(QPen(colour, width));
        paintMeasure(painter, from, to);
        paintPlate(painter, 0.5 * (from + to), text, colour, QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0));
    };
    for (std::size_t i = 0; i < measures.size(); ++i)
        if (i != marked_) paint(i, colours.text, 1.0, measureLetter(i));
    if (!marked_ || *marked_ >= measures.size()) return;
    const FixtureParameter& parameter = rowOf(design_->kind).parameters[*marked_];
    paint(*marked_, colours.accent, 2.5,
          QStringLiteral("%1  %2  %3")
              .arg(measureLetter(*marked_), Messages::text(parameter.label),
                   shortLength(design_->values[*marked_], unit_)));
}

} // namespace burin
