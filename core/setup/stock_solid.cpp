// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/stock_solid.h"

#include "core/setup/round_sides.h"
#include "core/setup/setup.h"
#include "core/volume/operations/ray_cast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace burin {

namespace {

constexpr double withinRegion = 1e-6;    // mm: a face that lies in a side of a region is not in it
constexpr double depthResolution = 1e-8; // mm
constexpr std::size_t quickTriangles = 20'000;

/// The faces of a box.
std::array<Triangle, 12> trianglesOf(const Box& box) noexcept {
    constexpr std::array<std::array<unsigned, 4>, 6> quads{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    std::array<Triangle, 12> triangles{};
    for (std::size_t i = 0; i < quads.size(); ++i) {
        const auto& [a, b, c, d] = quads[i];
        triangles[2 * i] = {box.corner(a), box.corner(b), box.corner(c)};
        triangles[2 * i + 1] = {box.corner(a), box.corner(c), box.corner(d)};
    }
    return triangles;
}

/// What is left of a triangle in a box: a convex polygon.
class ClippedTriangle {
public:
    explicit ClippedTriangle(const Triangle& triangle) : points_(triangle.begin(), triangle.end()) {}

    void clip(const Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            keep(axis, 1.0, box.low[axis]);
            keep(axis, -1.0, -box.high[axis]);
        }
    }
    const std::vector<glm::dvec3>& points() const noexcept { return points_; }

private:
    /// Keeps the half space in which sign · coordinate ≥ least.
    void keep(int axis, double sign, double least) {
        if (std::isinf(least) || points_.empty()) return;
        std::vector<glm::dvec3> kept;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const glm::dvec3 &from = points_[i], &to = points_[(i + 1) % points_.size()];
            const double above = sign * from[axis] - least, next = sign * to[axis] - least;
            if (above >= 0.0) kept.push_back(from);
            if ((above > 0.0 && next < 0.0) || (above < 0.0 && next > 0.0))
                kept.push_back(from + above / (above - next) * (to - from)); // exact where they agree
        }
        points_ = std::move(kept);
    }

    std::vector<glm::dvec3> points_;
};

Triangle placedBy(const Triangle& triangle, const Placement& by) noexcept {
    return {by.point(triangle[0]), by.point(triangle[1]), by.point(triangle[2])};
}

Box triangleBounds(const Triangle& triangle) noexcept {
    Box box;
    for (const glm::dvec3& corner : triangle) box.include(corner);
    return box;
}

bool apart(const Box& one, const Box& other) noexcept {
    return glm::any(glm::greaterThan(one.low, other.high)) || glm::any(glm::lessThan(one.high, other.low));
}

/// The extent of what is in a region, collected face by face.
class ExtentCollector {
public:
    ExtentCollector(const Placement& frame, const Box& region, int axis)
        : toFrame_(inverse(frame)), region_(region.grown(-withinRegion)), axis_(axis) {
        region_.low[axis] = -std::numeric_limits<double>::infinity();
        region_.high[axis] = std::numeric_limits<double>::infinity();
    }

    void add(const Triangle& triangle) {
        const Triangle own = placedBy(triangle, toFrame_);
        if (!adds(triangleBounds(own))) return;
        ClippedTriangle clipped(own);
        clipped.clip(region_);
        for (const glm::dvec3& point : clipped.points()) {
            low_ = std::min(low_, point[axis_]);
            high_ = std::max(high_, point[axis_]);
        }
    }
    void add(const Box& box) {
        if (!adds(boxAround(box, toFrame_))) return;
        for (const Triangle& face : trianglesOf(box)) add(face);
    }
    std::optional<StockSolid::Extent> extent() const {
        return low_ <= high_ ? std::optional(StockSolid::Extent{low_, high_}) : std::nullopt;
    }

private:
    bool adds(const Box& box) const noexcept {
        return !apart(box, region_) && (box.low[axis_] < low_ || box.high[axis_] > high_);
    }

