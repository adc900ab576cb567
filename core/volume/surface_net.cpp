// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_net.h"

#include <array>
#include <bit>

namespace burin {

namespace {

constexpr int firstCube = SurfaceField::margin - 1; ///< column of the lowest cube beside the owned nodes
constexpr std::size_t wordBits = 64;

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
    words_ = (static_cast<std::size_t>(count_) + wordBits - 1) / wordBits;
    findInside();
    addPoints(grid, mesh);
    addFaces(mesh);
}

void SurfaceNet::findInside() {
    inside_.assign(static_cast<std::size_t>(columnsU_ * columnsV_) * words_, 0);
    const std::uint16_t half = field_->half();
    for (int u = firstCube; u < columnsU_ - firstCube; ++u)
        for (int v = firstCube; v < columnsV_ - firstCube; ++v) {
            const std::uint16_t* values = field_->column(u, v);
            std::uint64_t* words = inside_.data() + static_cast<std::size_t>(u * columnsV_ + v) * words_;
            for (std::size_t n = 0; n < static_cast<std::size_t>(count_); ++n)
                words[n / wordBits] |= std::uint64_t{values[n] >= half} << (n % wordBits);
        }
}

void SurfaceNet::addPoints(const Grid& grid, SurfaceMesh& mesh) {
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
                eachBit(any & ~all, word, [&](int n) {
                    if (n + 1 < count_) addPoint(u, v, n, grid, mesh);
                });
            }
        }
}

void SurfaceNet::addPoint(int u, int v, int n, const Grid& grid, SurfaceMesh& mesh) {
    pointOfCube_[static_cast<std::size_t>(u * columnsV_ + v) * static_cast<std::size_t>(count_) +
                 static_cast<std::size_t>(n)] = static_cast<std::uint32_t>(mesh.points.size());
    const glm::vec3 within = middleOfCrossings(u, v, n);
    const glm::vec3 normal = outwards(u, v, n, within);
    const glm::dvec3 node = glm::dvec3(within) +
                            glm::dvec3(field_->firstNodeU() + u, field_->firstNodeV() + v, field_->filled().first + n) +
                            0.5;
    const double size = grid.edge() * field_->cell();
    glm::vec3 point, direction;
    const std::array axes{grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    for (int i = 0; i < 3; ++i) {
        const int axis = axes[static_cast<std::size_t>(i)];
        point[axis] = static_cast<float>(grid.low()[axis] + size * node[i]);
        direction[axis] = normal[i];
    }
    mesh.points.push_back(point);
    mesh.normals.push_back(direction);
}

/// In the cube, 0 … 1 along u, v and the runs.
glm::vec3 SurfaceNet::middleOfCrossings(int u, int v, int n) const {
    std::array<std::array<const std::uint16_t*, 2>, 2> columns{};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            columns[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = field_->column(u + i, v + j) + n;
    const int half = field_->half();
    glm::vec3 sum(0.0F);
    int crossed = 0;
    const auto along = [&](int axis, glm::vec3 corner, int low, int high) {
        if ((low >= half) == (high >= half)) return;
        corner[axis] = static_cast<float>(half - low) / static_cast<float>(high - low);
        sum += corner;
        ++crossed;
    };
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            const auto a = static_cast<float>(i), b = static_cast<float>(j);
            along(0, {0.0F, a, b}, columns[0][i][j], columns[1][i][j]);
            along(1, {a, 0.0F, b}, columns[i][0][j], columns[i][1][j]);
            along(2, {a, b, 0.0F}, columns[i][j][0], columns[i][j][1]);
        }
    return sum / static_cast<float>(crossed);
}

/// Downhill in the field, averaged 1-2-1 along all axes and interpolated in the cube: wider than what places the point,
/// because the eye takes a ripple of the normals for a ripple of the surface.
glm::vec3 SurfaceNet::outwards(int u, int v, int n, const glm::vec3& place) const {
    std::array<glm::vec4, 3> value{};
    for (int axis = 0; axis < 3; ++axis) {
        const float t = place[axis];
        value[static_cast<std::size_t>(axis)] = {1.0F - t, 2.0F - t, 1.0F + t, t};
    }
    const glm::vec4 slope(-1.0F, -1.0F, 1.0F, 1.0F);
    glm::vec3 gradient(0.0F);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const std::uint16_t* at = field_->column(u + i - 1, v + j - 1) + n - 1;
            const glm::vec4 run(at[0], at[1], at[2], at[3]);
            const float mean = glm::dot(run, value[2]);
            gradient += glm::vec3(slope[i] * value[1][j] * mean, value[0][i] * slope[j] * mean,
                                  value[0][i] * value[1][j] * glm::dot(run, slope));
        }
    const float length = glm::length(gradient);
    return length > 0.0F ? -gradient / length : glm::vec3(0.0F, 0.0F, 1.0F);
}

/// Edges between a column and another beside it whose ends lie on different sides.
template <class Visit>
void SurfaceNet::crossings(int u, int v, int otherU, int otherV, Visit visit) const {
    const std::uint64_t *column = insideOf(u, v), *other = insideOf(otherU, otherV);
    for (std::size_t word = 0; word < words_; ++word)
        eachBit(column[word] ^ other[word], word,
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
                eachBit(column[word] ^ ((column[word] >> 1) | next), word, [&](int n) {
                    const bool inside = ((column[word] >> (static_cast<std::size_t>(n) % wordBits)) & 1) != 0;
                    if (n + 1 < count_) addFace({2, u, v, n, inside}, mesh);
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
    for (const std::size_t place : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.triangles.push_back(corner[(place + turn) % 4]);
}

} // namespace burin
