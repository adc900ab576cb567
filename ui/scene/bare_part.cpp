// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bare_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// What a triangle is; around a point, what its triangles are.
constexpr std::uint8_t bareTriangle = 1, stockTriangle = 2, bothTriangles = 3;
/// Of drawing each point of the border between its neighbours: steps of one cell are gone after so many.
constexpr int straighteningRounds = 8;
constexpr float farthestMove = 0.45F;           ///< of a point in all, cells: no triangle beside the border folds
constexpr float ledAway = 0.8F, ledDown = 1.5F; ///< from the border, of the stock beneath the part, cells
constexpr double rimReach = 0.51;               ///< cells, of the points on a rim from the tile's limit

/// Where a point goes that is drawn half the way between two others, along the surface.
glm::vec3 drawnBetween(const glm::vec3& a, const glm::vec3& b, const glm::vec3& place, const glm::vec3& normal) {
    const glm::vec3 way = 0.5F * (0.5F * (a + b) - place);
    return place + way - normal * glm::dot(way, normal);
}

glm::vec3 within(float reach, const glm::vec3& centre, const glm::vec3& place) {
    const float length = glm::length(place - centre);
    return length > reach ? centre + (place - centre) * (reach / length) : place;
}

} // namespace

/// Tells points on a tile's rim, which the next tile has as well.
class BareBorder::TileRim {
public:
    TileRim(const Grid& grid, SurfaceTile tile, double cell)
        : u_(grid.axisOfU()), v_(grid.axisOfV()), reach_(static_cast<float>(rimReach * cell)) {
        const double size = linesPerSurfaceTile * grid.edge();
        middle_ = {grid.low()[u_] + (tile.u + 0.5) * size, grid.low()[v_] + (tile.v + 0.5) * size};
        half_ = static_cast<float>(0.5 * size);
    }
    bool has(const glm::vec3& place) const {
        return std::abs(place[u_] - middle_.x) > half_ - reach_ || std::abs(place[v_] - middle_.y) > half_ - reach_;
    }

private:
    int u_, v_;
    float reach_, half_ = 0.0F;
    glm::vec2 middle_{0.0F};
};

void BareBorder::draw(const VolumeSnapshot& workpiece, SurfaceTile tile, int level, SurfaceMesh& mesh) {
    bare_.resize(mesh.points.size());
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        bare_[point] = workpiece.properties().isProtected(mesh.properties[point]) ? 1 : 0;
    if (std::find(bare_.begin(), bare_.end(), 1) == bare_.end()) return;
    const double cell = workpiece.grid().edge() * (1 << level);
    weld(mesh);
    classify();
    findBorder();
    findNeighbours();
    straighten(mesh, static_cast<float>(cell));
    continueStock(mesh);
    sink(mesh, TileRim(workpiece.grid(), tile, cell), static_cast<float>(cell));
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        const std::uint32_t same = placeOf_[point];
        mesh.points[point] = mesh.points[same];
        mesh.normals[point] = mesh.normals[same];
        mesh.properties[point] = mesh.properties[same];
    }
}

/// Where two pieces of the tile meet along the runs, both have their own points.
void BareBorder::weld(const SurfaceMesh& mesh) {
    table_.weld(mesh.points, placeOf_);
    corners_.resize(mesh.triangles.size());
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), corners_.begin(),
                   [&](std::uint32_t corner) { return placeOf_[corner]; });
}

/// A triangle is what most of its corners are, as in the simplifier.
void BareBorder::classify() {
    triangles_.resize(corners_.size() / 3);
    around_.assign(bare_.size(), 0);
    for (std::size_t triangle = 0; triangle < triangles_.size(); ++triangle) {
        const std::uint32_t* at = &corners_[3 * triangle];
        triangles_[triangle] = bare_[at[0]] + bare_[at[1]] + bare_[at[2]] >= 2 ? bareTriangle : stockTriangle;
        for (std::size_t i = 0; i < 3; ++i) around_[at[i]] |= triangles_[triangle];
    }
}

void BareBorder::findBorder() {
    bareEdges_.clear();
    stockEdges_.clear();
    border_.clear();
    for (std::size_t triangle = 0; triangle < triangles_.size(); ++triangle)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = corners_[3 * triangle + i], b = corners_[3 * triangle + (i + 1) % 3];
            if (around_[a] == bothTriangles && around_[b] == bothTriangles)
                (triangles_[triangle] == bareTriangle ? bareEdges_ : stockEdges_).emplace_back(std::minmax(a, b));
        }
    std::sort(bareEdges_.begin(), bareEdges_.end());
    std::sort(stockEdges_.begin(), stockEdges_.end());
    std::set_intersection(bareEdges_.begin(), bareEdges_.end(), stockEdges_.begin(), stockEdges_.end(),
                          std::back_inserter(border_));
}

