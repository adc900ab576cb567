// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"
#include "core/haptics/workspace.h"
#include "core/setup/guide.h"

#include <cstddef>
#include <type_traits>
#include <variant>

namespace burin {

struct AllowanceChange {
    double allowance = 0.0; ///< mm, >= 0
};
struct LevelStep {
    int levels = 0; ///< as for GuideSet::step
};
struct LayerSwitch {
    std::size_t layer = 0;
    bool on = false;
};
struct SpindleRelease {
    bool released = false;
};
struct TakeBegin {};     ///< the next tick does not cut
struct ForceWithheld {}; ///< the force of the last tick came too late: the device got none
struct CutResumption {}; ///< the owner has made room in the reserved memory
/// The owner replaced the state of the workpiece: undid the newest stroke, or redid the one undone last.
struct WorkpieceChange {
    bool undone = true; ///< false: redone
};

/// A change made to a step between two ticks. Together with the readings, the changes determine everything that the
/// step does. Plain data.
using StepChange = std::variant<AllowanceChange, GuideSettings, LevelStep, WorkspaceSettings, LayerSwitch,
                                SpindleRelease, TakeBegin, ForceWithheld, CutResumption, WorkpieceChange, TileChange>;
static_assert(std::is_trivially_copyable_v<StepChange>);

/// Is notified of the changes made to a step, on the thread that makes them, before the step applies them. No
/// allocation, lock or file access.
class StepChangeListener {
public:
    virtual ~StepChangeListener() = default;
    /// @param change will take effect between two ticks
    virtual void changed(const StepChange& change) noexcept = 0;
};

/// A change, and the number of ticks before it.
struct TimedChange {
    std::size_t tick = 0;
    StepChange change;
};

} // namespace burin
