// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/removal.h"
#include "core/geometry/arc.h"
#include "core/tool/tool.h"

#include <optional>
#include <vector>

namespace burin {

/// The stock as a path leaves it so far, which says before each step of it whether shank or holder would enter what is
/// left of stock and part. Both are taken to be a little larger than they are (0.02 mm and a sixteenth of a voxel at
/// most, no wider than the flutes where they are narrower), as numbers of a program are rounded. Thread: the stock's
/// writer.
class ShankWatch {
public:
    /// Keeps a reference to the stock, which it cuts.
    ShankWatch(RunVolume& stock, const Cutter& cutter);
    ~ShankWatch();
    ShankWatch(const ShankWatch&) = delete;
    ShankWatch& operator=(const ShankWatch&) = delete;

    /// mm: a move is to be looked at in steps no longer than this.
    double step() const noexcept { return step_; }
    /// How far above the tip shank and holder begin, mm.
    double lowestGuard() const noexcept { return lowestGuard_; }
    /// What would touch something here. Asked before the flutes have cut there; a step is so short that what
    /// they would have cleared for the shank on it lies within the tolerance of the contact.
    std::optional<ToolSection> contactAt(const glm::dvec3& tip);
    /// The same at all points of a straight move, which is cut as far as it is clear.
    std::optional<ToolSection> cutClear(const glm::dvec3& from, const glm::dvec3& to);
    /// How far the tool has to rise from a tip until no stock stands in the way of its flutes from above, mm, to 0.02.
    /// Shapes that voxels give a wall that the same flutes have cut count as none.
    /// @param most mm: higher nothing stands
    double depthAt(const glm::dvec3& tip, double most);
    /// The flutes take what they sweep.
    void cut(const glm::dvec3& from, const glm::dvec3& to);
    void cut(const Arc& arc);

    /// Keeps the stock as it is; `goBack` brings it back to that.
    void keep();
    void goBack();

    /// The reserved memory of the stock is used up: answers since then are worthless.
    bool outOfMemory() const noexcept { return outOfMemory_; }

private:
    void settle();

    RunVolume& stock_;
    const Cutter& cutter_;
    std::vector<RevolvedPiece> pieces_; ///< shank and holder grown
    std::size_t fluteCount_;
    double step_, lowestGuard_; // mm
    MaterialRemoval removal_;
    ContactCheck contact_;
    VolumeSnapshot kept_;
    bool outOfMemory_ = false;
};

} // namespace burin