    Placement toFrame_;
    Box region_;
    int axis_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

/// The greatest value of a concave function of a segment's points.
template <class Value>
double greatest(const Value& value, glm::dvec3 from, glm::dvec3 to) {
    while (glm::distance(from, to) > depthResolution) {
        const glm::dvec3 first = glm::mix(from, to, 1.0 / 3.0), second = glm::mix(from, to, 2.0 / 3.0);
        if (value(first) < value(second))
            from = first;
        else
            to = second;
    }
    return std::max(value(from), value(to));
}

/// The depth of a triangle's deepest point in a box, or `least` if it is not deeper. @param triangle in the box's frame
double depthOf(const Triangle& triangle, const Box& box, double least) {
    const auto reaches = [&](double depth) {
        const Box inner = box.grown(-depth);
        if (inner.empty() || apart(triangleBounds(triangle), inner)) return false;
        ClippedTriangle clipped(triangle);
        clipped.clip(inner);
        return !clipped.points().empty();
    };
    double low = least, high = 0.5 * std::min({box.size().x, box.size().y, box.size().z});
    if (high <= low || !reaches(low + depthResolution)) return least;
    while (high - low > depthResolution) {
        const double middle = 0.5 * (low + high);
        (reaches(middle) ? low : high) = middle;
    }
    return low;
}

/// Calls a function with each run of material: from, to on its centre line, mm. @param region runs beside it are left
/// out
template <class Visit>
void eachRun(const VolumeSnapshot& runs, const Box& region, const Visit& visit) {
    const Grid& grid = runs.grid();
    const int along = grid.axisOfRuns(), u = grid.axisOfU(), v = grid.axisOfV();
    const auto lines = [&](int axis, std::int32_t count) {
        const double low = (region.low[axis] - grid.low()[axis]) / grid.edge() - 1.0,
                     high = (region.high[axis] - grid.low()[axis]) / grid.edge() + 1.0;
        return std::pair(static_cast<std::int32_t>(std::clamp(std::floor(low), 0.0, static_cast<double>(count))),
                         static_cast<std::int32_t>(std::clamp(std::ceil(high), 0.0, static_cast<double>(count))));
    };
    const auto [firstU, endU] = lines(u, grid.lineCountU());
    const auto [firstV, endV] = lines(v, grid.lineCountV());
    for (LineIndex line{0, firstV}; line.v < endV; ++line.v)
        for (line.u = firstU; line.u < endU; ++line.u) {
            const glm::dvec2 centre = grid.lineCentre(line);
            RunPosition begin = 0;
            for (const Segment segment : runs.line(line)) {
                glm::dvec3 from(0.0);
                from[u] = centre.x;
                from[v] = centre.y;
                glm::dvec3 to = from;
                from[along] = grid.toMillimetres(begin);
                to[along] = grid.toMillimetres(segment.end());
                begin = segment.end();
                if (segment.property() != airProperty) visit(from, to);
            }
        }
}

/// A prism in a cylinder. Its corners are on the axes of the setup frame if the cylinder is parallel to one.
TriangleMesh prismIn(const CylinderShape& cylinder) {
    const std::uint32_t sides = 4 * ((sidesAround(cylinder.radius, stockChord) + 3) / 4);
    glm::dvec3 u(0.0);
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(cylinder.axis[axis]) < std::abs(cylinder.axis[least])) least = axis;
    u[least] = 1.0;
    u = glm::normalize(u - glm::dot(u, cylinder.axis) * cylinder.axis);
    const glm::dvec3 v = glm::cross(cylinder.axis, u), top = cylinder.base + cylinder.height * cylinder.axis;
    TriangleMesh mesh;
    for (const glm::dvec3& centre : {cylinder.base, top})
        for (std::uint32_t i = 0; i < sides; ++i) {
            // Exact where it meets an axis.
            const double angle = 2.0 * pi * (i % (sides / 4)) / sides, cosine = std::cos(angle), sine = std::sin(angle);
            const std::array quarter{glm::dvec2(cosine, sine), glm::dvec2(-sine, cosine), glm::dvec2(-cosine, -sine),
                                     glm::dvec2(sine, -cosine)};
            const glm::dvec2 out = quarter[i / (sides / 4)];
            mesh.vertices.push_back(centre + cylinder.radius * (out.x * u + out.y * v));
        }
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        mesh.triangles.push_back({i, next, next + sides});
        mesh.triangles.push_back({i, next + sides, i + sides});
        if (i == 0 || next == 0) continue;
        mesh.triangles.push_back({0, next, i});
        mesh.triangles.push_back({sides, i + sides, next + sides});
    }
    return mesh;
}

TriangleMesh outward(TriangleMesh mesh) {
    if (signedVolume(mesh) < 0.0)
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

} // namespace

bool StockSolid::isQuick() const noexcept {
    return !runs_ && (!surface_ || surface_->triangles().size() <= quickTriangles);
}

