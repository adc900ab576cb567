// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/cell_triangles.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr double diagonal = 1.7320509;   // of a cell, voxels
constexpr std::size_t longList = 8;      // triangles: from this number on a second pass pays off
constexpr std::size_t longestList = 512; // that is examined
constexpr float alike = 0.99F;           // cosine between normals
constexpr double farthest = 8.0;         // voxels from the surface, up to which folds are searched for
constexpr float thin = 2.5F;             // voxels: samples detect wider features

} // namespace

/// A triangle that is nearest to some point of a cell is no farther from the cell's centre than the nearest triangle
/// plus twice the distance from the centre to a corner of the cell.
void CellTriangles::find(const glm::dvec3& centre) {
    gather(centre);
    if (near_.size() > longList) keepInEighths();
}

bool CellTriangles::findFold(const glm::dvec3& centre, float cosine) {
    gather(centre);
    if (far_ || !isFolded(cosine)) return false;
    keepInEighths();
    return isFolded(cosine);
}

void CellTriangles::gather(const glm::dvec3& centre) {
    centre_ = centre;
    distance_ = std::abs(static_cast<double>(asker_.ask(centre).distance));
    far_ = distance_ > farthest;
    const glm::dvec3 middle = origin_ + centre * voxel_;
    part_.trianglesNear(middle, (distance_ + diagonal) * voxel_, numbers_);
    near_.clear();
    crowded_ = numbers_.size() > longestList;
    if (crowded_) return;
    for (const std::uint32_t number : numbers_) {
        const Triangle& triangle = part_.triangles()[number];
        const glm::dvec3 normal = areaNormal(triangle);
        const double length = glm::length(normal);
        const glm::dvec3 way = closestOnTriangle(triangle, middle).point - middle;
        near_.push_back({number, false, length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F),
                         glm::vec3(way / voxel_), glm::length(way)});
    }
    std::ranges::sort(near_, {}, &Near::away);
}

float CellTriangles::unseen() const noexcept {
    if (!far_ && !crowded_) return 0.0F;
    const auto distance = static_cast<float>(std::max(distance_, 0.1));
    return std::min(thin * thin / (8.0F * distance), static_cast<float>(0.5 * diagonal));
}

/// The same for each eighth of the cell. Triangles nearer to the cell's centre come earlier.
void CellTriangles::keepInEighths() {
    for (Near& near : near_) near.wanted = false;
    squared_.resize(near_.size());
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 place = 0.25 * glm::dvec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
        const glm::dvec3 point = origin_ + (centre_ + place) * voxel_;
        const double off = glm::length(place) * voxel_, more = 0.5 * diagonal * voxel_;
        double least = std::numeric_limits<double>::infinity();
        std::size_t end = 0;
        for (; end < near_.size() && near_[end].away - off <= least + more; ++end) {
            const glm::dvec3 way = closestOnTriangle(part_.triangles()[near_[end].number], point).point - point;
            squared_[end] = glm::dot(way, way);
            if (squared_[end] < least * least) least = std::sqrt(squared_[end]);
        }
        for (std::size_t t = 0; t < end; ++t)
            if (squared_[t] <= (least + more) * (least + more)) near_[t].wanted = true;
    }
    std::erase_if(near_, [](const Near& near) { return !near.wanted; });
}

bool CellTriangles::fold(const Near& a, const Near& b, float cosine) noexcept {
    const glm::vec3 apart = a.place - b.place;
    return glm::dot(a.normal, b.normal) < cosine && glm::dot(apart, apart) < thin * thin;
}

/// Of adjacent triangles with similar normals, one represents all.
bool CellTriangles::isFolded(float cosine) {
    if (far_ || crowded_) return false;
    ones_.clear();
    for (std::size_t t = 0; t < near_.size(); ++t) {
        bool stoodFor = false;
        for (const std::size_t one : ones_) {
            if (fold(near_[t], near_[one], cosine)) return true;
            const glm::vec3 apart = near_[t].place - near_[one].place;
            stoodFor =
                stoodFor || (glm::dot(apart, apart) < 0.5F && glm::dot(near_[t].normal, near_[one].normal) > alike);
        }
        if (!stoodFor) ones_.push_back(t);
    }
    return false;
}

std::span<const std::uint32_t> CellTriangles::numbers() {
    if (crowded_ || near_.size() > most) return {};
    numbers_.clear();
    for (const Near& near : near_) numbers_.push_back(near.number);
    std::sort(numbers_.begin(), numbers_.end());
    return numbers_;
}

} // namespace burin
