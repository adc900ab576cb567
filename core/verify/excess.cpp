// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/excess.h"
#include "core/base/parallel.h"
#include "core/tool/piece_profile.h"
#include "core/verify/left_over.h"
#include "core/verify/surface_places.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace burin {

namespace {

constexpr double reachableDepth = 0.01; // mm: allows for the chord of the mesh

/// A point with stock over it that faces a cutter from above: one of the tools may reach it.
struct Covered {
    std::uint32_t sample = 0;
    glm::dvec3 normal{0.0};
};

/// The tip of the cutter when it touches the part at a point with this normal: with the point of the flutes that lies
/// farthest against the normal. A hollow cutter may touch with other points; what it reaches with those is not counted.
glm::dvec3 touchingTip(std::span<const PieceProfile> flutes, const glm::dvec3& place, const glm::dvec3& normal) {
    const glm::dvec2 flat(normal);
    const double cosine = glm::length(flat);
    const glm::dvec2 outward = cosine > 1e-9 ? flat / cosine : glm::dvec2(0.0);
    ProfileDisc touching;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const PieceProfile& profile : flutes) {
        const ProfileDisc disc = profile.farthest(-normal.z, cosine);
        const double reach = disc.radius * cosine - disc.height * normal.z;
        if (reach <= farthest) continue;
        farthest = reach;
        touching = disc;
    }
    return {glm::dvec2(place) + touching.radius * outward, place.z - touching.height};
}

/// A tool, prepared for queries of what it can touch.
struct TouchingTool {
    explicit TouchingTool(const Tool& tool) : stack(pieces(tool.cutter)) {
        std::reverse(stack.begin(), stack.end()); // a wide holder is the quickest to find that there is no room
        for (const RevolvedPiece& piece : flutePieces(tool.cutter)) flutes.emplace_back(piece);
    }

    std::vector<RevolvedPiece> stack;
    std::vector<PieceProfile> flutes;
};

bool facesACutter(const glm::dvec3& normal) noexcept {
    return normal.z >= -1e-6;
}

/// Number of points that are processed together, from stock to reach, while other cores process others: few enough to
/// stay in the cache of the core, and enough that their tips lie close together in large groups.
std::size_t batchLength(std::size_t places) noexcept {
    return std::clamp<std::size_t>(places / 16, 8192, 65536);
}

/// Measures the stock over points `first` … `end` - 1, and judges bare ones. @return the others that a tool may reach
std::vector<Covered> measureStock(const LeftOver& left, const SurfacePlaces& places, std::size_t first, std::size_t end,
                                  std::span<DeviationSample> samples) {
    std::vector<Covered> covered;
    places.forEach(first, end, [&](std::size_t i, const glm::dvec3& place, const glm::dvec3& normal) {
        const double excess = left.along(place, normal, longestExcess);
        const bool faces = facesACutter(normal);
        // A bare point that faces a cutter from above needs no proof that a cutter gets there.
        samples[i] = {place, excess, 0.0, faces && excess == 0.0};
        if (faces && excess > 0.0) covered.push_back({static_cast<std::uint32_t>(i), normal});
    });
    return covered;
}

/// Marks the points that a tool reaches; keeps the others in `covered`.
void markReached(const VerifyRequest& request, const TouchingTool& tool, double lowest, std::vector<Covered>& covered,
                 std::span<DeviationSample> samples, const Progress& progress) {
    std::vector<glm::dvec3> tips;
    std::vector<std::size_t> asked;
    tips.reserve(covered.size());
    asked.reserve(covered.size());
    for (const Covered& place : covered) {
        const glm::dvec3 tip = touchingTip(tool.flutes, samples[place.sample].place, place.normal);
        if (tip.z < lowest - 1e-6) continue;
        tips.push_back(tip);
        asked.push_back(place.sample);
    }
    const std::vector<std::uint8_t> entered =
        request.part->entered(tool.stack, {0.0, 0.0, 1.0}, tips, reachableDepth, progress);
    for (std::size_t i = 0; i < asked.size(); ++i) samples[asked[i]].reachable = entered[i] == 0;
    std::erase_if(covered, [&](const Covered& place) { return samples[place.sample].reachable; });
}

/// Judges the points of a batch that have stock over them, unless the same ones were judged before.
void judgeReach(const VerifyRequest& request, const std::vector<TouchingTool>& tools, double lowest,
                std::vector<Covered> covered, std::span<DeviationSample> samples, KeptReach::Batch& kept,
                const Progress& progress) {
    if (std::ranges::equal(covered, kept.covered, {}, &Covered::sample)) {
        for (std::size_t i = 0; i < covered.size(); ++i) samples[covered[i].sample].reachable = kept.reached[i] != 0;
        return;
    }
    KeptReach::Batch judged;
    for (const Covered& point : covered) judged.covered.push_back(point.sample);
    for (const TouchingTool& tool : tools) markReached(request, tool, lowest, covered, samples, progress);
    for (const std::uint32_t sample : judged.covered) judged.reached.push_back(samples[sample].reachable ? 1 : 0);
    kept = std::move(judged);
}

} // namespace

std::size_t KeptReach::bytes() const noexcept {
    std::size_t bytes = 0;
    for (const Batch& batch : batches)
        bytes += sizeof(Batch) + batch.covered.capacity() * sizeof(std::uint32_t) + batch.reached.capacity();
    return bytes;
}

Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, KeptReach& kept, Progress& progress) {
    SurfacePlaces places(workpiece.grid().edge());
    for (const Body& body : request.protectedBodies().bodies) places.add(body.mesh);
    std::vector<DeviationSample> samples(places.count());
    const double lowest = request.protectedBodies().box().low.z;
    const std::vector<TouchingTool> touching(tools.begin(), tools.end());
    const LeftOver left(workpiece);
    const std::size_t length = batchLength(places.count());
    kept.batches.resize((places.count() + length - 1) / length);
    parallelFor(std::size_t{0}, kept.batches.size(), [&](std::size_t batch) {
        if (progress.cancelled()) return;
        const std::size_t first = batch * length, end = std::min(first + length, places.count());
        judgeReach(request, touching, lowest, measureStock(left, places, first, end, samples), samples,
                   kept.batches[batch], progress);
    });
    if (progress.cancelled()) {
        kept = {}; // what was not judged any more would count as not reached
        return Error{ErrorCode::cancelled, "verification", {}, {}};
    }
    return samples;
}

Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, Progress& progress) {
    KeptReach nothing;
    return measureExcess(workpiece, request, tools, nothing, progress);
}

ExcessSummary summaryOf(std::span<const DeviationSample> samples) noexcept {
    ExcessSummary summary;
    std::size_t reachable = 0;
    double sum = 0.0;
    for (const DeviationSample& sample : samples) {
        if (!sample.reachable) continue;
        ++reachable;
        sum += sample.excess;
        summary.most = std::max(summary.most, sample.excess);
    }
    if (reachable == 0) return summary;
    summary.mean = sum / static_cast<double>(reachable);
    summary.reachableShare = static_cast<double>(reachable) / static_cast<double>(samples.size());
    return summary;
}

} // namespace burin
