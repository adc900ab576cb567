// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/fixture_solid.h"

#include "core/base/units.h"
#include "core/geometry/mesh_parts.h"
#include "core/setup/box_union.h"
#include "core/setup/obstacle.h"
#include "core/setup/round_sides.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

FixtureSolids viseSolids(const FixtureDesign& of) {
    const double half = 0.5 * valueOf(of, "opening"), depth = valueOf(of, "jaw-depth"), top = valueOf(of, "grip"),
                 bed = top - valueOf(of, "jaw-height"), jaw = 0.5 * valueOf(of, "jaw-width"),
                 body = 0.5 * valueOf(of, "body-width");
    FixtureSolids solids;
    solids.boxes = {
        {{half, -jaw, bed}, {half + depth, jaw, top}},
        {{-half - depth, -jaw, bed}, {-half, jaw, top}},
        {{-half - depth - valueOf(of, "tail"), -body, bed - valueOf(of, "body-height")}, {half + depth, body, bed}}};
    return solids;
}

FixtureSolids stepClampSolids(const FixtureDesign& of) {
    const double height = valueOf(of, "height"), half = 0.5 * valueOf(of, "width"),
                 thickness = valueOf(of, "thickness"), nose = -0.5 * valueOf(of, "contact"),
                 end = nose + valueOf(of, "length"), step = valueOf(of, "block-length") / blockSteps,
                 stud = valueOf(of, "stud-distance"), slot = 0.5 * valueOf(of, "slot");
    FixtureSolids solids;
    solids.boxes.push_back({{nose, -half, 0.0}, {end, half, thickness}});
    for (int i = 0; i < blockSteps; ++i)
        solids.boxes.push_back(
            {{end + (i - 1) * step, -half, -height}, {end + i * step, half, -height * i / blockSteps}});
    solids.cutAway.push_back({{stud - slot, -slot, 0.0}, {stud + slot, slot, thickness}});
    const double washer = thickness + solidGap, nut = washer + valueOf(of, "washer-thickness"),
                 top = nut + valueOf(of, "nut-height"), radius = 0.5 * valueOf(of, "stud");
    solids.rounds.push_back({{stud, 0.0},
                             {{radius, -height, washer},
                              {0.5 * valueOf(of, "washer"), washer, nut},
                              {valueOf(of, "nut") / std::sqrt(3.0), nut, top},
                              {radius, top, top + valueOf(of, "stud-end")}}});
    return solids;
}

FixtureSolids toeClampSolids(const FixtureDesign& of) {
    const double nose = valueOf(of, "nose-length"), top = valueOf(of, "grip-height"),
                 noseHalf = 0.5 * valueOf(of, "nose-width"), half = 0.5 * valueOf(of, "width");
    FixtureSolids solids;
    solids.boxes = {{{0.0, -noseHalf, top - valueOf(of, "nose-thickness")}, {nose, noseHalf, top}},
                    {{nose, -half, 0.0}, {nose + valueOf(of, "length"), half, valueOf(of, "height")}}};
    return solids;
}

FixtureSolids screwSolids(const FixtureDesign& of) {
    const double washer = valueOf(of, "washer-thickness"), head = valueOf(of, "head");
    const double headRadius = of.kind == FixtureKind::hexScrew ? head / std::sqrt(3.0) : 0.5 * head;
    FixtureSolids solids;
    solids.rounds.push_back({glm::dvec2(0.0),
                             {{0.5 * valueOf(of, "diameter"), -valueOf(of, "depth"), 0.0, true},
                              {0.5 * valueOf(of, "washer"), 0.0, washer},
                              {headRadius, washer, washer + valueOf(of, "head-height")}}});
    return solids;
}

FixtureSolids parallelsSolids(const FixtureDesign& of) {
    const double length = 0.5 * valueOf(of, "length"), half = 0.5 * valueOf(of, "thickness"),
                 distance = 0.5 * valueOf(of, "distance"), height = valueOf(of, "height");
    FixtureSolids solids;
    for (const double middle : {-distance, distance})
        solids.boxes.push_back({{-length, middle - half, -height}, {length, middle + half, 0.0}});
    return solids;
}

