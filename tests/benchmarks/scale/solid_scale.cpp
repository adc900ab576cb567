// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tool_field.h"
#include "core/setup/setup.h"
#include "tests/benchmarks/scale/scale.h"
#include "tests/benchmarks/verification/relief_job.h"

#include <array>
#include <memory>
#include <optional>

namespace burin::benchmarks {

namespace {

/// A relief in its stock with one voxel size and one mesh.
struct Solid {
    explicit Solid(const ReliefJob& job) : scene(job) {}

    double voxels() const {
        const Setup& setup = scene.request.setup;
        const glm::dvec3 counts = glm::ceil(setup.stock.size() / setup.voxel - 1e-6);
        return counts.x * counts.y * counts.z;
    }
    double triangles() const { return static_cast<double>(scene.model.bodies.front().mesh.triangles.size()); }
    void embed() const {
        Progress progress;
        (void)require(burin::embed(scene.model, scene.request.setup, {}, progress), "stock");
    }
    /// Makes the boundary for a tool's tip.
    void boundary() const {
        ToolFieldRequest request;
        request.tool = pieces(scene.request.tool.cutter);
        request.tips = scene.request.setup.stock.grown(2.0 * scene.request.tool.cutter.diameter);
        request.voxel = scene.request.setup.voxel;
        request.maximumAllowance = 0.5;
        Progress progress;
        (void)require(ToolField::build(scene.part, request, progress), "boundary");
    }

    ReliefScene scene;
};

using Solids = std::array<std::unique_ptr<Solid>, 3>;

ScaledWork workOn(const Solids& solids, std::string name, double limit, double (Solid::*size)() const,
                  void (Solid::*work)() const) {
    ScaledWork scaled{std::move(name), limit};
    const auto at = [&solids](int step) -> const Solid& { return *solids[static_cast<std::size_t>(step)]; };
    scaled.size = [=](int step) { return (at(step).*size)(); };
    scaled.work = [=](int step) { (at(step).*work)(); };
    return scaled;
}

/// @param voxel  mm, of the first one @param grow  makes the next one larger
template <class Grow>
Solids solidsOf(double voxel, const Grow& grow) {
    ReliefJob job;
    job.meshCells = 128;
    job.voxel = voxel;
    Solids solids;
    for (auto& solid : solids) {
        solid = std::make_unique<Solid>(job);
        grow(job);
    }
    return solids;
}

} // namespace

void solidScale(Session& session) {
    constexpr double linear = 1.2;
    if (session.wants("scale.voxels")) {
        const Solids solids = solidsOf(0.8, [](ReliefJob& job) { job.voxel /= 2.0; });
        // The surface has as many voxels as the solid to the power of 2/3, and so has the work that is done at the
        // surface.
        scaleFigures(session, workOn(solids, "voxels.embed", linear, &Solid::voxels, &Solid::embed));
        scaleFigures(session, workOn(solids, "voxels.boundary", linear, &Solid::voxels, &Solid::boundary));
    }
    if (session.wants("scale.triangles")) {
        const Solids solids = solidsOf(0.4, [](ReliefJob& job) { job.meshCells *= 2; });
        scaleFigures(session, workOn(solids, "triangles.embed", linear, &Solid::triangles, &Solid::embed));
        scaleFigures(session, workOn(solids, "triangles.boundary", linear, &Solid::triangles, &Solid::boundary));
    }
}

} // namespace burin::benchmarks
