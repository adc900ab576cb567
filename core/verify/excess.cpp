// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/excess.h"
#include "core/base/parallel.h"
#include "core/tool/piece_profile.h"
#include "core/verify/left_over.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double longestExcess = 20.0;  // mm; beyond it the stock was simply never touched
constexpr double reachableDepth = 0.01; // mm: what the mesh's chord may cost

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
        std::reverse(stack.begin(), stack.end()); // a wide holder is told quickest that it has no room
        for (const RevolvedPiece& piece : flutePieces(tool.cutter)) flutes.emplace_back(piece);
    }

    std::vector<RevolvedPiece> stack;
    std::vector<PieceProfile> flutes;
};

bool facesACutter(const SurfacePoint& point) noexcept {
    return point.normal.z >= -1e-6;
}

bool isReachable(const VerifyRequest& request, const TouchingTool& tool, const SurfacePoint& point, double lowest) {
    const glm::dvec3 tip = touchingTip(tool.flutes, point);
    if (tip.z < lowest - 1e-6) return false;
    return !request.part->enters(tool.stack, ToolPose{tip, {0.0, 0.0, 1.0}}, reachableDepth);
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
    const LeftOver left(workpiece);
    std::vector<DeviationSample> samples(points.size());
    parallelStretches(std::size_t{0}, points.size(), 256, [&](std::size_t from, std::size_t to) {
        if (progress.cancelled()) return;
        for (std::size_t i = from; i != to; ++i) {
            DeviationSample& sample = samples[i];
            sample.place = points[i].place;
            sample.excess = left.along(points[i].place, points[i].normal, longestExcess);
            // What is bare and faces a cutter from above needs no proof that one gets there.
            sample.reachable =
                facesACutter(points[i]) &&
                (sample.excess == 0.0 || std::any_of(touching.begin(), touching.end(), [&](const TouchingTool& tool) {
                     return isReachable(request, tool, points[i], lowest);
                 }));
        }
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    return samples;
}

} // namespace burin
