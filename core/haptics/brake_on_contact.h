// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/solid_contact.h"
#include "core/tool/tool.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Keeps shank and holder from moving into anything (paper, 4.2): checks whether a motion of the tool is blocked. A
/// tool that is in contact already, because the workpiece changed around it, may move where the overlap shrinks. The
/// shank of a tool that doesn't turn is that of its model, if it has one.
class BrakeOnContact {
public:
    /// @param columns those of the cutter on this grid; null: it has no solid
    BrakeOnContact(const Cutter& cutter, const Grid& grid, std::shared_ptr<const SolidColumns> columns);

    /// @param owed pending cuts that the workpiece does not show yet (MaterialRemoval::window), or null
    /// @param from current pose of the tool; @param to requested pose; the axis rotates uniformly in between. No
    /// allocation.
    ShankContact onTheWay(const RunVolume& workpiece, const CutCache* owed, const ToolPose& from,
                          const ToolPose& to) noexcept;
    /// The same including the flutes, for a tool that can't cut: it must not move into stock that would stay.
    ShankContact onTheWayWithFlutes(const RunVolume& workpiece, const CutCache* owed, const ToolPose& from,
                                    const ToolPose& to) noexcept;
    /// What shank and holder touch at a pose of the tool.
    /// @param owed pending cuts that the workpiece does not show yet; nullptr: none
    ShankContact at(const RunVolume& workpiece, const CutCache* owed, const ToolPose& pose) noexcept;
    /// Must be called after the workpiece was changed otherwise than by cutting.
    void workpieceChanged() noexcept {
        check_.forget();
        if (solid_) solid_->forget();
    }

private:
    ShankContact standing(const RunVolume& workpiece, const CutCache* owed, std::size_t mayTouch,
                          const ToolPose& pose) noexcept;
    ShankContact barred(const RunVolume& workpiece, const CutCache* owed, std::size_t mayTouch, const ToolPose& from,
                        const ToolPose& to) noexcept;

    std::vector<RevolvedPiece> tool_;   ///< flutes, shank, holder
    std::size_t fluteCount_ = 1;        ///< number of pieces, from the tip, that may touch
    std::optional<SolidContact> solid_; ///< the shank, if the pieces do not have it
    double reach_;                      ///< mm, distance of the tool's farthest point from the tip
    ContactCheck check_;
    double stride_ = 1.0; ///< mm; with checks at this spacing nothing on the way is missed
};

} // namespace burin
