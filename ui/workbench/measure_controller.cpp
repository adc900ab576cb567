// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/measure_controller.h"

#include <algorithm>

namespace burin {

namespace {

/// A scanline next to a point, within the grid.
LineIndex lineNear(const Grid& grid, const glm::dvec3& place) {
    const glm::dvec3 at = glm::floor((place - grid.low()) / grid.edge());
    return {static_cast<std::int32_t>(std::clamp(at[grid.axisOfU()], 0.0, grid.lineCountU() - 1.0)),
            static_cast<std::int32_t>(std::clamp(at[grid.axisOfV()], 0.0, grid.lineCountV() - 1.0))};
}

} // namespace

MeasureController::MeasureController(const Desk& desk, const SetupController& setup,
                                     const WorkpieceController& workpiece, QObject* parent)
    : Controller(desk, parent), setup_(setup), workpieces_(workpiece) {
    // The part may have moved or been replaced.
    connect(&setup_, &SetupController::changed, this, [this] {
        if ((!places_.empty() || !points_.empty()) && setup_.part() != part_) clear();
    });
}

template <typename Measure>
void MeasureController::adopt(const Result<Measure>& measured, std::shared_ptr<const Measure>& into) {
    if (measured) {
        into = std::make_shared<const Measure>(*measured);
    } else {
        places_.clear();
        points_.clear();
        if (measured.error().code != ErrorCode::cancelled) emit failed(measured.error());
    }
    emit changed();
}

void MeasureController::pick(const glm::dvec3& place) {
    if (!setup_.hasPart()) return;
    points_.clear();
    workpieceMeasure_.reset();
    if (places_.size() == 2) places_.clear();
    part_ = setup_.part();
    places_.push_back(place);
    measure_.reset();
    desk_.tasks.start(
        TaskKind::measure, tr("Measuring"),
        [part = setup_.part(), places = places_](Progress& progress) {
            return measurePart(*part, places.front(), places.size() > 1 ? std::optional(places[1]) : std::nullopt, {},
                               progress);
        },
        [this](const Result<PartMeasure>& measured) { adopt(measured, measure_); });
    emit changed();
}

void MeasureController::pickOnWorkpiece(const VolumeSnapshot& workpiece, const WorkpiecePoint& point) {
    const std::shared_ptr<MillingContext>& milling = workpieces_.milling();
    if (workpiece.empty() || !milling) return;
    places_.clear();
    measure_.reset();
    if (points_.size() == 2 || outdated(workpiece)) points_.clear();
    part_ = setup_.part();
    workpiece_ = workpiece;
    points_.push_back(point);
    workpieceMeasure_.reset();
    desk_.tasks.start(
        TaskKind::measure, tr("Measuring"),
        [milling, workpiece, points = points_, top = milling->setup.stock.high.z](Progress& progress) {
            return measureWorkpiece(workpiece, {&milling->part, top}, points.front(),
                                    points.size() > 1 ? std::optional(points[1]) : std::nullopt, progress);
        },
        [this](const Result<WorkpieceMeasure>& measured) { adopt(measured, workpieceMeasure_); });
    emit changed();
}

bool MeasureController::outdated(const VolumeSnapshot& shown) const {
    if (points_.empty()) return false;
    if (workpiece_.empty() || shown.empty() || !shown.sameVolume(workpiece_)) return true;
    return std::ranges::any_of(points_, [&](const WorkpiecePoint& point) {
        return !shown.sharesBrick(workpiece_, lineNear(shown.grid(), point.place));
    });
}

void MeasureController::clear() {
    desk_.tasks.abandon(TaskKind::measure);
    places_.clear();
    points_.clear();
    workpiece_ = VolumeSnapshot();
    measure_.reset();
    workpieceMeasure_.reset();
    emit changed();
}

} // namespace burin
