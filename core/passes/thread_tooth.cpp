// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_tooth.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/passes/thread_size.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace burin {

namespace {

constexpr double flank = pi / 6.0;       // rad, between a flank and the plane across the axis
constexpr double toothSlack = 0.005;     // mm by which a tooth may be wider than its groove, on either side
constexpr double mostNarrower = 0.01;    // mm, at the pitch line
constexpr double pitchLineShare = 0.375; // of H, from the major diameter to the pitch line
constexpr double inwards = 1e-7;         // mm: edges count as parts of the tooth

/// The heights of the flutes at a distance from the axis; empty if there are none, or several with gaps.
std::optional<HeightRange> oneRange(const std::vector<RevolvedPiece>& flutes, double radius) {
    std::optional<HeightRange> all;
    for (const RevolvedPiece& piece : flutes) { // from the tip up
        const std::optional<HeightRange> range = heightsAt(piece, radius);
        if (!range) continue;
        if (all && range->low > all->high + 1e-6) return {};
        all = all ? HeightRange{all->low, std::max(all->high, range->high)} : *range;
    }
    return all;
}

bool fitsGroove(const std::vector<RevolvedPiece>& flutes, const ThreadTooth& tooth, double pitch) {
    constexpr int looks = 32;
    const double depth = threadDepth(pitch);
    for (int i = 0; i <= looks; ++i) {
        const double in = depth * i / looks, half = pitch / 16.0 + in * std::tan(flank) + toothSlack;
        const std::optional<HeightRange> range = oneRange(flutes, tooth.radius - in - inwards);
        if (!range || range->low < tooth.height - half || range->high > tooth.height + half) return false;
    }
    const double pitchLine = pitchLineShare * 0.5 * std::sqrt(3.0) * pitch;
    const std::optional<HeightRange> middle = oneRange(flutes, tooth.radius - pitchLine - inwards);
    return middle && middle->high - middle->low >= 0.5 * pitch - mostNarrower;
}

Error otherTool(std::string needed) {
    return {ErrorCode::notSupported, "this pass with this kind of tool", std::move(needed), {}};
}

} // namespace

Result<ThreadTooth> threadTooth(const Cutter& cutter, double pitch) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const std::optional<HeightRange> crest = oneRange(flutes, cutter.radius() - inwards);
    const ThreadTooth tooth{cutter.radius(), crest ? 0.5 * (crest->low + crest->high) : 0.0};
    if (!crest || !fitsGroove(flutes, tooth, pitch))
        return otherTool("a thread mill with one tooth for a pitch of " + formatShortest(pitch) + " mm");
    const double neck = 2.0 * (cutter.radius() - threadDepth(pitch));
    if (cutter.stickOut > cutter.fluteLength && cutter.shankDiameter > neck)
        return otherTool("a thread mill with a neck of at most " + formatFixed(neck, 2) + " mm");
    return tooth;
}

} // namespace burin
