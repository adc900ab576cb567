// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"
#include "ui/workbench/setup_controller.h"

#include <memory>
#include <vector>

namespace burin {

/// Measures the part at one place, then how that lies to another, in the background.
class MeasureController final : public Controller {
    Q_OBJECT
public:
    MeasureController(const Desk& desk, const SetupController& setup, QObject* parent);

    /// The first place, or the second; behind two of them a first one again. Nothing without a part.
    /// @param place mm, setup frame
    void pick(const glm::dvec3& place);
    void clear();
    bool busy() const { return desk_.tasks.running(TaskKind::measure); }
    /// Of all that was picked; null: nothing was, or it is being measured.
    std::shared_ptr<const PartMeasure> measure() const noexcept { return measure_; }

private:
    const SetupController& setup_;
    std::vector<glm::dvec3> places_; ///< up to two
    std::shared_ptr<const PartMeasure> measure_;
    std::shared_ptr<const Model> part_; ///< that was picked on
};

} // namespace burin
