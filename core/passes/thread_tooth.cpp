// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_tooth.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/passes/thread_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Whether flanks of 60° begin at the flat of a tooth, as far as the crests of an external thread.
bool hasFlanks(const std::vector<RevolvedPiece>& flutes, const ThreadTooth& tooth, double depth) {
    constexpr int looks = 32;
    for (int i = 0; i <= looks; ++i) {
        const double in = depth * i / looks, half = 0.5 * tooth.flat + in * std::tan(flank);
        const std::optional<HeightRange> range = oneRange(flutes, tooth.radius - in - inwards);
        if (!range || std::abs(range->low - tooth.height + half) > toothSlack ||
            std::abs(range->high - tooth.height - half) > toothSlack)
            return false;
    }
    return true;
}

/// The outermost part of the flutes.
ThreadTooth crestOf(const Cutter& cutter, const std::vector<RevolvedPiece>& flutes) {
    const std::optional<HeightRange> crest = oneRange(flutes, cutter.radius() - inwards);
    if (!crest) return {cutter.radius(), 0.0, -1.0};
    return {cutter.radius(), 0.5 * (crest->low + crest->high), crest->high - crest->low};
}

Error otherTool(std::string needed) {
    return {ErrorCode::notSupported, "this pass with this kind of tool", std::move(needed), {}};
}

Error toothFor(double pitch) {
    return otherTool("a thread mill with one tooth for a pitch of " + formatShortest(pitch) + " mm");
}

/// The tooth, if the neck above it passes the crests of the thread. @param depth mm, of the thread
Result<ThreadTooth> withNeck(const Cutter& cutter, const ThreadTooth& tooth, double depth) {
    const double neck = 2.0 * (cutter.radius() - depth);
    if (cutter.stickOut > cutter.fluteLength && cutter.shankDiameter > neck)
        return otherTool("a thread mill with a neck of at most " + formatFixed(neck, 2) + " mm");
    return tooth;
}

} // namespace

Result<ThreadTooth> threadTooth(const Cutter& cutter, double pitch) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const ThreadTooth tooth = crestOf(cutter, flutes);
    if (tooth.flat < 0.0 || !fitsGroove(flutes, tooth, pitch)) return toothFor(pitch);
    return withNeck(cutter, tooth, threadDepth(pitch));
}

Result<ThreadTooth> externalThreadTooth(const Cutter& cutter, double pitch) {
    const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
    const ThreadTooth tooth = crestOf(cutter, flutes);
    const double depth = externalDepth(pitch, tooth.flat);
    if (tooth.flat < 0.125 * pitch - toothSlack || tooth.flat > 0.25 * pitch + toothSlack ||
        !hasFlanks(flutes, tooth, depth))
        return toothFor(pitch);
    return withNeck(cutter, tooth, depth);
}

double neckLength(const Cutter& cutter, double depth) {
    constexpr double crestFit = 1e-6; // mm: a neck of exactly this size passes
    const std::vector<RevolvedPiece> tool = pieces(cutter);
    double length = std::numeric_limits<double>::infinity();
    for (std::size_t i = flutePieces(cutter).size(); i < tool.size(); ++i)
        if (const std::optional<HeightRange> wide = heightsAt(tool[i], cutter.radius() - depth + crestFit))
            length = std::min(length, wide->low);
    return length;
}

} // namespace burin