Result<StockSolid> StockSolid::of(const Model& model, const Setup& setup, Progress& progress) {
    StockSolid solid(setup.stock);
    if (setup.form == StockForm::cylinder) {
        solid.surface_ = std::make_shared<const MeshDistance>(prismIn(setup.cylinder));
    } else if (setup.form == StockForm::solids) {
        TriangleMesh mesh;
        for (std::size_t i = 0; i < model.bodies.size(); ++i)
            if (roleOf(setup, i) == BodyRole::stock) append(mesh, outward(model.bodies[i].mesh));
        if (!mesh.empty()) solid.surface_ = std::make_shared<const MeshDistance>(mesh);
    } else if (setup.form == StockForm::file && setup.volume) {
        Result<RunVolume> volume = setup.volume->unpack(progress);
        if (!volume) return std::move(volume).error();
        solid.volume_ = std::make_shared<RunVolume>(*std::move(volume));
        solid.runs_ = std::make_shared<const VolumeSnapshot>(solid.volume_->snapshot());
    }
    return solid;
}

std::optional<StockSolid::Extent> StockSolid::extentIn(const Placement& frame, const Box& region, int axis) const {
    ExtentCollector collector(frame, region, axis);
    if (surface_) {
        for (const Triangle& triangle : surface_->triangles()) collector.add(triangle);
    } else if (runs_) {
        glm::dvec3 half(0.5 * runs_->grid().edge());
        half[runs_->grid().axisOfRuns()] = 0.0;
        const double far = glm::length(box_.size()) + glm::distance(frame.shift, box_.centre());
        Box reach = region;
        reach.low[axis] = -far;
        reach.high[axis] = far;
        eachRun(*runs_, boxAround(reach, frame), [&](const glm::dvec3& from, const glm::dvec3& to) {
            collector.add(Box{from - half, to + half});
        });
    } else if (!empty()) {
        collector.add(box_);
    }
    return collector.extent();
}

double StockSolid::depthOfRuns(const Box& around, const Depth& depth) const {
    double deepest = 0.0;
    eachRun(*runs_, around, [&](const glm::dvec3& from, const glm::dvec3& to) {
        const Box run{glm::min(from, to), glm::max(from, to)};
        if (!apart(run, around)) deepest = std::max(deepest, greatest(depth, from, to));
    });
    return deepest;
}

double StockSolid::depthInBox(const Box& solid, const Placement& frame) const {
    const Placement toFrame = inverse(frame);
    if (runs_)
        return depthOfRuns(boxAround(solid, frame), [&](const glm::dvec3& point) {
            const glm::dvec3 own = toFrame.point(point), in = glm::min(own - solid.low, solid.high - own);
            return std::min({in.x, in.y, in.z});
        });
    double deepest = 0.0;
    const Box reach = boxAround(solid, frame);
    for (const Triangle& triangle : surface_->triangles())
        if (!apart(triangleBounds(triangle), reach)) deepest = depthOf(placedBy(triangle, toFrame), solid, deepest);
    // Where the surface stays away from what is deepest in the solid, its centre tells whether that is in the stock.
    if (surface_->closest(frame.point(solid.centre())).signedDistance < 0.0)
        deepest = std::max(deepest, 0.5 * std::min({solid.size().x, solid.size().y, solid.size().z}));
    return deepest;
}

double StockSolid::depthInCylinder(const glm::dvec2& centre, double radius, double low, double high) const {
    const Box reach{{centre - radius, low}, {centre + radius, high}};
    if (runs_)
        return depthOfRuns(reach, [&](const glm::dvec3& point) {
            return std::min({radius - glm::distance(glm::dvec2(point), centre), point.z - low, high - point.z});
        });
    const RevolvedPiece piece{low, high, radius, radius};
    const ToolPose pose{{centre, 0.0}, {0.0, 0.0, 1.0}};
    return std::max(0.0, -surface_->clearance({&piece, 1}, pose, 1.0).clearance);
}

std::optional<glm::dvec3> StockSolid::hit(const glm::dvec3& origin, const glm::dvec3& direction) const {
    if (runs_) {
        const std::optional<RayHit> found = castRay(*runs_, origin, direction);
        return found ? std::optional(found->place) : std::nullopt;
    }
    const Ray ray{origin, direction};
    std::optional<TriangleHit> nearest;
    if (surface_) {
        nearest = surface_->hit(ray);
    } else if (!empty()) {
        for (const Triangle& face : trianglesOf(box_))
            if (const auto found = hitOf(ray, face); found && (!nearest || found->distance < nearest->distance))
                nearest = found;
    }
    return nearest ? std::optional(origin + nearest->distance * direction) : std::nullopt;
}

} // namespace burin
