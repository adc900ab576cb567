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

/// The stock as a path leaves it so far. Reports before each step of the path whether shank or holder would enter the
/// remaining stock or the part. Both are taken to be slightly larger than they are (0.02 mm and a sixteenth of a voxel
/// at most, no wider than the flutes where they are narrower), as the coordinates of a program are rounded. Thread: the
/// writer of the stock.
class ShankWatch {
public:
    /// Keeps a reference to the stock, which it cuts.
    ShankWatch(RunVolume& stock, const Cutter& cutter);
    ~ShankWatch();
    ShankWatch(const ShankWatch&) = delete;
    ShankWatch& operator=(const ShankWatch&) = delete;

    /// The largest step in which moves have to be checked, mm.
    double step() const noexcept { return step_; }
    /// Height above the tip at which shank and holder begin, mm.
    double lowestGuard() const noexcept { return lowestGuard_; }
    /// The section of the tool that would touch something at a tip; empty if none. Call it before the flutes have cut
    /// there; a step is so short that the material that they would have cleared for the shank lies within the tolerance
    /// of the contact.
    std::optional<ToolSection> contactAt(const glm::dvec3& tip);
    /// The same at all points of a straight move, which is cut as far as it is clear.
    std::optional<ToolSection> cutClear(const glm::dvec3& from, const glm::dvec3& to);
    /// The height by which the tool has to rise from a tip until no stock blocks its flutes from above, mm, to 0.02.
    /// Surface steps that the voxels give a wall cut by the same flutes do not count.
    /// @param most mm: no stock is higher
    double depthAt(const glm::dvec3& tip, double most);
    /// Removes the swept volume of the flutes.
    void cut(const glm::dvec3& from, const glm::dvec3& to);
    void cut(const Arc& arc);

    /// Saves the state of the stock; `goBack` restores it.
    void keep();
    void goBack();

    /// Whether the reserved memory of the stock is used up: results since then are invalid.
    bool outOfMemory() const noexcept { return outOfMemory_; }

private:
    void settle();

    RunVolume& stock_;
    const Cutter& cutter_;
    std::vector<RevolvedPiece> pieces_; ///< enlarged shank and holder
    std::size_t fluteCount_;
    double step_, lowestGuard_; // mm
    MaterialRemoval removal_;
    ContactCheck contact_;
    VolumeSnapshot kept_;
    bool outOfMemory_ = false;
};

} // namespace burin
