// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "core/passes/level_order.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// The tabs (bridges) that a profile pass leaves to hold the piece that it cuts out. They are evenly spaced along each
/// outline and as far from its corners as that allows. The tool rises over them and descends again at 30°.
class HoldingTabs {
public:
    /// @param request number, width and height of the tabs @param bottom height of the lowest level, mm
    /// @param spacing largest distance between points of the runs, mm
    HoldingTabs(const PassRequest& request, double diameter, double bottom, double spacing)
        : request_(request), diameter_(diameter), top_(bottom + request.tabHeight), spacing_(spacing) {}

    /// Whether tool tips on this level have to rise over tabs.
    bool reach(double level) const noexcept { return request_.tabs > 0 && level < top_; }
    /// Positions the tabs on the outlines of the lowest level. Call it before any level is planned. @param room where
    /// the tip may be on that level
    void place(const PlanRegion& room);
    /// Raises a run over the tabs that lie on it.
    TipLine over(const LevelRun& run, double level) const;

private:
    const PassRequest& request_;
    double diameter_, top_, spacing_; // mm
    std::vector<glm::dvec2> places_;  // of the tip over the middle of each tab
};

} // namespace burin
