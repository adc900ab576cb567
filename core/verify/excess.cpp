// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/excess.h"
#include "core/base/parallel.h"
#include "core/tool/piece_profile.h"
#include "core/verify/left_over.h"
#include "core/verify/surface_places.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr double longestExcess = 20.0;  // mm; beyond it the stock was simply never touched
constexpr double reachableDepth = 0.01; // mm: what the mesh's chord may cost

/// A place with stock over it that faces a cutter from above: one of the tools may reach it.
struct Covered {
    std::size_t sample = 0;
    glm::dvec3 normal{0.0};
};

/// Tip of the cutter when it touches the part at a place with this normal: with the point of the flutes that lies
/// farthest against the normal. A hollow cutter may touch with others; what it reaches with those is not counted.
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

/// A tool, ready to be asked what it can touch.
struct TouchingTool {
    explicit TouchingTool(const Tool& tool) : stack(pieces(tool.cutter)) {
        std::reverse(stack.begin(), stack.end()); // a wide holder is told quickest that it has no room
        for (const RevolvedPiece& piece : flutePieces(tool.cutter)) flutes.emplace_back(piece);
    }

    std::vector<RevolvedPiece> stack;
    std::vector<PieceProfile> flutes;
};

bool facesACutter(const glm::dvec3& normal) noexcept {
    return normal.z >= -1e-6;
}

/// Stock over every place, bare ones judged. @return the others that a tool may reach
std::vector<Covered> measureStock(const RunVolume& workpiece, const SurfacePlaces& places,
                                  std::vector<DeviationSample>& samples, const Progress& progress) {
    constexpr std::size_t length = 4096;
    const LeftOver left(workpiece);
    std::vector<std::vector<Covered>> batches((places.count() + length - 1) / length);
    parallelFor(std::size_t{0}, batches.size(), [&](std::size_t batch) {
        if (progress.cancelled()) return;
        const std::size_t first = batch * length, end = std::min(first + length, places.count());
        places.forEach(first, end, [&](std::size_t i, const glm::dvec3& place, const glm::dvec3& normal) {
            const double excess = left.along(place, normal, longestExcess);
            const bool faces = facesACutter(normal);
            // What is bare and faces a cutter from above needs no proof that one gets there.
            samples[i] = {place, excess, 0.0, faces && excess == 0.0};
            if (faces && excess > 0.0) batches[batch].push_back({i, normal});
        });
    });
    std::vector<Covered> covered;
    for (const std::vector<Covered>& batch : batches) covered.insert(covered.end(), batch.begin(), batch.end());
    return covered;
}

/// Marks what a tool reaches of the places; keeps the rest.
void markReached(const VerifyRequest& request, const TouchingTool& tool, double lowest, std::vector<Covered>& covered,
                 std::vector<DeviationSample>& samples, const Progress& progress) {
    std::vector<glm::dvec3> tips(covered.size());
    parallelStretches(std::size_t{0}, covered.size(), 4096, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i != to; ++i)
            tips[i] = touchingTip(tool.flutes, samples[covered[i].sample].place, covered[i].normal);
    });
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (tips[i].z < lowest - 1e-6) continue;
        tips[asked.size()] = tips[i];
        asked.push_back(i);
    }
    tips.resize(asked.size());
    const std::vector<std::uint8_t> entered =
        request.part->entered(tool.stack, {0.0, 0.0, 1.0}, tips, reachableDepth, progress);
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (entered[i] == 0) samples[covered[asked[i]].sample].reachable = true;
    std::erase_if(covered, [&](const Covered& place) { return samples[place.sample].reachable; });
}

} // namespace

Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, Progress& progress) {
    SurfacePlaces places(workpiece.grid().edge());
    for (const Body& body : request.model->bodies) places.add(body.mesh);
    std::vector<DeviationSample> samples(places.count());
    std::vector<Covered> covered = measureStock(workpiece, places, samples, progress);
    const double lowest = request.model->box().low.z;
    for (const Tool& tool : tools) markReached(request, TouchingTool(tool), lowest, covered, samples, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    return samples;
}

} // namespace burin
