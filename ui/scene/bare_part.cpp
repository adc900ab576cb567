// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bare_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// The kind of a triangle; for a point, the kinds of its triangles.
constexpr std::uint8_t bareTriangle = 1, stockTriangle = 2, bothTriangles = 3;
/// Rounds of moving each border point between its neighbours, by level: steps of one cell have disappeared after eight
/// rounds. The part of the border that influences a point by then, and the surface next to it, lie in its tile and the
/// next.
constexpr std::array<int, coarsestSurfaceLevel + 1> straighteningRounds{8, 8, 4, 2};
constexpr int seenBesideBorder = 2;   ///< cells
constexpr float farthestMove = 0.45F; ///< total movement of a point, cells: no triangle next to the border folds over
constexpr float ledAway = 0.8F, ledDown = 1.5F; ///< offset of the stock beneath the part from the border, cells
constexpr float besideReach = 1.6F;             ///< cells, from a point to those that share a triangle with it

/// The position of a point after moving it halfway to the midpoint of two others, along the surface.
glm::vec3 drawnBetween(const glm::vec3& a, const glm::vec3& b, const glm::vec3& place, const glm::vec3& normal) {
    const glm::vec3 way = 0.5F * (0.5F * (a + b) - place);
    return place + way - normal * glm::dot(way, normal);
}

glm::vec3 within(float reach, const glm::vec3& centre, const glm::vec3& place) {
    const float length = glm::length(place - centre);
    return length > reach ? centre + (place - centre) * (reach / length) : place;
}

} // namespace

void BareBorder::draw(const VolumeSnapshot& workpiece, SurfaceTile tile, int level, const OtherTile& other,
                      BareRims& rims, SurfaceMesh& mesh) {
    if (!markBare(workpiece.properties(), mesh)) return;
    const auto cell = static_cast<float>(workpiece.grid().edge() * (1 << level));
    const TileLimits limits(workpiece.grid(), tile, cell);
    const int rounds = straighteningRounds[static_cast<std::size_t>(level)];
    const std::size_t points = mesh.points.size(), corners = mesh.triangles.size();
    findShared(limits, rims, cell, mesh);
    addBeyond(limits, static_cast<float>(rounds + seenBesideBorder) * cell, other, mesh);
    markBare(workpiece.properties(), mesh);
    weld(mesh);
    classify();
    takeKnown(mesh);
    findBorder();
    findNeighbours();
    straighten(mesh, rounds, cell);
    continueStock(mesh);
    sink(mesh, cell);
    keepShared(rims, mesh);
    for (std::size_t point = 0; point < points; ++point) {
        const std::uint32_t same = placeOf_[point];
        mesh.points[point] = mesh.points[same];
        mesh.normals[point] = mesh.normals[same];
        mesh.properties[point] = mesh.properties[same];
    }
    mesh.points.resize(points);
    mesh.normals.resize(points);
    mesh.properties.resize(points);
    mesh.triangles.resize(corners);
}

bool BareBorder::markBare(const PropertyList& properties, const SurfaceMesh& mesh) {
    bare_.resize(mesh.points.size());
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        bare_[point] = properties.isProtected(mesh.properties[point]) ? 1 : 0;
    return std::find(bare_.begin(), bare_.end(), 1) != bare_.end();
}

/// Points on a limit are moved only if all tiles that share them find bare part there on their own, since these must
/// obtain the same result. The other points stay.
void BareBorder::findShared(const TileLimits& limits, const BareRims& rims, float cell, const SurfaceMesh& mesh) {
    roles_.assign(mesh.points.size(), Role::free);
    shared_.clear();
    for (std::uint32_t point = 0; point < mesh.points.size(); ++point)
        if (const std::optional<TileLimit> limit = limits.at(mesh.points[point]))
            shared_.push_back({point, *limit, {mesh.points[point], mesh.properties[point], {}, {}, 0, 0}});
    findBareShared(mesh, limits.axisOfRuns());
    std::erase_if(shared_, [&](const Shared& one) {
        if (bare_[one.point] != 0 || isBareBeside(one, besideReach * cell)) return false;
        roles_[one.point] = Role::stays;
        return true;
    });
    for (Shared& one : shared_)
        if (const BareRims::Point* known = rims.find(one.limit, one.drawn.place, one.drawn.property)) {
            one.drawn = *known;
            one.known = true;
            roles_[one.point] = Role::known;
        }
}

void BareBorder::findBareShared(const SurfaceMesh& mesh, int axisOfRuns) {
    axisOfRuns_ = axisOfRuns;
    bareShared_.clear();
    for (const Shared& one : shared_)
        if (bare_[one.point] != 0) bareShared_.push_back({mesh.points[one.point], one.limit});
    std::ranges::sort(bareShared_, {}, [&](const BareShared& one) { return one.place[axisOfRuns]; });
}

/// Whether there is bare part nearby among the points that are shared by the tiles on both sides.
bool BareBorder::isBareBeside(const Shared& shared, float reach) const {
    using Kind = TileLimit::Kind;
    const TileLimit& limit = shared.limit;
    if (limit.kind == Kind::corner) return false;
    const auto onSameSide = [&](const TileLimit& other) {
        return other == limit ||
               (other.kind == Kind::corner && (limit.kind == Kind::alongV ? other.u == limit.u : other.v == limit.v));
    };
    const glm::vec3& place = shared.drawn.place;
    const auto along = [&](const BareShared& one) { return one.place[axisOfRuns_]; };
    const auto first = std::ranges::lower_bound(bareShared_, place[axisOfRuns_] - reach, {}, along);
    const auto last = std::ranges::upper_bound(bareShared_, place[axisOfRuns_] + reach, {}, along);
    return std::any_of(first, last, [&](const BareShared& other) {
        return onSameSide(other.limit) && glm::distance(other.place, place) < reach;
    });
}

