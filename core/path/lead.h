// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/hand_start.h"
#include "core/path/part_guard.h"
#include "core/path/stroke.h"

#include <vector>

namespace burin {

/// The requested form of a lead-in.
struct LeadShape {
    LeadIn::Form form = LeadIn::Form::arc;
    double size = 0.0, height = 0.0; ///< mm
    double angle = 0.0;              ///< rad
    double smallestShare = 0.25;     ///< of the size; the smallest that is tried
};

/// Finds lead-ins that end at a point in a given direction, clear of the part and of obstacles.
class LeadFinder {
public:
    /// Keeps a reference to the guard.
    LeadFinder(const LeadShape& shape, const PartGuard& guard, const PathContext& context);

    /// The start of the lead-in and the ends of its moves, the last at the start of the stroke; empty if none is clear,
    /// or if the stroke starts straight up or down.
    /// @param recorded the recorded beginning of the stroke, for directions by the recording; null: not known
    std::vector<StrokePoint> into(const PathStroke& stroke, const HandStart* recorded = nullptr) const;

    /// Whether moves keep the required distance from the part, and the margins of obstacles. @param required mm
    bool isClear(const std::vector<StrokePoint>& way, double required) const;

private:
    std::vector<StrokePoint> made(const glm::dvec3& end, const glm::dvec3& direction, double size, double side) const;
    double sideAt(const HandStart& start, double required) const;

    LeadShape shape_;
    const PartGuard& guard_;
    std::vector<std::pair<PartGuard, double>> obstacles_; ///< with the margin to keep, mm
};

} // namespace burin
