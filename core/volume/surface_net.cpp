// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_net.h"

#include "core/volume/surface_cube.h"
#include "core/volume/surface_lanes.h"

#include <algorithm>
#include <array>
#include <bit>

namespace burin {

namespace {

constexpr int firstCube = SurfaceField::margin - 1; ///< column of the lowest cube beside the owned nodes
constexpr std::size_t wordBits = 64;

/// The bits begin … end - 1 of a row of words that lie in one of them.
std::uint64_t bitsBetween(int begin, int end, std::size_t word) {
    const auto below = [word](int bit) {
        const std::int64_t within = bit - static_cast<std::int64_t>(word * wordBits);
        if (within <= 0) return std::uint64_t{0};
        return within >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << within) - 1;
    };
    return below(end) & ~below(begin);
}

/// Visits the set bits of a row of words.
template <class Visit>
void eachBit(std::uint64_t word, std::size_t place, Visit visit) {
    for (; word != 0; word &= word - 1) visit(static_cast<int>(place * wordBits) + std::countr_zero(word));
}

} // namespace

void SurfaceNet::add(const SurfaceField& field, const Grid& grid, SurfaceMesh& mesh) {
    field_ = &field;
    columnsU_ = field.ownedU() + 2 * SurfaceField::margin;
    columnsV_ = field.ownedV() + 2 * SurfaceField::margin;
    count_ = field.filled().count;
    if (count_ == 0) return;
    words_ = (static_cast<std::size_t>(count_) + wordBits - 1) / wordBits;
    const int owned = field.filled().owned - field.filled().first;
    const int ownedEnd = field.filled().ownedEnd - field.filled().first;
    ownedNodes_.resize(words_);
    ownedCubes_.resize(words_);
    for (std::size_t word = 0; word < words_; ++word) {
        ownedNodes_[word] = bitsBetween(owned, ownedEnd, word);
        ownedCubes_[word] = bitsBetween(std::max(owned - 1, 1), ownedEnd, word);
    }
    axes_ = {grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    low_ = {grid.low()[axes_[0]], grid.low()[axes_[1]], grid.low()[axes_[2]]};
    size_ = grid.edge() * field.cell();
    findInside();
    addPoints(mesh);
    addFaces(mesh);
}

void SurfaceNet::findInside() {
    inside_.assign(static_cast<std::size_t>(columnsU_ * columnsV_) * words_, 0);
    const std::uint16_t half = field_->half();
    const auto count = static_cast<std::size_t>(count_);
    for (int u = firstCube; u < columnsU_ - firstCube; ++u)
        for (int v = firstCube; v < columnsV_ - firstCube; ++v) {
            const std::uint16_t* values = field_->column(u, v);
            std::uint64_t* words = inside_.data() + static_cast<std::size_t>(u * columnsV_ + v) * words_;
            for (std::size_t n = 0; n < count; n += 8)
                words[n / wordBits] |= std::uint64_t{insideBits(values + n, half)} << (n % wordBits);
        }
}

void SurfaceNet::addPoints(SurfaceMesh& mesh) {
    pointOfCube_.resize(static_cast<std::size_t>(columnsU_ * columnsV_) * static_cast<std::size_t>(count_));
    for (int u = firstCube; u < columnsU_ - SurfaceField::margin; ++u)
        for (int v = firstCube; v < columnsV_ - SurfaceField::margin; ++v) {
            const std::array columns{insideOf(u, v), insideOf(u + 1, v), insideOf(u, v + 1), insideOf(u + 1, v + 1)};
            for (std::size_t word = 0; word < words_; ++word) {
                std::uint64_t all = ~std::uint64_t{0}, any = 0;
                for (const std::uint64_t* column : columns) {
                    // A cube's upper nodes are the next bits, the first one of the next word among them.
                    const std::uint64_t next = word + 1 < words_ ? column[word + 1] << (wordBits - 1) : 0;
                    const std::uint64_t upper = (column[word] >> 1) | next;
                    all &= column[word] & upper;
                    any |= column[word] | upper;
                }
                eachBit(any & ~all & ownedCubes_[word], word, [&](int n) { addPoint(u, v, n, mesh); });
            }
        }
}

void SurfaceNet::addPoint(int u, int v, int n, SurfaceMesh& mesh) {
    pointOfCube_[static_cast<std::size_t>(u * columnsV_ + v) * static_cast<std::size_t>(count_) +
                 static_cast<std::size_t>(n)] = static_cast<std::uint32_t>(mesh.points.size());
    const CubeColumns columns(field_->column(u - 1, v - 1) + n - 1, static_cast<std::size_t>(columnsV_ * count_),
                              static_cast<std::size_t>(count_));
    const glm::vec3 within = columns.middleOfCrossings(field_->half());
    const glm::vec3 normal = columns.outwards(within, field_->half(), field_->cell() == 1 ? 1 : 3);
    // From the grid's own counts, so that it comes out alike in every tile and brick.
    const glm::dvec3 node =
        glm::dvec3(within) + glm::dvec3(field_->firstNodeU() + u, field_->firstNodeV() + v, field_->filled().first + n);
    const glm::dvec3 place = low_ + size_ * (node + 0.5);
    glm::vec3 point, direction;
    for (int i = 0; i < 3; ++i) {
        point[axes_[static_cast<std::size_t>(i)]] = static_cast<float>(place[i]);
        direction[axes_[static_cast<std::size_t>(i)]] = normal[i];
    }
    mesh.points.push_back(point);
    mesh.normals.push_back(direction);
}

/// Edges between a column and another beside it whose ends lie on different sides.
template <class Visit>
void SurfaceNet::crossings(int u, int v, int otherU, int otherV, Visit visit) const {
    const std::uint64_t *column = insideOf(u, v), *other = insideOf(otherU, otherV);
    for (std::size_t word = 0; word < words_; ++word)
        eachBit((column[word] ^ other[word]) & ownedNodes_[word], word,
                [&](int n) { visit(n, ((column[word] >> (static_cast<std::size_t>(n) % wordBits)) & 1) != 0); });
}

void SurfaceNet::addFaces(SurfaceMesh& mesh) const {
    // The first tile owns the nodes outside the grid's border as well.
    const int lowU = field_->firstNodeU() < 0 ? firstCube : SurfaceField::margin;
    const int lowV = field_->firstNodeV() < 0 ? firstCube : SurfaceField::margin;
    const int highU = SurfaceField::margin + field_->ownedU(), highV = SurfaceField::margin + field_->ownedV();
    for (int u = lowU; u < highU; ++u)
        for (int v = lowV; v < highV; ++v) {
            if (v > firstCube)
                crossings(u, v, u + 1, v, [&](int n, bool inside) { addFace({0, u, v, n, inside}, mesh); });
            if (u > firstCube)
                crossings(u, v, u, v + 1, [&](int n, bool inside) { addFace({1, u, v, n, inside}, mesh); });
            const std::uint64_t* column = insideOf(u, v);
            for (std::size_t word = 0; word < words_ && u > firstCube && v > firstCube; ++word) {
                const std::uint64_t next = word + 1 < words_ ? column[word + 1] << (wordBits - 1) : 0;
                const std::uint64_t crossed = column[word] ^ ((column[word] >> 1) | next);
                eachBit(crossed & ownedNodes_[word], word, [&](int n) {
                    const bool inside = ((column[word] >> (static_cast<std::size_t>(n) % wordBits)) & 1) != 0;
                    addFace({2, u, v, n, inside}, mesh);
                });
            }
        }
}

void SurfaceNet::addFace(const Edge& edge, SurfaceMesh& mesh) const {
    const auto [axis, u, v, n, outwardsEdge] = edge;
    // Counter-clockwise as seen from the edge's far end.
    std::array<std::uint32_t, 4> corner{};
    if (axis == 0)
        corner = {pointOf(u, v - 1, n - 1), pointOf(u, v, n - 1), pointOf(u, v, n), pointOf(u, v - 1, n)};
    else if (axis == 1)
        corner = {pointOf(u - 1, v, n - 1), pointOf(u - 1, v, n), pointOf(u, v, n), pointOf(u, v, n - 1)};
    else
        corner = {pointOf(u - 1, v - 1, n), pointOf(u, v - 1, n), pointOf(u, v, n), pointOf(u - 1, v, n)};
    if (!outwardsEdge) std::swap(corner[1], corner[3]);
    const auto length = [&](std::size_t a, std::size_t b) {
        const glm::vec3 way = mesh.points[corner[a]] - mesh.points[corner[b]];
        return glm::dot(way, way);
    };
    const std::size_t turn = length(0, 2) <= length(1, 3) ? 0 : 1; // split along the shorter diagonal
    if (turn == 1) std::rotate(corner.begin(), corner.begin() + 1, corner.end());
    const std::array two{corner[0], corner[1], corner[2], corner[0], corner[2], corner[3]};
    mesh.triangles.insert(mesh.triangles.end(), two.begin(), two.end());
}

} // namespace burin
