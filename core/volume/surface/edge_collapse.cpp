// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/edge_collapse.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
enum State : std::uint8_t { open, tried, fixed, gone }; // of a point

constexpr std::size_t mostNeighbours = 32;
constexpr int mostSweeps = 24;
/// Least cosine of the angle by which a triangle may turn in one step, and in total away from the surface's own
/// normals.
constexpr float leastTurn = 0.3F, leastLean = 0.2F;

} // namespace

void EdgeCollapse::run(std::span<const glm::vec3> points, std::span<const glm::vec3> normals,
                       std::vector<std::uint32_t>& triangles, std::vector<SurfaceRegion>& regions, float tolerance) {
    points_ = points;
    normals_ = normals;
    triangles_ = &triangles;
    regions_ = &regions;
    link();
    for (const float part : {0.05F, 0.3F, 1.0F}) {
        for (std::uint8_t& state : state_)
            if (state == tried) state = open;
        for (int i = 0; i < mostSweeps && sweep(part * tolerance); ++i) {
        }
    }
    std::size_t kept = 0;
    for (std::size_t triangle = 0; triangle < regions.size(); ++triangle) {
        if (triangles[3 * triangle] == none) continue;
        for (std::size_t i = 0; i < 3; ++i) triangles[3 * kept + i] = triangles[3 * triangle + i];
        regions[kept++] = regions[triangle];
    }
    triangles.resize(3 * kept);
    regions.resize(kept);
}

void EdgeCollapse::link() {
    firstCorner_.assign(points_.size(), none);
    nextCorner_.resize(triangles_->size());
    for (std::uint32_t corner = 0; corner < triangles_->size(); ++corner) {
        std::uint32_t& first = firstCorner_[(*triangles_)[corner]];
        nextCorner_[corner] = first;
        first = corner;
    }
    moved_.assign(points_.size(), 0.0F);
    state_.assign(points_.size(), open);
    touched_.assign(points_.size(), 0);
    stamp_.assign(points_.size(), 0);
    sweep_ = mark_ = 0;
}

/// False: another sweep would not help.
bool EdgeCollapse::sweep(float tolerance) {
    ++sweep_;
    std::size_t collapsed = 0;
    for (std::uint32_t point = 0; point < points_.size(); ++point) {
        if (state_[point] != open || touched_[point] == sweep_) continue;
        if (firstCorner_[point] == none || !readStar(point)) {
            state_[point] = fixed;
            continue;
        }
        if (tryCollapse(point, tolerance))
            ++collapsed;
        else
            state_[point] = tried;
    }
    return collapsed > 0;
}

/// False: the triangles around the point do not form a closed fan.
bool EdgeCollapse::readStar(std::uint32_t point) {
    star_.clear();
    for (std::uint32_t corner = firstCorner_[point]; corner != none; corner = nextCorner_[corner]) {
        const std::uint32_t triangle = corner / 3, place = corner % 3;
        star_.push_back(
            {(*triangles_)[3 * triangle + (place + 1) % 3], (*triangles_)[3 * triangle + (place + 2) % 3], triangle});
    }
    return orderStar();
}

bool EdgeCollapse::orderStar() {
    for (std::size_t i = 0; i + 1 < star_.size(); ++i) {
        std::size_t next = i + 1;
        while (next < star_.size() && star_[next].first != star_[i].second) ++next;
        if (next == star_.size()) return false;
        std::swap(star_[i + 1], star_[next]);
    }
    if (star_.size() < 3 || star_.back().second != star_.front().first) return false;
    ++mark_;
    for (const Side& side : star_) { // a neighbour that occurs twice: two sheets that touch
        if (stamp_[side.first] == mark_) return false;
        stamp_[side.first] = mark_;
    }
    return true;
}

/// The neighbours have been stamped with `mark_` since orderStar.
bool EdgeCollapse::tryCollapse(std::uint32_t point, float tolerance) {
    if (star_.size() > mostNeighbours || !findBorderOfRegions()) return false;
    sortTargets(point);
    const float allowed = tolerance - moved_[point];
    for (const std::uint32_t target : targets_) {
        float moved = 0.0F;
        if (!border_.empty() && !borderStaysClose(point, target, allowed, moved)) continue;
        if (!staysClose(point, target, allowed, moved) || !linkIsSound(target)) continue;
        collapse(point, target, moved);
        return true;
    }
    return false;
}

