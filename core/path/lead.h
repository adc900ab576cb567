// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/hand_start.h"
#include "core/path/part_guard.h"
#include "core/path/stroke.h"

#include <vector>

namespace burin {

/// The wanted form of a way into a stroke.
struct LeadShape {
    LeadIn::Form form = LeadIn::Form::arc;
    double size = 0.0, height = 0.0; ///< mm
    double angle = 0.0;              ///< rad
    double smallestShare = 0.25;     ///< of the size, that is tried at last
};

/// Finds ways that end in a place with a direction, clear of the part and of what stands around.
class LeadFinder {
public:
    /// Keeps a reference to the guard.
    LeadFinder(const LeadShape& shape, const PartGuard& guard, const PathContext& context);

    /// Where the way begins and where its moves end, the last in the start of the stroke; nothing where none is clear,
    /// or where the stroke starts straight up or down.
    /// @param recorded the hand's own beginning of the stroke, for directions by the recording; null: not known
    std::vector<StrokePoint> into(const PathStroke& stroke, const HandStart* recorded = nullptr) const;

    /// Whether moves keep the tool as far from the part, and by their margins from obstacles. @param required mm
    bool isClear(const std::vector<StrokePoint>& way, double required) const;

private:
    std::vector<StrokePoint> made(const glm::dvec3& end, const glm::dvec3& direction, double size, double side) const;
    double sideAt(const HandStart& start, double required) const;

    LeadShape shape_;
    const PartGuard& guard_;
    std::vector<std::pair<PartGuard, double>> obstacles_; ///< with the margin to keep, mm
};

} // namespace burin