/// Points where the border forks, or where it leaves the tile, stay.
void BareBorder::findNeighbours() {
    beside_.resize(bare_.size());
    besideCount_.assign(bare_.size(), 0);
    const auto add = [&](std::uint32_t point, std::uint32_t other) {
        if (besideCount_[point] < 2) beside_[point][besideCount_[point]] = other;
        ++besideCount_[point];
    };
    for (const auto& [a, b] : border_) {
        add(a, b);
        add(b, a);
    }
    moved_.clear();
    for (std::uint32_t point = 0; point < bare_.size(); ++point)
        if (besideCount_[point] == 2) moved_.push_back(point);
}

void BareBorder::straighten(SurfaceMesh& mesh, float cell) {
    from_.clear();
    for (const std::uint32_t point : moved_) from_.push_back(mesh.points[point]);
    to_.resize(moved_.size());
    for (int round = 0; round < straighteningRounds; ++round) {
        for (std::size_t i = 0; i < moved_.size(); ++i) {
            const std::uint32_t point = moved_[i];
            const auto [a, b] = beside_[point];
            to_[i] = within(farthestMove * cell, from_[i],
                            drawnBetween(mesh.points[a], mesh.points[b], mesh.points[point], mesh.normals[point]));
        }
        for (std::size_t i = 0; i < moved_.size(); ++i) mesh.points[moved_[i]] = to_[i];
    }
}

/// The first triangles of bare part beside the border become stock.
void BareBorder::continueStock(SurfaceMesh& mesh) {
    besideBorder_.assign(bare_.size(), {});
    const auto eachCorner = [&](std::uint8_t kind, auto visit) {
        for (std::size_t corner = 0; corner < corners_.size(); ++corner)
            if (triangles_[corner / 3] == kind) visit(&corners_[corner / 3 * 3], corners_[corner]);
    };
    eachCorner(stockTriangle, [&](const std::uint32_t* triangle, std::uint32_t point) {
        if (around_[point] != bothTriangles || bare_[point] == 0) return;
        for (std::size_t i = 0; i < 3; ++i)
            if (bare_[triangle[i]] == 0) mesh.properties[point] = mesh.properties[triangle[i]];
    });
    eachCorner(bareTriangle, [&](const std::uint32_t* triangle, std::uint32_t point) {
        if (around_[point] == bothTriangles) return;
        for (std::size_t i = 0; i < 3; ++i)
            if (around_[triangle[i]] == bothTriangles) {
                mesh.properties[point] = mesh.properties[triangle[i]];
                besideBorder_[point].add(mesh.points[triangle[i]], mesh.normals[triangle[i]]);
            }
    });
}

void BareBorder::sink(SurfaceMesh& mesh, const TileRim& rim, float cell) const {
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        const bool onRim = rim.has(mesh.points[point]);
        if (!onRim && besideBorder_[point].count > 0.0F)
            leadOn(mesh, point, cell);
        else if (onRim ? bare_[point] != 0 : around_[point] == bareTriangle)
            mesh.points[point] -= cell * mesh.normals[point];
    }
}

/// Away from the stock and down: stock that ends upright and stock that runs out flat both meet the part soon.
void BareBorder::leadOn(SurfaceMesh& mesh, std::size_t point, float cell) const {
    const Border& border = besideBorder_[point];
    const glm::vec3 place = border.places / border.count, normal = glm::normalize(border.normals);
    glm::vec3 away = mesh.points[point] - place;
    away -= normal * glm::dot(away, normal);
    const float length = glm::length(away);
    if (length > 0.0F) away *= cell / length;
    mesh.points[point] = place + ledAway * away - ledDown * cell * normal;
    mesh.normals[point] = normal;
}

void leaveOutBarePart(SurfaceMesh& mesh, std::vector<std::uint32_t>& rim, const PropertyList& properties) {
    std::vector<std::uint32_t> kept(mesh.points.size(), none);
    std::uint32_t count = 0;
    for (std::uint32_t point = 0; point < mesh.points.size(); ++point) {
        if (properties.isProtected(mesh.properties[point])) continue;
        mesh.points[count] = mesh.points[point];
        mesh.normals[count] = mesh.normals[point];
        mesh.properties[count] = mesh.properties[point];
        kept[point] = count++;
    }
    mesh.points.resize(count);
    mesh.normals.resize(count);
    mesh.properties.resize(count);
    const auto keep = [&](std::vector<std::uint32_t>& corners, std::ptrdiff_t together) {
        auto end = corners.begin();
        for (auto at = corners.begin(); at != corners.end(); at += together)
            if (kept[*at] != none)
                end = std::transform(at, at + together, end, [&](std::uint32_t corner) { return kept[corner]; });
        corners.erase(end, corners.end());
    };
    keep(mesh.triangles, 3);
    keep(rim, 2);
}

} // namespace burin
