// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/fixture_placer.h"

#include "core/base/units.h"
#include "ui/input/mill_geometry.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double fixtureStep = 1.0;                           // mm
constexpr double fineShare = 0.1, coarseShare = 10.0;         // of a step, with Shift and with Ctrl
constexpr double smallTurn = pi / 12.0, quarterTurn = pi / 2; // 15°, 90°

} // namespace

std::optional<glm::dvec3> FixturePlacer::pointOn(const Sight& sight) const {
    std::optional<glm::dvec3> point = site_.stock.hit(sight.seenOrigin(), sight.direction);
    const bool onStock = point.has_value();
    if (!onStock) point = onLevel(sight, site_.table);
    if (!point) return std::nullopt;
    const glm::dvec3 middle = site_.stock.box().centre();
    for (const int axis : {0, 1})
        (*point)[axis] = middle[axis] + fixtureStep * std::round(((*point)[axis] - middle[axis]) / fixtureStep);
    return onStock ? keptWithin(site_.stock.box(), *point) : *point;
}

bool FixturePlacer::press(const ViewportEvent& event) {
    lookingAlong_ = event.rayDirection;
    if (event.button != Qt::LeftButton || site_.stock.empty()) return false;
    dragging_ = true;
    if (const std::optional<glm::dvec3> point = pointOn(sightOf(event))) emit placed(*point);
    return true;
}

bool FixturePlacer::move(const ViewportEvent& event) {
    lookingAlong_ = event.rayDirection;
    if (!event.buttons.testFlag(Qt::LeftButton)) dragging_ = false; // the release was sent to another window
    if (!dragging_) return false;
    if (const std::optional<glm::dvec3> point = pointOn(sightOf(event))) emit placed(*point);
    return true;
}

bool FixturePlacer::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(dragging_, false);
}

bool FixturePlacer::key(int key, Qt::KeyboardModifiers modifiers) {
    if (key == Qt::Key_Escape) {
        emit cancelled();
        return true;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        emit accepted();
        return true;
    }
    if (key == Qt::Key_R) {
        emit turnedBy(modifiers.testFlag(Qt::ShiftModifier) ? quarterTurn : smallTurn);
        return true;
    }
    const glm::dvec3 direction = keyStep(key, lookingAlong_);
    if (direction == glm::dvec3(0.0)) return false;
    const double share = modifiers.testFlag(Qt::ShiftModifier)     ? fineShare
                         : modifiers.testFlag(Qt::ControlModifier) ? coarseShare
                                                                   : 1.0;
    emit movedBy(direction * (fixtureStep * share));
    return true;
}

QString FixturePlacer::escapeMeaning() {
    return tr("Esc: cancel placing the fixture");
}

} // namespace burin
