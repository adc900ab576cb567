// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/excess.h"
#include "core/base/parallel.h"
#include "core/tool/piece_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double longestExcess = 20.0;       // mm; beyond it the stock was simply never touched
constexpr double reachableClearance = -0.01; // mm: what the mesh's chord may cost

struct SurfacePoint {
    glm::dvec3 place{0.0}, normal{0.0};
};

/// One point for about every `spacing`² of surface: each triangle in turn gives as many as its share of area asks for.
std::vector<SurfacePoint> pointsOver(const TriangleMesh& mesh, double spacing) {
    std::vector<SurfacePoint> points;
    double due = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 &pa = mesh.vertices[a], &pb = mesh.vertices[b], &pc = mesh.vertices[c];
        const glm::dvec3 twice = glm::cross(pb - pa, pc - pa);
        const double area = 0.5 * glm::length(twice);
        if (!(area > 0.0)) continue;
        const glm::dvec3 normal = twice / (2.0 * area);
        due += area / (spacing * spacing);
        // Additive recurrence over the triangle: even, and the same in every run (Roberts 2018, "R2 sequence").
        const auto count = static_cast<std::size_t>(due);
        for (std::size_t i = 0; i < count; ++i) {
            double s = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i + 1), 1.0);
            double t = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i + 1), 1.0);
            if (s + t > 1.0) {
                s = 1.0 - s;
                t = 1.0 - t;
            }
            points.push_back({pa + s * (pb - pa) + t * (pc - pa), normal});
        }
        due -= static_cast<double>(count);
    }
    return points;
}

/// Reads a workpiece at places that follow each other closely.
class PlaceReader {
public:
    explicit PlaceReader(const RunVolume& workpiece) : workpiece_(workpiece), grid_(workpiece.grid()) {}

    PropertyIndex at(const glm::dvec3& place) {
        const glm::dvec3 index = (place - grid_.low()) / grid_.edge();
        for (int axis = 0; axis < 3; ++axis)
            if (!(index[axis] >= 0.0 && index[axis] < grid_.count()[axis])) return airProperty;
        const LineIndex line{static_cast<std::int32_t>(index[grid_.axisOfU()]),
                             static_cast<std::int32_t>(index[grid_.axisOfV()])};
        const auto position = static_cast<RunPosition>(index[grid_.axisOfRuns()] * unitsPerVoxel);
        if (!(line == line_ && position >= from_ && position < to_)) find(line, position);
        return property_;
    }

private:
    void find(LineIndex line, RunPosition position) {
        line_ = line;
        to_ = 0;
        for (const Segment segment : workpiece_.line(line)) {
            from_ = to_;
            to_ = segment.end();
            property_ = segment.property();
            if (position < to_) return;
        }
    }

    const RunVolume& workpiece_;
    const Grid& grid_;
    LineIndex line_{-1, -1}; ///< of the segment that was read last
    RunPosition from_ = 0, to_ = 0;
    PropertyIndex property_ = airProperty;
};

/// Length along the normal until the stock ends. Starts half a voxel's diagonal out, where a scanline's centre can no
/// longer lie inside the part, and goes on in eighths of a voxel.
double excessAt(const RunVolume& workpiece, const SurfacePoint& point) {
    const double step = workpiece.grid().edge() / 8.0;
    PlaceReader reader(workpiece);
    double thickness = 0.0;
    for (double way = step; way <= longestExcess; way += step) {
        const PropertyIndex property = reader.at(point.place + way * point.normal);
        if (property == airProperty) break;
        if (!workpiece.properties().isProtected(property)) thickness = way;
    }
    return thickness;
}

/// Tip of the cutter when it touches the part at a place with this normal: with the point of the flutes that lies
/// farthest against the normal. A hollow cutter may touch with others; what it reaches with those is not counted.
glm::dvec3 touchingTip(std::span<const PieceProfile> flutes, const SurfacePoint& point) {
    const glm::dvec2 flat(point.normal);
    const double cosine = glm::length(flat);
    const glm::dvec2 outward = cosine > 1e-9 ? flat / cosine : glm::dvec2(0.0);
    ProfileDisc touching;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const PieceProfile& profile : flutes) {
        const ProfileDisc disc = profile.farthest(-point.normal.z, cosine);
        const double reach = disc.radius * cosine - disc.height * point.normal.z;
        if (reach <= farthest) continue;
        farthest = reach;
        touching = disc;
    }
    return {glm::dvec2(point.place) + touching.radius * outward, point.place.z - touching.height};
}

/// A tool, ready to be asked what it can touch.
struct TouchingTool {
    explicit TouchingTool(const Tool& tool) : stack(pieces(tool.cutter)) {
        for (const RevolvedPiece& piece : flutePieces(tool.cutter)) flutes.emplace_back(piece);
    }

    std::vector<RevolvedPiece> stack;
    std::vector<PieceProfile> flutes;
};

bool isReachable(const VerifyRequest& request, const TouchingTool& tool, const SurfacePoint& point, double lowest) {
    if (point.normal.z < -1e-6) return false;
    const glm::dvec3 tip = touchingTip(tool.flutes, point);
    if (tip.z < lowest - 1e-6) return false;
    // Whether it enters the part by more than is allowed is all that is asked: nothing that is less deep is looked for.
    const ToolPose pose{tip, {0.0, 0.0, 1.0}};
    return request.part->clearance(tool.stack, pose, 0.0, -reachableClearance).clearance >= reachableClearance;
}

} // namespace

Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, Progress& progress) {
    std::vector<SurfacePoint> points;
    for (const Body& body : request.model->bodies) {
        const std::vector<SurfacePoint> more = pointsOver(body.mesh, workpiece.grid().edge());
        points.insert(points.end(), more.begin(), more.end());
    }
    const std::vector<TouchingTool> touching(tools.begin(), tools.end());
    const double lowest = request.model->box().low.z;
    std::vector<DeviationSample> samples(points.size());
    parallelStretches(std::size_t{0}, points.size(), 256, [&](std::size_t from, std::size_t to) {
        if (progress.cancelled()) return;
        for (std::size_t i = from; i != to; ++i)
            samples[i] = {points[i].place, excessAt(workpiece, points[i]),
                          std::any_of(touching.begin(), touching.end(), [&](const TouchingTool& tool) {
                              return isReachable(request, tool, points[i], lowest);
                          })};
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    return samples;
}

} // namespace burin
