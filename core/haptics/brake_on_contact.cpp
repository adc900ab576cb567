// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/brake_on_contact.h"

#include <algorithm>
#include <cmath>

namespace burin {

BrakeOnContact::BrakeOnContact(const Cutter& cutter) : tool_(pieces(cutter)), withFlutes_(tool_) {
    withFlutes_.insert(withFlutes_.begin(), withFlutes_.front());
    // Tools a stride apart overlap by more than half of the thinnest piece.
    double thinnest = tool_.front().bottomRadius;
    for (const RevolvedPiece& piece : tool_) thinnest = std::min({thinnest, piece.bottomRadius, piece.topRadius});
    stride_ = std::max(thinnest, 0.05);
}

ShankContact BrakeOnContact::at(const RunVolume& workpiece, const glm::dvec3& tip) const noexcept {
    return shankContact(workpiece, tool_, tip);
}

ShankContact BrakeOnContact::onTheWay(const RunVolume& workpiece, const glm::dvec3& from,
                                      const glm::dvec3& to) const noexcept {
    return onTheWay(workpiece, tool_, from, to);
}

ShankContact BrakeOnContact::onTheWayWithFlutes(const RunVolume& workpiece, const glm::dvec3& from,
                                                const glm::dvec3& to) const noexcept {
    return onTheWay(workpiece, withFlutes_, from, to);
}

ShankContact BrakeOnContact::onTheWay(const RunVolume& workpiece, std::span<const RevolvedPiece> tool,
                                      const glm::dvec3& from, const glm::dvec3& to) const noexcept {
    const int steps = std::clamp(static_cast<int>(std::ceil(glm::length(to - from) / stride_)), 1, 16);
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 tip = i == steps ? to : glm::mix(from, to, static_cast<double>(i) / steps);
        const ShankContact contact = shankContact(workpiece, tool, tip);
        if (!contact.touches) continue;
        const ShankContact standing = shankContact(workpiece, tool, from);
        if (!standing.touches || contact.volume >= standing.volume) return contact;
    }
    return {};
}

} // namespace burin
