// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/obstacle_mover.h"

#include "core/base/units.h"
#include "ui/workbench/undo_refusal.h"

#include <cmath>
#include <utility>

namespace burin {

ObstacleMover::ObstacleMover(const Desk& desk, WorkpieceController& workpiece, StockSolidController& stock,
                             SurroundingsController& surroundings, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), stock_(stock), surroundings_(surroundings) {
    connect(&surroundings, &Controller::changed, this, &ObstacleMover::follow);
    connect(&stock, &Controller::changed, this, [this] {
        if (moving()) emit changed();
    });
}

void ObstacleMover::take(const std::shared_ptr<const Obstacle>& obstacle) {
    obstacle_ = obstacle;
    held_ = heldRotations(*obstacle);
    middle_ = boundsOf(*obstacle).centre();
    motion_ = {};
}

void ObstacleMover::begin(std::size_t place) {
    if (place_ == place) return;
    accept();
    if (!workpiece_.hasModel() || surroundings_.locked() || place >= surroundings_.obstacles().size()) return;
    const std::shared_ptr<const Obstacle>& obstacle = surroundings_.obstacles()[place].obstacle;
    if (obstacle->design) return;
    place_ = place;
    take(obstacle);
    emit changed();
}

void ObstacleMover::end() {
    place_.reset();
    obstacle_.reset();
    motion_ = {};
    emit changed();
}

void ObstacleMover::cancel() {
    if (moving()) end();
}

void ObstacleMover::accept() {
    if (!moving()) return;
    if (isNone(motion_) || surroundings_.locked()) return end();
    if (refusedDuringUndo(desk_, *this, SurroundingsController::tr("fixture moved"))) return;
    const std::size_t place = *place_;
    const Obstacle there = moved();
    end();
    surroundings_.move(place, there);
}

/// An undo, a number entered in the panel: the move goes on from there. Another project, another list: it ends.
void ObstacleMover::follow() {
    if (!moving()) return;
    const std::vector<PlacedObstacle>& obstacles = surroundings_.obstacles();
    if (*place_ >= obstacles.size() || obstacles[*place_].obstacle->name != obstacle_->name ||
        obstacles[*place_].obstacle->design || !workpiece_.hasModel() || surroundings_.locked())
        return end();
    if (obstacles[*place_].obstacle == obstacle_) return;
    take(obstacles[*place_].obstacle);
    emit changed();
}

Obstacle ObstacleMover::moved() const {
    Result<Obstacle> there = burin::moved(*obstacle_, motion_);
    return there ? *std::move(there) : *obstacle_; // `setMotion` takes no motion that it can't hold
}

FixtureSite ObstacleMover::site() const {
    std::vector<Obstacle> library;
    for (const PlacedObstacle& one : surroundings_.obstacles())
        if (one.obstacle->design)
            library.push_back({one.obstacle->name, {}, 0.0, true, one.obstacle->kind, one.obstacle->design});
    return siteOf(stock_.stock(), library);
}

void ObstacleMover::setMotion(const Placement& motion) {
    if (!moving() || motion == motion_ || (!rotates() && !alongAxes(motion))) return;
    motion_ = motion;
    emit changed();
}

void ObstacleMover::turnBy(double angle) {
    const double held = rotates() ? angle : std::copysign(0.5 * pi, angle);
    setMotion(combined(motion_, turnedAbout({0.0, 0.0, 1.0}, held, centre())));
}

void ObstacleMover::placeAt(const glm::dvec3& point) {
    if (!moving()) return;
    const Box box = boundsOf(moved());
    moveBy(point - glm::dvec3(box.centre().x, box.centre().y, box.low.z));
}

} // namespace burin
