// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/exact_cell_finder.h"

#include "core/field/cube.h"

#include <algorithm>
#include <bit>

namespace burin {

namespace {

constexpr float opposed = -0.5F;                      // cosine between normals: the sides of a gap or a wall
constexpr float inclined = 0.97F;                     // the sides of any fold
constexpr std::uint64_t lowX = 0x0101010101010101ULL; // cells with x = 0

bool holds(const CellMask& cells, int z, int place) noexcept {
    return ((cells[static_cast<std::size_t>(z)] >> place) & 1U) != 0;
}
void add(CellMask& cells, int z, int place) noexcept {
    cells[static_cast<std::size_t>(z)] |= std::uint64_t{1} << place;
}
bool any(const CellMask& cells) noexcept {
    return std::ranges::any_of(cells, [](std::uint64_t layer) { return layer != 0; });
}

/// Extends a set of cells within its layer by one cell in each direction.
std::uint64_t spreadLayer(std::uint64_t layer) noexcept {
    layer |= ((layer & ~(lowX << 7)) << 1) | ((layer & ~lowX) >> 1);
    return layer | (layer << 8) | (layer >> 8);
}
CellMask spreadCells(const CellMask& cells) noexcept {
    CellMask flat, all;
    for (std::size_t z = 0; z < 8; ++z) flat[z] = spreadLayer(cells[z]);
    for (std::size_t z = 0; z < 8; ++z) all[z] = flat[z] | (z > 0 ? flat[z - 1] : 0) | (z < 7 ? flat[z + 1] : 0);
    return all;
}
CellMask without(CellMask cells, const CellMask& others) noexcept {
    for (std::size_t z = 0; z < 8; ++z) cells[z] &= ~others[z];
    return cells;
}

} // namespace

CellMask cellsBeside(const CellMask& cells, const glm::ivec3& step) noexcept {
    CellMask beside{};
    if (step.z != 0) {
        beside[step.z > 0 ? 0 : 7] = spreadLayer(cells[step.z > 0 ? 7 : 0]);
        return beside;
    }
    CellMask face{};
    for (std::size_t z = 0; z < 8; ++z) {
        const std::uint64_t layer = cells[z];
        if (step.x != 0)
            face[z] = step.x > 0 ? (layer >> 7) & lowX : (layer & lowX) << 7;
        else
            face[z] = step.y > 0 ? layer >> 56 : layer << 56;
    }
    const std::uint64_t plane = step.x != 0 ? (step.x > 0 ? lowX : lowX << 7) : (step.y > 0 ? 0xFFULL : 0xFFULL << 56);
    beside = spreadCells(face);
    for (std::uint64_t& layer : beside) layer &= plane;
    return beside;
}

ExactCellFinder::Found ExactCellFinder::list(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made) {
    Found found;
    begin(corner, made);
    take(wanted, found);
    addFolded(without(spreadCells(made.thinMask), wanted), opposed, true, found);
    sortCells();
    return found;
}

ExactCellFinder::Found ExactCellFinder::listClosely(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made) {
    Found found;
    begin(corner, made);
    take(wanted, found);
    CellMask all;
    all.fill(~std::uint64_t{0});
    addFolded(without(all, wanted), inclined, false, found);
    sortCells();
    return found;
}

bool ExactCellFinder::grow(const glm::dvec3& corner, const CellMask& seeds, MadeBrick& made) {
    Found found;
    made_ = &made;
    corner_ = corner;
    listed_.clear();
    lastBegin_ = made.lists.size();
    std::size_t number = 0;
    for (int z = 0; z < 8; ++z)
        for (int place = 0; place < 64; ++place)
            if (holds(made.exactMask, z, place)) listed_.push_back({64 * z + place, made.cellLists[number++]});
    const CellMask before = made.thinMask;
    addFolded(without(seeds, made.exactMask), opposed, true, found);
    sortCells();
    made.bound = std::max(made.bound, static_cast<float>(static_cast<double>(found.error) * voxel_));
    return before != made.thinMask;
}

void ExactCellFinder::begin(const glm::dvec3& corner, MadeBrick& made) {
    made_ = &made;
    corner_ = corner;
    listed_.clear();
    made.exactMask = made.lookedMask = made.thinMask = {};
    made.lists.clear();
    lastBegin_ = 0;
}

void ExactCellFinder::take(const CellMask& wanted, Found& found) {
    for (int z = 0; z < 8; ++z)
        for (int place = 0; place < 64; ++place) {
            if (!holds(wanted, z, place)) continue;
            triangles_.find(centreOf(z, place));
            if (triangles_.isFolded(opposed)) add(made_->thinMask, z, place);
            const std::span<const std::uint32_t> list = triangles_.numbers();
            if (list.empty())
                add(found.tooMany, z, place); // quicker as it is
            else
                append(z, place, list);
        }
}

/// Examines cells; if the surface folds in one and `spreads` is set, examines the cells next to it as well.
void ExactCellFinder::addFolded(CellMask cells, float cosine, bool spreads, Found& found) {
    CellMask& looked = made_->lookedMask;
    const auto open = [&](const CellMask& some) { return without(without(some, looked), made_->exactMask); };
    for (cells = open(cells); any(cells); cells = open(cells)) {
        CellMask folded{};
        for (int z = 0; z < 8; ++z)
            for (int place = 0; place < 64; ++place) {
                if (!holds(cells, z, place)) continue;
                add(looked, z, place);
                const bool folds = triangles_.findFold(centreOf(z, place), cosine);
                found.error = std::max(found.error, triangles_.unseen());
                if (!folds) continue;
                add(folded, z, place);
                if (triangles_.isFolded(opposed)) add(made_->thinMask, z, place);
                const std::span<const std::uint32_t> list = triangles_.numbers();
                if (list.empty())
                    found.error = halfDiagonalAbove;
                else
                    append(z, place, list);
            }
        cells = spreads ? spreadCells(folded) : CellMask{};
    }
}

glm::dvec3 ExactCellFinder::centreOf(int z, int place) const noexcept {
    return corner_ + glm::dvec3(place % 8, place / 8, z) + 0.5;
}

void ExactCellFinder::append(int z, int place, std::span<const std::uint32_t> list) {
    std::vector<std::uint32_t>& lists = made_->lists;
    const bool same = lastBegin_ < lists.size() && lists[lastBegin_] == list.size() &&
                      std::equal(list.begin(), list.end(), lists.begin() + static_cast<std::ptrdiff_t>(lastBegin_) + 1);
    if (!same) {
        lastBegin_ = lists.size();
        lists.push_back(static_cast<std::uint32_t>(list.size()));
        lists.insert(lists.end(), list.begin(), list.end());
    }
    add(made_->exactMask, z, place);
    listed_.push_back({64 * z + place, static_cast<std::uint32_t>(lastBegin_)});
}

void ExactCellFinder::sortCells() {
    std::ranges::sort(listed_, {}, &Listed::cell);
    made_->cellLists.clear();
    for (const Listed& listed : listed_) made_->cellLists.push_back(listed.list);
}

} // namespace burin
