// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "core/passes/level_order.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Bridges that a profile leaves, so that what it cuts out stays held: evenly along each outline, as far from its
/// corners as that lets them. The tool goes up over them and down again at 30°.
class HoldingTabs {
public:
    /// @param request its tabs, their width and height @param bottom mm, the lowest level
    /// @param spacing mm between places of the runs, at most
    HoldingTabs(const PassRequest& request, double diameter, double bottom, double spacing)
        : request_(request), diameter_(diameter), top_(bottom + request.tabHeight), spacing_(spacing) {}

    /// Whether tips on a level have to go over tabs.
    bool reach(double level) const noexcept { return request_.tabs > 0 && level < top_; }
    /// Where they are: on the lowest level's outlines, before any level is asked for. @param room for the tip there
    void place(const PlanRegion& room);
    /// Lifts a run over the tabs that lie on it.
    TipLine over(const LevelRun& run, double level) const;

private:
    const PassRequest& request_;
    double diameter_, top_, spacing_; // mm
    std::vector<glm::dvec2> places_;  // of the tip over the middle of each
};

} // namespace burin
