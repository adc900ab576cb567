// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/surface_check.h"

#include "core/field/spread.h"
#include "tests/part_field/block_corners.h"
#include "tests/part_field/surface_points.h"

#include <algorithm>
#include <atomic>

namespace burin {

namespace {

constexpr std::int32_t coarse = PartFieldLayers::coarse;
constexpr float mostDisagreement = 0.01F;           // voxels, between adjacent bricks
constexpr double pointSpacing = 1.5;                // voxels, on large triangles
constexpr double narrowFacet = 2.0;                 // voxels
constexpr std::uint32_t allAround = (1U << 27) - 1; // a bit for each brick around one, x running fastest

constexpr int bitOf(const glm::ivec3& step) noexcept {
    return 13 + step.x + 3 * step.y + 9 * step.z;
}

} // namespace

std::vector<std::size_t> SurfaceCheck::contradicted(Progress& progress) {
    std::vector<std::uint8_t> wrong(candidates_.size(), 0);
    const std::vector<std::uint32_t> doubtful = findDoubtful(wrong, progress);
    const std::span<const Triangle> triangles = part_.triangles();
    const auto checkInterval = [&](std::size_t first, std::size_t end) {
        SurfacePoints points;
        for (std::size_t i = first; i < end; ++i)
            points.of(triangles[i], pointSpacing * layers_.request.voxel,
                      [&](const glm::dvec3& point, double width) { check(point, width, doubtful, wrong); });
    };
    // The longer the range, the fewer corners are visited in two of them.
    spreadIntervals(triangles.size(), 0.85, 0.92, progress, checkInterval, 1024);
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        if (wrong[i] != 0) numbers.push_back(i);
    return numbers;
}

std::vector<std::size_t> SurfaceCheck::contradictedBy(std::span<const std::size_t> last,
                                                      const std::vector<std::uint8_t>& asked) const {
    std::vector<std::size_t> numbers;
    for (const std::size_t number : last)
        for (int side = 0; side < 6; ++side) {
            glm::ivec3 step(0);
            const int axis = side / 2, towards = 2 * (side % 2) - 1;
            step[axis] = towards;
            const std::int32_t next = candidateAt(layers_, candidates_[number].brick + step);
            if (next == coarse || !isFine(next) || asked[static_cast<std::size_t>(next)] != 0) continue;
            const auto place = static_cast<std::size_t>(next);
            const MadeBrick &own = made_[number], &other = made_[place];
            const float apart = towards > 0 ? disagreement(own, other, axis) : disagreement(other, own, axis);
            if (apart > own.sampleBound + other.sampleBound) numbers.push_back(place);
        }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

/// For each candidate, the neighbours that the points in it must be checked against: those that turned out not to be
/// fine, and all if one disagrees. If two disagree by more than both bounds, one or both are wrong.
std::vector<std::uint32_t> SurfaceCheck::findDoubtful(std::vector<std::uint8_t>& wrong, Progress& progress) const {
    std::vector<std::uint32_t> doubtful(candidates_.size(), 0);
    spread(candidates_.size(), 0.82, 0.85, progress, [&](std::size_t number) {
        if (candidates_[number].fine) doubt(number, doubtful, wrong);
    });
    return doubtful;
}

void SurfaceCheck::doubt(std::size_t number, std::vector<std::uint32_t>& doubtful,
                         std::vector<std::uint8_t>& wrong) const {
    std::uint32_t around = 0;
    for (int bit = 0; bit < 27; ++bit) {
        const glm::ivec3 step = glm::ivec3(bit % 3, bit / 3 % 3, bit / 9) - 1;
        const std::int32_t next = candidateAt(layers_, candidates_[number].brick + step);
        if (next != coarse && !isFine(next)) around |= 1U << bit;
    }
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 step(0);
        step[axis] = 1;
        const std::int32_t next = candidateAt(layers_, candidates_[number].brick + step);
        if (next == coarse || !isFine(next)) continue;
        const auto place = static_cast<std::size_t>(next);
        const float apart = disagreement(made_[number], made_[place], axis);
        if (apart > made_[number].sampleBound + made_[place].sampleBound)
            for (const std::size_t one : {number, place})
                std::atomic_ref(wrong[one]).store(1, std::memory_order_relaxed);
        if (apart <= inMillimetres(mostDisagreement)) continue;
        around = allAround;
        std::atomic_ref(doubtful[place]).fetch_or(allAround, std::memory_order_relaxed);
    }
    std::atomic_ref(doubtful[number]).fetch_or(around, std::memory_order_relaxed);
}

void SurfaceCheck::check(const glm::dvec3& point, double width, const std::vector<std::uint32_t>& doubtful,
                         std::vector<std::uint8_t>& wrong) {
    const glm::dvec3 place = (point - layers_.origin) * perVoxel_;
    const glm::ivec3 home = glm::ivec3(place) >> 3;
    const glm::dvec3 at = place - 8.0 * glm::dvec3(home);
    const std::int32_t own = candidateAt(layers_, home);
    if (own != coarse && width * perVoxel_ > narrowFacet) meetFacet(static_cast<std::size_t>(own), width * perVoxel_);
    const bool answers = own != coarse && !contradicts(static_cast<std::size_t>(own), glm::vec3(at), 0.0F);
    const std::uint32_t around = answers ? doubtful[static_cast<std::size_t>(own)] : allAround;
    if (around == 0) return;
    const glm::ivec3 side = glm::mix(glm::ivec3(-1), glm::ivec3(1), glm::greaterThan(at, glm::dvec3(4.0)));
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 step = side * cornerOf(i);
        if (((around >> bitOf(step)) & 1U) == 0) continue;
        const std::int32_t number = candidateAt(layers_, home + step);
        if (number == coarse) continue;
        const glm::vec3 local(at - 8.0 * glm::dvec3(step)), inside = glm::clamp(local, 0.0F, 8.0F);
        const float away = glm::length(local - inside);
        if (away <= BrickMaker::bandVoxels && contradicts(static_cast<std::size_t>(number), inside, away))
            std::atomic_ref(wrong[static_cast<std::size_t>(number)]).store(1, std::memory_order_relaxed);
    }
}

void SurfaceCheck::meetFacet(std::size_t number, double width) noexcept {
    const auto whole = static_cast<std::uint8_t>(std::min(width, 255.0));
    const std::atomic_ref facet(facetWidth_[number]);
    if (facet.load(std::memory_order_relaxed) >= whole) return;
    facet.store(whole, std::memory_order_relaxed); // of two stores at once either is correct: both are wide
    anyFacet_.store(true, std::memory_order_relaxed);
}

bool SurfaceCheck::isFacetNear(std::size_t number, int width) const noexcept {
    if (!anyFacet_.load(std::memory_order_relaxed)) return false;
    constexpr int reach = 2; // bricks within which the nearest point of the surface may be
    const glm::ivec3& middle = candidates_[number].brick;
    for (int z = -reach; z <= reach; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const std::int32_t near = candidateAt(layers_, middle + glm::ivec3(x, y, z));
                if (near != coarse && facetWidth_[static_cast<std::size_t>(near)] >= width) return true;
            }
    return false;
}

bool SurfaceCheck::contradicts(std::size_t number, const glm::vec3& inside, float away) const noexcept {
    if (!candidates_[number].fine) return true;
    const MadeBrick& made = made_[number];
    const float allowed = inMillimetres(away) + made.bound;
    return std::abs(distanceIn(made, inside)) > allowed && !isExactIn(made, inside);
}

} // namespace burin
