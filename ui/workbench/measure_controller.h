// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"
#include "core/job/workpiece_measure.h"
#include "ui/workbench/setup_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <memory>
#include <vector>

namespace burin {

/// Measures the part or the workpiece at one point, then its position relative to a second point, in the background.
class MeasureController final : public Controller {
    Q_OBJECT
public:
    MeasureController(const Desk& desk, const SetupController& setup, const WorkpieceController& workpiece,
                      QObject* parent);

    /// Picks the first or the second point; after two points a new first one. Does nothing without a part.
    /// @param place mm, setup frame
    void pick(const glm::dvec3& place);
    /// The same on a workpiece; points on the part are dropped, and the other way round.
    void pickOnWorkpiece(const VolumeSnapshot& workpiece, const WorkpiecePoint& point);
    void clear();
    bool busy() const { return desk_.tasks.running(TaskKind::measure); }
    /// Measure of all picked points; null if none was picked or measuring is under way.
    std::shared_ptr<const PartMeasure> measure() const noexcept { return measure_; }
    std::shared_ptr<const WorkpieceMeasure> workpieceMeasure() const noexcept { return workpieceMeasure_; }
    /// Whether the measure of the workpiece is that of another one where the points are: something was cut there, or
    /// another moment is shown. @param shown the workpiece that is drawn
    bool outdated(const VolumeSnapshot& shown) const;

private:
    template <typename Measure>
    void adopt(const Result<Measure>& measured, std::shared_ptr<const Measure>& into);

    const SetupController& setup_;
    const WorkpieceController& workpieces_;
    std::vector<WorkpiecePoint> points_; ///< on the workpiece, up to two
    VolumeSnapshot workpiece_;           ///< on which they were picked
    std::shared_ptr<const WorkpieceMeasure> workpieceMeasure_;
    std::vector<glm::dvec3> places_; ///< up to two
    std::shared_ptr<const PartMeasure> measure_;
    std::shared_ptr<const Model> part_; ///< on which the points were picked
};

} // namespace burin