/// False: a border ends here, or more than two regions meet.
bool EdgeCollapse::findBorderOfRegions() {
    border_.clear();
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const Side& before = star_[i == 0 ? star_.size() - 1 : i - 1];
        if ((*regions_)[before.triangle].bordersOn((*regions_)[star_[i].triangle])) border_.push_back(star_[i].first);
    }
    return border_.empty() || border_.size() == 2;
}

void EdgeCollapse::sortTargets(std::uint32_t point) {
    targets_ = border_;
    if (border_.empty())
        for (const Side& side : star_) targets_.push_back(side.first);
    const auto distance = [&](std::uint32_t target) {
        const glm::vec3 way = points_[target] - points_[point];
        return glm::dot(way, way);
    };
    std::sort(targets_.begin(), targets_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const float toA = distance(a), toB = distance(b);
        return toA < toB || (toA == toB && a < b);
    });
}

/// Only the two points opposite the edge may be neighbours of both its ends; otherwise two sheets would be joined.
bool EdgeCollapse::linkIsSound(std::uint32_t target) {
    std::uint32_t before = none, behind = none;
    for (const Side& side : star_) {
        if (side.first == target) behind = side.second;
        if (side.second == target) before = side.first;
    }
    const auto fits = [&](std::uint32_t point) { return stamp_[point] != mark_ || point == before || point == behind; };
    for (std::uint32_t corner = firstCorner_[target]; corner != none; corner = nextCorner_[corner]) {
        const std::uint32_t triangle = corner / 3, place = corner % 3;
        if (!fits((*triangles_)[3 * triangle + (place + 1) % 3]) ||
            !fits((*triangles_)[3 * triangle + (place + 2) % 3]))
            return false;
    }
    return true;
}

bool EdgeCollapse::staysClose(std::uint32_t point, std::uint32_t target, float allowed, float& moved) const {
    const glm::vec3 from = points_[point], to = points_[target];
    for (const Side& side : star_) {
        if (side.first == target || side.second == target) continue;
        const glm::vec3 &a = points_[side.first], &b = points_[side.second];
        const glm::vec3 along = b - a, before = glm::cross(along, from - b), after = glm::cross(along, to - b);
        const float size = glm::dot(after, after);
        const float turn = glm::dot(before, after);
        if (turn <= 0.0F || turn * turn < leastTurn * leastTurn * size * glm::dot(before, before)) return false;
        const float length = std::sqrt(size);
        const float distance = std::abs(glm::dot(after, from - a));
        if (distance > allowed * length) return false;
        for (const std::uint32_t corner : {side.first, side.second, target})
            if (glm::dot(after, normals_[corner]) < leastLean * length) return false;
        moved = std::max(moved, distance / length);
    }
    return true;
}

/// The border between two regions becomes straight here.
bool EdgeCollapse::borderStaysClose(std::uint32_t point, std::uint32_t target, float allowed, float& moved) const {
    const glm::vec3& other = points_[border_[0] == target ? border_[1] : border_[0]];
    const float distance = distanceToSegment(points_[point], points_[target], other);
    moved = std::max(moved, distance);
    return distance <= allowed;
}

void EdgeCollapse::collapse(std::uint32_t point, std::uint32_t target, float moved) {
    for (const Side& side : star_) { // the points opposite the edge lose a triangle
        if (side.first == target || side.second == target)
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t corner = 3 * side.triangle + i;
                std::uint32_t* link = &firstCorner_[(*triangles_)[corner]];
                while (*link != corner) link = &nextCorner_[*link];
                *link = nextCorner_[corner];
            }
    }
    const float total = moved_[point] + moved;
    for (const Side& side : star_) {
        if (side.first == target || side.second == target)
            for (std::uint32_t i = 0; i < 3; ++i) (*triangles_)[3 * side.triangle + i] = none;
        touched_[side.first] = sweep_;
        moved_[side.first] = std::max(moved_[side.first], total);
        if (state_[side.first] == tried) state_[side.first] = open;
    }
    for (std::uint32_t corner = firstCorner_[point]; corner != none;) {
        const std::uint32_t next = nextCorner_[corner];
        (*triangles_)[corner] = target;
        nextCorner_[corner] = firstCorner_[target];
        firstCorner_[target] = corner;
        corner = next;
    }
    firstCorner_[point] = none;
    state_[point] = gone;
}

} // namespace burin
