// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/brake_on_contact.h"

#include <algorithm>
#include <cmath>

namespace burin {

BrakeOnContact::BrakeOnContact(const Cutter& cutter, const Grid& grid)
    : tool_(pieces(cutter)), fluteCount_(flutePieces(cutter).size()), check_(grid) {
    // Tools a stride apart overlap by more than half of the thinnest piece.
    double thinnest = tool_.front().widestRadius();
    for (const RevolvedPiece& piece : tool_) thinnest = std::min(thinnest, piece.widestRadius());
    stride_ = std::max(thinnest, 0.05);
}

ShankContact BrakeOnContact::standing(const RunVolume& workpiece, std::size_t mayTouch,
                                      const glm::dvec3& tip) noexcept {
    return check_.at(workpiece, tool_, mayTouch, {tip, {0.0, 0.0, 1.0}});
}

ShankContact BrakeOnContact::at(const RunVolume& workpiece, const glm::dvec3& tip) noexcept {
    return standing(workpiece, fluteCount_, tip);
}

ShankContact BrakeOnContact::onTheWay(const RunVolume& workpiece, const glm::dvec3& from,
                                      const glm::dvec3& to) noexcept {
    return onTheWay(workpiece, fluteCount_, from, to);
}

ShankContact BrakeOnContact::onTheWayWithFlutes(const RunVolume& workpiece, const glm::dvec3& from,
                                                const glm::dvec3& to) noexcept {
    return onTheWay(workpiece, 0, from, to);
}

ShankContact BrakeOnContact::onTheWay(const RunVolume& workpiece, std::size_t mayTouch, const glm::dvec3& from,
                                      const glm::dvec3& to) noexcept {
    const int steps = std::clamp(static_cast<int>(std::ceil(glm::length(to - from) / stride_)), 1, 16);
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 tip = i == steps ? to : glm::mix(from, to, static_cast<double>(i) / steps);
        const ShankContact contact = standing(workpiece, mayTouch, tip);
        if (!contact.touches) continue;
        const ShankContact before = standing(workpiece, mayTouch, from);
        if (!before.touches || contact.volume >= before.volume) return contact;
    }
    return {};
}

} // namespace burin
