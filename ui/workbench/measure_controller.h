// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"
#include "ui/workbench/setup_controller.h"

#include <memory>
#include <vector>

namespace burin {

/// Measures the part at one point, then its position relative to a second point, in the background.
class MeasureController final : public Controller {
    Q_OBJECT
public:
    MeasureController(const Desk& desk, const SetupController& setup, QObject* parent);

    /// Picks the first or the second point; after two points a new first one. Does nothing without a part.
    /// @param place mm, setup frame
    void pick(const glm::dvec3& place);
    void clear();
    bool busy() const { return desk_.tasks.running(TaskKind::measure); }
    /// Measure of all picked points; null if none was picked or measuring is under way.
    std::shared_ptr<const PartMeasure> measure() const noexcept { return measure_; }

private:
    const SetupController& setup_;
    std::vector<glm::dvec3> places_; ///< up to two
    std::shared_ptr<const PartMeasure> measure_;
    std::shared_ptr<const Model> part_; ///< on which the points were picked
};

} // namespace burin
