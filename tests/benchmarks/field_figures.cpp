// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tool_field.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/mesh_level_set.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/part_meshes.h"
#include "tests/benchmarks/scenes/tool_paths.h"
#include "tests/part_field/part_field.h"

#include <algorithm>
#include <random>

namespace burin::benchmarks {

namespace {

// Voxels of 1 mm, so that lengths in mm are voxels.
constexpr double triangles = 1e6, band = 4.0;

/// Points in the fine band, along the normals of triangles; the same on every machine.
std::vector<glm::dvec3> placesInBand(const TriangleMesh& mesh, std::size_t count) {
    std::mt19937 random(7);
    const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<glm::dvec3> places;
    while (places.size() < count) {
        const auto& corners = mesh.triangles[random() % mesh.triangles.size()];
        const glm::dvec3 a = mesh.vertices[corners[0]], b = mesh.vertices[corners[1]], c = mesh.vertices[corners[2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (glm::length(normal) == 0.0) continue;
        double s = draw(), t = draw();
        if (s + t > 1.0) {
            s = 1.0 - s;
            t = 1.0 - t;
        }
        places.push_back(a + s * (b - a) + t * (c - a) + (2.0 * draw() - 1.0) * band * glm::normalize(normal));
    }
    return places;
}

struct FieldError {
    double largest = 0.0; ///< voxels
    double bound = 0.0;   ///< voxels, the largest bound that the field states at the points
    std::size_t beyondBound = 0;
};

FieldError errorOf(const PartField& field, const std::vector<glm::dvec3>& places) {
    FieldError error;
    for (const glm::dvec3& place : places) {
        Session::throwIfCancelled();
        const double exact = field.exact().closest(place).signedDistance;
        const double off = std::abs(field.value(place) - exact), bound = field.errorBoundAt(place);
        error.largest = std::max(error.largest, off);
        error.bound = std::max(error.bound, bound);
        error.beyondBound += off > bound ? 1U : 0U;
    }
    return error;
}

PartField build(const TriangleMesh& mesh, double reach) {
    Progress progress;
    return require(PartField::build(mesh, {1.0, reach}, progress), "a part's field");
}

void fieldOfPart(Session& session, std::int32_t side, double limit) {
    const std::string name = "field." + std::to_string(side);
    if (!session.wants(name)) return;
    session.stage(name);
    const TriangleMesh mesh = bumpyPart(side, triangles);
    std::optional<PartField> field;
    const double spent = leastSeconds(
        2, [&] { field.reset(); }, [&] { field.emplace(build(mesh, band)); });
    Figure entry = figure(name, session.least(name, spent), "s", limit);
    const std::optional<double> theirs = meshLevelSetSeconds(session, side, triangles);
    session.add(theirs ? against(std::move(entry), "OpenVDB meshToLevelSet, half width 3", *theirs) : std::move(entry));
    session.add(figure(name + ".bytes_per_band_voxel",
                       static_cast<double>(field->fineBytes()) / static_cast<double>(field->bandVoxels()), "B", 5.0));
}

void fieldErrors(Session& session) {
    const std::string name = "field.512.error_max_voxel";
    if (!session.wants(name)) return;
    constexpr std::size_t places = 100'000;
    session.stage(name);
    const TriangleMesh smooth = bumpyPart(512.0, triangles), sharp = sharpPart(512.0);
    const FieldError bumpy = errorOf(build(smooth, band), placesInBand(smooth, places));
    const FieldError edged = errorOf(build(sharp, band), placesInBand(sharp, places));
    session.add(figure(name, bumpy.largest, "voxel", 0.03));
    session.add(figure(name + ".sharp", edged.largest, "voxel", edged.bound));
    session.check(bumpy.beyondBound + edged.beyondBound == 0, "the field is never off by more than it states");
}

/// Points on the end of a ball of R 25 that rests on a vertex of the body, within 10 mm of it, in the order in which
/// the surface of a tool is traversed.
std::vector<glm::dvec3> touchingTool(const TriangleMesh& mesh, double side) {
    const glm::dvec3 middle(0.5 * side), out = glm::normalize(glm::dvec3(1.0, 1.0, 0.4));
    const glm::dvec3 contact = *std::ranges::max_element(
        mesh.vertices, {}, [&](const glm::dvec3& vertex) { return glm::dot(glm::normalize(vertex - middle), out); });
    const glm::dvec3 along = glm::normalize(glm::cross(out, glm::dvec3(0.0, 0.0, 1.0))),
                     across = glm::cross(out, along);
    std::vector<glm::dvec3> places;
    for (int ring = 0; ring < 100; ++ring)
        for (int i = 0; i < 100; ++i) {
            const double radius = 0.1 * ring, turn = 0.0628 * i;
            places.push_back(contact + radius * (std::cos(turn) * along + std::sin(turn) * across) +
                             (25.0 - std::sqrt(625.0 - radius * radius)) * out);
        }
    return places;
}

void fieldQueries(Session& session) {
    if (!session.wants("field.query_ns")) return;
    session.stage("field.query_ns");
    constexpr double side = 512.0;
    const TriangleMesh mesh = bumpyPart(side, triangles);
    const PartField field = build(mesh, band);
    const std::vector<glm::dvec3> places = touchingTool(mesh, side);
    std::vector<PartDistance> answers(places.size());
    const double nanoseconds = 1e9 / static_cast<double>(places.size());
    const double together = nanoseconds * leastSeconds(50, [&] { field.at(places, answers); });
    float sum = 0.0F;
    const double single = nanoseconds * leastSeconds(50, [&] {
                              for (const glm::dvec3& place : places) sum += field.at(place).distance;
                          });
    session.check(std::isfinite(sum), "distances are numbers");
    Figure entry = figure("field.query_ns", session.least("field.query_ns", together), "ns", 4.0);
    const std::optional<double> theirs = levelSetQueryNanoseconds(bumpyPart(side, 1e5), places);
    session.add(theirs
                    ? against(std::move(entry), "OpenVDB BoxSampler, value alone", session.least("BoxSampler", *theirs))
                    : std::move(entry));
    session.add(figure("field.query_ns.one_by_one", session.least("field.query_ns.one_by_one", single), "ns"));
}

void fieldOfTool(Session& session) {
    if (!session.wants("field.tool.512")) return;
    session.stage("field.tool.512");
    constexpr double side = 512.0;
    const MeshDistance part(bumpyPart(side, triangles));
    const ToolFieldRequest request{
        pieces(cutterOf(CutterType::ball, 12.0)), {glm::dvec3(0.0), glm::dvec3(side)}, 1.0, 1.0};
    const double spent = leastSeconds(1, [&] {
        Progress progress;
        (void)require(ToolField::build(part, request, progress), "a tool's field");
    });
    session.add(figure("field.tool.512", session.least("field.tool.512", spent), "s", 5.0));
}

} // namespace

void fieldFigures(Session& session) {
    fieldOfPart(session, 512, 0.7);
    fieldOfPart(session, 1024, 2.5);
    fieldErrors(session);
    fieldQueries(session);
    fieldOfTool(session);
}

} // namespace burin::benchmarks
