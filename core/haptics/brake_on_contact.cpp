// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/brake_on_contact.h"

#include "core/cutting/pose_steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

BrakeOnContact::BrakeOnContact(const Cutter& cutter, const Grid& grid, std::shared_ptr<const SolidColumns> columns)
    : tool_(pieces(cutter)), fluteCount_(flutePieces(cutter).size()), reach_(reachOf(tool_)), check_(grid) {
    // Tool positions one stride apart overlap by more than half of the thinnest piece.
    double thinnest = tool_.front().widestRadius();
    for (const RevolvedPiece& piece : tool_) thinnest = std::min(thinnest, piece.widestRadius());
    stride_ = std::max(thinnest, 0.05);
    if (cutter.turns() || cutter.solid->shank.empty()) return;
    solid_.emplace(std::move(columns), static_cast<std::uint32_t>(fluteCount_));
    stride_ = std::min(stride_, grid.edge()); // its pieces say nothing about its thickness
    while (fluteCount_ < tool_.size() && sectionOf(cutter, fluteCount_) == ToolSection::shank) ++fluteCount_;
}

/// @param mayTouch number of pieces, from the tip, that may touch; 0: a tool that can't cut, by the pieces around it
ShankContact BrakeOnContact::standing(const RunVolume& workpiece, const CutCache* owed, std::size_t mayTouch,
                                      const ToolPose& pose) noexcept {
    ShankContact contact = check_.at(workpiece, tool_, mayTouch, pose, owed);
    if (!solid_ || mayTouch == 0) return contact;
    ShankContact shank = solid_->at(workpiece, pose.tip);
    if (!shank.touches) return contact;
    if (contact.volume > shank.volume) std::swap(contact, shank);
    shank.volume += contact.volume;
    shank.touchesStock = shank.touchesStock || contact.touchesStock;
    shank.touchesProtected = shank.touchesProtected || contact.touchesProtected;
    return shank;
}

ShankContact BrakeOnContact::at(const RunVolume& workpiece, const CutCache* owed, const ToolPose& pose) noexcept {
    return standing(workpiece, owed, fluteCount_, pose);
}

ShankContact BrakeOnContact::onTheWay(const RunVolume& workpiece, const CutCache* owed, const ToolPose& from,
                                      const ToolPose& to) noexcept {
    return barred(workpiece, owed, fluteCount_, from, to);
}

ShankContact BrakeOnContact::onTheWayWithFlutes(const RunVolume& workpiece, const CutCache* owed, const ToolPose& from,
                                                const ToolPose& to) noexcept {
    return barred(workpiece, owed, 0, from, to);
}

ShankContact BrakeOnContact::barred(const RunVolume& workpiece, const CutCache* owed, std::size_t mayTouch,
                                    const ToolPose& from, const ToolPose& to) noexcept {
    const double way = glm::length(to.tip - from.tip) + reach_ * glm::length(to.axis - from.axis);
    const int steps = std::clamp(static_cast<int>(std::ceil(way / stride_)), 1, 16);
    const PoseSteps motion(from, to, reach_, stride_);
    for (int i = 1; i <= steps; ++i) {
        const ShankContact contact =
            standing(workpiece, owed, mayTouch, motion.poseAt(static_cast<double>(i) / static_cast<double>(steps)));
        if (!contact.touches) continue;
        const ShankContact before = standing(workpiece, owed, mayTouch, from);
        if (!before.touches || contact.volume >= before.volume) return contact;
    }
    return {};
}

} // namespace burin