FixtureSolids plateSolids(const FixtureDesign& of) {
    const double length = 0.5 * valueOf(of, "length"), width = 0.5 * valueOf(of, "width");
    FixtureSolids solids;
    solids.boxes = {{{-length, -width, -valueOf(of, "thickness")}, {length, width, 0.0}}};
    return solids;
}

/// A prism around each step, closed by the faces between neighbours of different width.
TriangleMesh roundMesh(const RoundBody& body) {
    const double widest = std::ranges::max(body.steps, {}, &RoundStep::radius).radius;
    const std::uint32_t sides = sidesAround(widest, cylinderChord);
    TriangleMesh mesh;
    std::uint32_t rings = 0;
    const auto ring = [&](const RoundStep& step, double height) {
        ++rings;
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2.0 * pi * i / sides, radius = cornerRadius(step.radius, sides);
            mesh.vertices.emplace_back(body.centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)), height);
        }
    };
    const RoundStep* below = nullptr;
    for (const RoundStep& step : body.steps) {
        // Between steps of the same width there is no face.
        if (below == nullptr || below->radius != step.radius) ring(step, step.low);
        ring(step, step.high);
        below = &step;
    }
    const std::uint32_t bottom = rings * sides, top = bottom + 1;
    mesh.vertices.emplace_back(body.centre, body.steps.front().low);
    mesh.vertices.emplace_back(body.centre, body.steps.back().high);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        for (std::uint32_t r = 0; r + 1 < rings; ++r) {
            const std::uint32_t a = r * sides + i, b = r * sides + next;
            mesh.triangles.push_back({a, b, b + sides});
            mesh.triangles.push_back({a, b + sides, a + sides});
        }
        mesh.triangles.push_back({bottom, next, i});
        mesh.triangles.push_back({top, top - 1 - sides + i, top - 1 - sides + next});
    }
    return mesh;
}

} // namespace

FixtureSolids solidsOf(const FixtureDesign& design) {
    switch (design.kind) {
    case FixtureKind::vise:
        return viseSolids(design);
    case FixtureKind::stepClamp:
        return stepClampSolids(design);
    case FixtureKind::toeClamp:
        return toeClampSolids(design);
    case FixtureKind::hexScrew:
    case FixtureKind::socketScrew:
        return screwSolids(design);
    case FixtureKind::parallels:
        return parallelsSolids(design);
    case FixtureKind::plate:
        return plateSolids(design);
    }
    return {};
}

Box gripOf(const FixtureDesign& of) {
    if (of.kind == FixtureKind::vise) {
        const double jaw = 0.5 * valueOf(of, "jaw-width"), top = valueOf(of, "grip");
        return {{0.0, -jaw, top - valueOf(of, "jaw-height")}, {0.0, jaw, top}};
    }
    if (of.kind == FixtureKind::stepClamp) {
        const double half = 0.5 * valueOf(of, "width"), contact = 0.5 * valueOf(of, "contact");
        return {{-contact, -half, 0.0}, {contact, half, 0.0}};
    }
    const double half = 0.5 * valueOf(of, "nose-width"), top = valueOf(of, "grip-height");
    return {{0.0, -half, top - valueOf(of, "nose-thickness")}, {0.0, half, top}};
}

Placement placementOf(const FixtureDesign& design) noexcept {
    return {turnedAbout({0.0, 0.0, 1.0}, design.turn, glm::dvec3(0.0)).turn, design.place};
}

TriangleMesh meshOf(const FixtureDesign& design) {
    const FixtureSolids solids = solidsOf(design);
    TriangleMesh mesh = boxUnion(solids.boxes, solids.cutAway);
    for (const RoundBody& body : solids.rounds) append(mesh, roundMesh(body));
    place(mesh, placementOf(design));
    return mesh;
}

} // namespace burin
