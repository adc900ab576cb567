// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/tool_beam.h"

#include "core/base/units.h"
#include "core/tool/hollow_tip.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double fluteCore = 0.8; // diameter of the shaft with equal bending, divided by that of the flutes

/// The section of the shaft at a height.
struct Shaft {
    double diameter = 0.0; ///< mm
    double solid = 1.0;    ///< its second moment of area divided by that without the hollow
};

Shaft shaftAt(const Cutter& cutter, const std::vector<RevolvedPiece>& flutes, double height) {
    if (height >= cutter.fluteLength) return {cutter.shankDiameter, 1.0};
    double diameter = cutter.diameter;
    for (const RevolvedPiece& piece : flutes)
        if (height >= piece.bottom && height <= piece.top) {
            diameter = 2.0 * radiusAt(piece, height);
            break;
        }
    const double bore = cutter.isHollow() ? 2.0 * boreAt(*cutter.solid, height) : 0.0;
    const double solid = diameter > 0.0 ? 1.0 - std::pow(std::min(1.0, bore / diameter), 4) : 1.0;
    return {fluteCore * diameter, solid};
}

} // namespace

ToolBeam::ToolBeam(const Tool& tool) : modulus_(tool.modulus), top_(tool.cutter.stickOut) {
    const std::vector<RevolvedPiece> flutes = flutePieces(tool.cutter);
    const double step = top_ / slices;
    constexpr double thinnest = 1e-3; // mm: a point has no cross-section
    double sum0 = 0.0, sum1 = 0.0, sum2 = 0.0;
    for (int i = slices; i-- > 0;) {
        Slice& slice = slices_[static_cast<std::size_t>(i)];
        slice.height = (i + 0.5) * step;
        const Shaft shaft = shaftAt(tool.cutter, flutes, slice.height);
        const double diameter = std::max(thinnest, shaft.diameter);
        slice.modulus = std::max(1e-3, shaft.solid) * pi / 32.0 * std::pow(diameter, 3);
        const double inertia = 0.5 * diameter * slice.modulus;
        slice.sum0 = sum0 += step / inertia;
        slice.sum1 = sum1 += slice.height * step / inertia;
        slice.sum2 = sum2 += slice.height * slice.height * step / inertia;
    }
    holderModulus_ = slices_.back().modulus;
}

double ToolBeam::bendingUnder(double force, double height) const noexcept {
    if (!(modulus_ > 0.0) || !(height < top_)) return 0.0;
    const double at = std::max(0.0, height);
    const auto first = static_cast<std::size_t>(std::clamp(at / top_ * slices, 0.0, slices - 1.0));
    const Slice& from = slices_[first];
    // The integral of (x - a)² / (E I) from the force to the holder.
    return std::max(0.0, force / modulus_ * (from.sum2 - 2.0 * at * from.sum1 + at * at * from.sum0));
}

double ToolBeam::stressUnder(double force, double height) const noexcept {
    double greatest = force * std::max(0.0, top_ - std::max(0.0, height)) / holderModulus_;
    for (const Slice& slice : slices_)
        if (slice.height > height) greatest = std::max(greatest, force * (slice.height - height) / slice.modulus);
    return greatest;
}

} // namespace burin
