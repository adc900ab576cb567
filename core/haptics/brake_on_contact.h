// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin {

/// Keeps shank and holder from moving into anything (paper, 4.2): says whether a way of the tool is barred. A tool that
/// stands in contact already, since the workpiece changed around it, may move where the overlap shrinks.
class BrakeOnContact {
public:
    BrakeOnContact(const Cutter& cutter, const Grid& grid);

    /// @param owed what the workpiece shows though it is gone (MaterialRemoval::window), or null
    /// @param from where the tool stands; @param to where it is wanted; the axis turns evenly. No allocation.
    ShankContact onTheWay(const RunVolume& workpiece, const GapWindow* owed, const ToolPose& from,
                          const ToolPose& to) noexcept;
    /// The same with the flutes, for a tool that can't cut: it must not move into stock that would stay.
    ShankContact onTheWayWithFlutes(const RunVolume& workpiece, const GapWindow* owed, const ToolPose& from,
                                    const ToolPose& to) noexcept;
    /// What shank and holder touch where the tool stands.
    /// @param owed pending cuts that the workpiece does not show yet; nullptr: none
    ShankContact at(const RunVolume& workpiece, const GapWindow* owed, const ToolPose& pose) noexcept;
    /// The workpiece changed otherwise than by cutting.
    void workpieceChanged() noexcept { check_.forget(); }

private:
    ShankContact barred(const RunVolume& workpiece, const GapWindow* owed, std::size_t mayTouch, const ToolPose& from,
                        const ToolPose& to) noexcept;

    std::vector<RevolvedPiece> tool_; ///< flutes, shank, holder
    std::size_t fluteCount_ = 1;
    double reach_; ///< mm, of the tool's farthest point from the tip
    ContactCheck check_;
    double stride_ = 1.0; ///< mm; looked at so often on the way, nothing is stepped over
};

} // namespace burin
