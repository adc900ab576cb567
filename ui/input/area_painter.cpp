// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/area_painter.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double brushGrain = 0.1; // of the brush diameter: closer points make no visible difference
constexpr double lassoGrain = 0.2; // mm

} // namespace

void AreaPainter::setPart(PartOnSight part, double height) {
    giveUp();
    part_ = std::move(part);
    height_ = height;
}

void AreaPainter::setShape(AreaShape shape) {
    if (shape_ == shape) return;
    giveUp();
    shape_ = shape;
}

std::optional<glm::dvec3> AreaPainter::placeOn(const ViewportEvent& event, bool anywhere) {
    const Sight sight = sightOf(event);
    const std::optional<glm::dvec3> onPart = part_ ? part_(sight) : std::nullopt;
    if (onPart) {
        height_ = onPart->z;
        return onPart;
    }
    // Outside the part a stroke continues at the height at which it left it.
    if (!anywhere || std::abs(sight.direction.z) < 1e-3) return {};
    const double way = (height_ - sight.origin.z) / sight.direction.z;
    if (!sight.parallel && way < 0.0) return {};
    return sight.origin + way * sight.direction;
}

bool AreaPainter::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    const std::optional<glm::dvec3> place = placeOn(event, shape_ != AreaShape::face);
    if (!place) return false;
    erase_ = event.modifiers.testFlag(Qt::ShiftModifier);
    under_ = true;
    line_.assign(1, glm::dvec2(*place));
    emit stateChanged();
    if (shape_ == AreaShape::face)
        emit faceChosen(*place, erase_);
    else
        emit painting(region());
    return true;
}

bool AreaPainter::move(const ViewportEvent& event) {
    if (under_) {
        if (shape_ != AreaShape::face) add(event);
        return true;
    }
    if (event.buttons == Qt::NoButton) emit hovered(placeOn(event, false));
    return false;
}

void AreaPainter::add(const ViewportEvent& event) {
    const std::optional<glm::dvec3> place = placeOn(event, true);
    const double grain = shape_ == AreaShape::brush ? brushGrain * brush_ : lassoGrain;
    if (!place || glm::distance(glm::dvec2(*place), line_.back()) < grain) return;
    line_.emplace_back(*place);
    emit painting(region());
}

bool AreaPainter::release(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton || !under_) return false;
    if (shape_ != AreaShape::face) {
        add(event);
        const PlanRegion region = this->region();
        under_ = false;
        if (region.empty())
            emit givenUp();
        else
            emit painted(region, erase_);
    }
    under_ = false;
    line_.clear();
    emit stateChanged();
    return true;
}

bool AreaPainter::wheel(const ViewportEvent& event) {
    if (!event.modifiers.testFlag(Qt::ControlModifier) || shape_ != AreaShape::brush) return false;
    emit brushTurned(event.wheelSteps);
    return true;
}

bool AreaPainter::key(int key, Qt::KeyboardModifiers modifiers) {
    if (key != Qt::Key_Escape || modifiers != Qt::NoModifier) return false;
    if (under_)
        giveUp();
    else
        emit cancelled();
    return true;
}

QString AreaPainter::escapeMeaning() {
    return under_ ? tr("Esc: discard this stroke") : tr("Esc: stop painting");
}

void AreaPainter::leave() {
    giveUp();
    emit hovered(std::nullopt);
}

void AreaPainter::giveUp() {
    line_.clear();
    if (!std::exchange(under_, false)) return;
    emit givenUp();
    emit stateChanged();
}

PlanRegion AreaPainter::region() const {
    if (shape_ == AreaShape::brush) return brushed(line_, 0.5 * brush_);
    return line_.size() < 3 ? PlanRegion{} : joined({{line_}}, {});
}

} // namespace burin
