// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <vector>

namespace burin {

/// Keeps shank and holder from moving into anything (paper, 4.2): says whether a way of the tool is barred. A tool that
/// stands in contact already, since the workpiece changed around it, may move where the overlap shrinks.
class BrakeOnContact {
public:
    explicit BrakeOnContact(const Cutter& cutter);

    /// @param from a tip, mm, where the tool stands; @param to where it is wanted. No allocation.
    ShankContact onTheWay(const RunVolume& workpiece, const glm::dvec3& from, const glm::dvec3& to) const noexcept;
    /// The same with the flutes, for a tool that can't cut: it must not move into stock that would stay.
    ShankContact onTheWayWithFlutes(const RunVolume& workpiece, const glm::dvec3& from,
                                    const glm::dvec3& to) const noexcept;
    ShankContact at(const RunVolume& workpiece, const glm::dvec3& tip) const noexcept;

private:
    ShankContact onTheWay(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, const glm::dvec3& from,
                          const glm::dvec3& to) const noexcept;
    std::vector<RevolvedPiece> tool_;       ///< flutes, shank, holder
    std::vector<RevolvedPiece> withFlutes_; ///< flutes twice: the first entry is not looked at
    double stride_ = 1.0;                   ///< mm; looked at so often on the way, nothing is stepped over
};

} // namespace burin
