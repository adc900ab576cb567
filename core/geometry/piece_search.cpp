// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/piece_search.h"

#include <algorithm>

namespace burin {

namespace {

constexpr int longestDescent = 64; // triangles
constexpr double onRidge = 1e-6;   // mm: precision of minima over triangles

} // namespace

PieceSearch::PieceSearch(const TriangleTree& tree, const SurfaceNormals& normals, const PlacedPiece& piece,
                         std::size_t number, double floor, const ClearanceTolerance& tolerance, Found& found) noexcept
    : tree_(tree)
    , normals_(normals)
    , piece_(piece)
    , number_(number)
    , tolerance_(tolerance)
    , found_(found)
    , near_(tree, piece, floor) {
    near_.limit(wanted());
}

double PieceSearch::atCentroid(std::size_t slot) const noexcept {
    const auto& [a, b, c] = triangle(slot);
    return piece_.at((a + b + c) / 3.0).distance;
}

void PieceSearch::descend() noexcept {
    std::size_t slot = found_.slot;
    double least = atCentroid(slot);
    for (int step = 0; step < longestDescent; ++step) {
        std::size_t best = slot;
        for (const std::uint32_t next : normals_.neighbours(slot)) {
            if (next == SurfaceNormals::none) continue;
            const double there = atCentroid(next);
            if (!(there < least)) continue;
            least = there;
            best = next;
        }
        if (best == slot) break;
        slot = best;
    }
    // The minimum over the surface is in that triangle, or beyond an edge on which the minimum over the triangle lies.
    const std::size_t start = slot;
    if (!solve(start, found_.distance)) return;
    for (int step = 0; step < 4; ++step) {
        const std::size_t from = found_.slot;
        const TriangleFeature feature = found_.feature;
        if (feature == TriangleFeature::face) return;
        bool less = false;
        for (int edge = 0; edge < 3; ++edge) {
            const bool beside = feature == edgeFeature(edge) || feature == cornerFeature(edge) ||
                                feature == cornerFeature((edge + 1) % 3);
            const std::uint32_t next = normals_.neighbours(from)[static_cast<std::size_t>(edge)];
            if (beside && next != SurfaceNormals::none) less = solve(next, found_.distance) || less;
        }
        if (!less) return;
    }
}

void PieceSearch::take(const Found& better) noexcept {
    found_.improve(better);
    near_.limit(wanted());
}

bool PieceSearch::solve(std::size_t slot, double below) noexcept {
    found_.work += workOfMinimum;
    const auto least = minimumOverTriangle(piece_, triangle(slot), below);
    if (!least) return false;
    take({slot, least->point, least->feature, least->distance, number_, true});
    return true;
}

/// Where the surface bends away from the tool, no better point lies above the plane through the point found.
void PieceSearch::layPlane() noexcept {
    hasPlane_ = found_.any && found_.piece == number_;
    if (!hasPlane_) return;
    plane_ = supportingPlane(piece_, found_.point, unitNormal(triangle(found_.slot)), onRidge);
    near_.stayAbove(AbovePlane(tree_, plane_));
}

double PieceSearch::abovePlane(const Triangle& of) const noexcept {
    if (!hasPlane_) return -std::numeric_limits<double>::infinity();
    return plane_.value +
           std::min({glm::dot(plane_.slope, of[0] - plane_.at), glm::dot(plane_.slope, of[1] - plane_.at),
                     glm::dot(plane_.slope, of[2] - plane_.at)});
}

/// Each triangle is first evaluated once: most are ruled out before a minimum over the triangle has to be computed.
void PieceSearch::meet(std::size_t slot) noexcept {
    ++found_.work;
    const auto dropsOut = [this](double below) noexcept {
        const bool drops = below >= wanted();
        if (drops) passed_ = std::min(passed_, below);
        return drops;
    };
    if (dropsOut(abovePlane(triangle(slot)))) return;
    const TriangleBounds bounds = boundsOverTriangle(piece_, triangle(slot));
    if (dropsOut(bounds.below)) return;
    if (bounds.above < wanted()) take({slot, bounds.centroid, TriangleFeature::face, bounds.above, number_, true});
    if (count_ == candidates_.size()) { // some will be ruled out by now
        const auto end = std::remove_if(candidates_.begin(), candidates_.end(),
                                        [&](const Candidate& c) { return dropsOut(c.below); });
        count_ = static_cast<std::size_t>(end - candidates_.begin());
    }
    if (count_ < candidates_.size())
        candidates_[count_++] = {bounds.below, slot};
    else if (solve(slot, wanted()))
        layPlane();
}

double PieceSearch::run() noexcept {
    layPlane();
    const float nodes = walk(tree_, near_, [this](std::size_t slot) noexcept { meet(slot); });
    const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(candidates_.begin(), end, [](const Candidate& a, const Candidate& b) { return a.below < b.below; });
    for (auto candidate = candidates_.begin(); candidate != end; ++candidate) {
        if (candidate->below >= wanted()) break;
        if (abovePlane(triangle(candidate->slot)) < wanted() && solve(candidate->slot, wanted())) layPlane();
    }
    // A candidate that was solved or left over has nothing below the distance that is now required.
    const double passed = std::min(passed_, static_cast<double>(nodes));
    return count_ > 0 ? std::min(passed, wanted()) : passed;
}

} // namespace burin
