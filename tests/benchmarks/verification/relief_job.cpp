// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/verification/relief_job.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "tests/benchmarks/measure/session.h"

#include <cmath>

namespace burin::benchmarks {

namespace {

constexpr double waveX = 35.0, waveY = 28.0, amplitude = 3.0; // mm: no radius of curvature is below 4 mm

double heightAt(const ReliefJob& job, double x, double y) {
    return job.base + amplitude * std::sin(2.0 * pi * x / waveX) * std::cos(2.0 * pi * y / waveY);
}

glm::dvec3 normalAt(double x, double y) {
    const double alongX =
        amplitude * 2.0 * pi / waveX * std::cos(2.0 * pi * x / waveX) * std::cos(2.0 * pi * y / waveY);
    const double alongY =
        -amplitude * 2.0 * pi / waveY * std::sin(2.0 * pi * x / waveX) * std::sin(2.0 * pi * y / waveY);
    return glm::normalize(glm::dvec3(-alongX, -alongY, 1.0));
}

/// Top, underside and four walls; closed, normals pointing outwards.
TriangleMesh meshOf(const ReliefJob& job) {
    const auto n = static_cast<std::uint32_t>(job.meshCells);
    TriangleMesh mesh;
    for (const bool top : {true, false})
        for (std::uint32_t j = 0; j <= n; ++j)
            for (std::uint32_t i = 0; i <= n; ++i) {
                const double x = job.side * i / n, y = job.side * j / n;
                mesh.vertices.emplace_back(x, y, top ? heightAt(job, x, y) : 0.0);
            }
    const std::uint32_t under = (n + 1) * (n + 1);
    const auto at = [n](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
            mesh.triangles.push_back({under + a, under + c, under + b});
            mesh.triangles.push_back({under + a, under + d, under + c});
        }
    const auto wall = [&](std::uint32_t a, std::uint32_t b) { // seen from outside, from left to right
        mesh.triangles.push_back({under + a, under + b, b});
        mesh.triangles.push_back({under + a, b, a});
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        wall(at(i, 0), at(i + 1, 0));
        wall(at(n, i), at(n, i + 1));
        wall(at(i + 1, n), at(i, n));
        wall(at(0, i + 1), at(0, i));
    }
    return mesh;
}

Model modelOf(const ReliefJob& job) {
    Body body;
    body.name = "relief";
    body.mesh = meshOf(job);
    body.box = boundingBox(body.mesh);
    Model model;
    model.bodies.push_back(std::move(body));
    return model;
}

/// Rows back and forth, with the tip of the ball that touches the relief; one rapid down to it and one away.
std::string programOf(const ReliefJob& job, const glm::dvec3& zero) {
    std::string text = "G21 G90 G17 G54\nT1 M6\nS18000 M3\n";
    const auto move = [&](const char* words, const glm::dvec3& place) {
        const glm::dvec3 at = place - zero;
        text += std::string(words) + "X" + formatFixed(at.x, 3) + " Y" + formatFixed(at.y, 3) + " Z" +
                formatFixed(at.z, 3) + "\n";
    };
    const auto tip = [&](int row, int column) {
        const double x = job.side * column / (job.movesPerRow - 1), y = job.side * row / (job.rows - 1);
        const glm::dvec3 touching(x, y, heightAt(job, x, y));
        return touching + job.toolRadius * (normalAt(x, y) - glm::dvec3(0.0, 0.0, 1.0));
    };
    text += "G0 Z5\n";
    const glm::dvec3 start = tip(0, 0);
    move("G0 ", {start.x, start.y, zero.z + 5.0});
    for (int row = 0; row < job.rows; ++row)
        for (int i = 0; i < job.movesPerRow; ++i)
            move(row + i == 0 ? "G1 F2000 " : "", tip(row, row % 2 == 0 ? i : job.movesPerRow - 1 - i));
    return text + "G0 Z5\nM2\n";
}

Tool ballTool(double radius) {
    Tool tool;
    tool.id = "ball";
    tool.cutter = {CutterType::ball, 2.0 * radius,        radius, 8.0 * radius, 2.0 * radius,
                   14.0 * radius,    {{20.0, 20.0, 15.0}}};
    return tool;
}

MachineProfile machine() {
    MachineProfile profile;
    profile.id = "bench";
    profile.travel = {1000.0, 1000.0, 500.0};
    profile.maximumFeed = 5000.0;
    profile.rapidFeed = 10000.0;
    profile.maximumSpindleSpeed = 24000.0;
    profile.acceleration = 1000.0;
    return profile;
}

} // namespace

ReliefScene::ReliefScene(const ReliefJob& job) : model(modelOf(job)), part(model.bodies.front().mesh) {
    Setup setup;
    setup.voxel = job.voxel;
    setup.marginLow = {5.0, 5.0, job.below};
    setup.marginHigh = {5.0, 5.0, job.overTop};
    request.setup = require(placeStock(model, setup), "the relief's stock");
    request.model = &model;
    request.part = &part;
    request.tool = ballTool(job.toolRadius);
    request.machine = machine();
    Obstacle clamp; // beside the stock, half as high
    clamp.name = "clamp";
    clamp.shape = Box{{-25.0, 0.0, -5.0}, {-12.0, job.side, 0.5 * job.base}};
    request.obstacles = {clamp};
    text = programOf(job, request.setup.workOffset);
}

} // namespace burin::benchmarks