/// Appends the required parts of other tiles after the tile's own points and triangles.
void BareBorder::addBeyond(const TileLimits& limits, float reach, const OtherTile& other, SurfaceMesh& mesh) {
    std::vector<SurfaceTile> tiles;
    for (const Shared& one : shared_) {
        if (one.known) continue;
        for (const SurfaceTile tile : limits.tilesNear(one.drawn.place, reach))
            if (std::find(tiles.begin(), tiles.end(), tile) == tiles.end()) tiles.push_back(tile);
    }
    for (const SurfaceTile tile : tiles) {
        other(tile, beyond_);
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), beyond_.points.begin(), beyond_.points.end());
        mesh.normals.insert(mesh.normals.end(), beyond_.normals.begin(), beyond_.normals.end());
        mesh.properties.insert(mesh.properties.end(), beyond_.properties.begin(), beyond_.properties.end());
        for (auto at = beyond_.triangles.begin(); at != beyond_.triangles.end(); at += 3)
            if (std::any_of(at, at + 3,
                            [&](std::uint32_t corner) { return limits.near(beyond_.points[corner], reach); }))
                for (auto corner = at; corner != at + 3; ++corner) mesh.triangles.push_back(first + *corner);
    }
    roles_.resize(mesh.points.size(), Role::free);
}

/// Merges coincident points: where two pieces of the tile meet along the runs, each has its own points; likewise where
/// tiles meet.
void BareBorder::weld(const SurfaceMesh& mesh) {
    table_.weld(mesh.points, placeOf_);
    corners_.resize(mesh.triangles.size());
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), corners_.begin(),
                   [&](std::uint32_t corner) { return placeOf_[corner]; });
}

/// The kind of a triangle is that of most of its corners, as in the simplifier.
void BareBorder::classify() {
    triangles_.resize(corners_.size() / 3);
    around_.assign(bare_.size(), 0);
    for (std::size_t triangle = 0; triangle < triangles_.size(); ++triangle) {
        const std::uint32_t* at = &corners_[3 * triangle];
        triangles_[triangle] = bare_[at[0]] + bare_[at[1]] + bare_[at[2]] >= 2 ? bareTriangle : stockTriangle;
        for (std::size_t i = 0; i < 3; ++i) around_[at[i]] |= triangles_[triangle];
    }
}

void BareBorder::takeKnown(SurfaceMesh& mesh) {
    for (const Shared& one : shared_) {
        if (!one.known) continue;
        const std::uint32_t point = placeOf_[one.point];
        around_[point] = one.drawn.around;
        if (around_[point] == bothTriangles) mesh.points[point] = one.drawn.drawnPlace;
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

/// Points where the border forks, or where it leaves the available surface, stay.
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
        if (besideCount_[point] == 2 && roles_[point] == Role::free) moved_.push_back(point);
}

void BareBorder::straighten(SurfaceMesh& mesh, int rounds, float cell) {
    from_.clear();
    for (const std::uint32_t point : moved_) from_.push_back(mesh.points[point]);
    to_.resize(moved_.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < moved_.size(); ++i) {
            const std::uint32_t point = moved_[i];
            const auto [a, b] = beside_[point];
            to_[i] = within(farthestMove * cell, from_[i],
                            drawnBetween(mesh.points[a], mesh.points[b], mesh.points[point], mesh.normals[point]));
        }
        for (std::size_t i = 0; i < moved_.size(); ++i) mesh.points[moved_[i]] = to_[i];
    }
}

/// The first triangles of bare part next to the border become stock.
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
        if (around_[point] == bothTriangles || roles_[point] != Role::free) return;
        for (std::size_t i = 0; i < 3; ++i)
            if (around_[triangle[i]] == bothTriangles) {
                mesh.properties[point] = mesh.properties[triangle[i]];
                besideBorder_[point].add(mesh.points[triangle[i]], mesh.normals[triangle[i]]);
            }
    });
}

void BareBorder::sink(SurfaceMesh& mesh, float cell) const {
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
        if (roles_[point] != Role::free) continue;
        if (besideBorder_[point].count > 0.0F)
            leadOn(mesh, point, cell);
        else if (around_[point] == bareTriangle)
            mesh.points[point] -= cell * mesh.normals[point];
    }
}

void BareBorder::keepShared(BareRims& rims, SurfaceMesh& mesh) {
    std::map<TileLimit, std::vector<BareRims::Point>> points;
    for (Shared& one : shared_) {
        const std::uint32_t point = placeOf_[one.point];
        BareRims::Point& drawn = one.drawn;
        if (one.known) {
            mesh.points[point] = drawn.drawnPlace;
            mesh.normals[point] = drawn.drawnNormal;
            mesh.properties[point] = drawn.drawnProperty;
        } else {
            drawn.drawnPlace = mesh.points[point];
            drawn.drawnNormal = mesh.normals[point];
            drawn.drawnProperty = mesh.properties[point];
            drawn.around = around_[point];
        }
        points[one.limit].push_back(drawn);
    }
    for (auto& [limit, all] : points) rims.set(limit, std::move(all));
}

/// Moves a point away from the stock and down: both stock with a steep end and stock that tapers off then meet the part
/// soon.
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
