// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tool_field.h"
#include "tests/core/geometry/shapes.h"

#include <benchmark/benchmark.h>

namespace {

using namespace burin;

double bumpyRadius(double longitude, double latitude) {
    return 50.0 + 1.5 * std::sin(7.0 * longitude) * std::cos(5.0 * latitude) * std::cos(latitude);
}

/// A star-shaped body with 217,140 triangles.
const MeshDistance& bumpy() {
    static const MeshDistance mesh(shapes::starShaped(330, 330, bumpyRadius));
    return mesh;
}

std::vector<RevolvedPiece> tool(double corner) {
    return {{0.0, 20.0, 3.0, 3.0, corner}, {20.0, 40.0, 3.0, 3.0, 0.0}, {40.0, 60.0, 10.0, 16.0, 0.0}};
}

/// Positions around the bumpy ball, as along a tool path.
struct Way {
    double longitude = 0.0;
    glm::dvec3 next(double gap) {
        longitude += 3e-4;
        const double latitude = 0.6 + 0.3 * std::sin(3.0 * longitude);
        const glm::dvec3 out{std::cos(longitude) * std::cos(latitude), std::sin(longitude) * std::cos(latitude),
                             std::sin(latitude)};
        return (bumpyRadius(longitude, latitude) + gap) * out;
    }
};

void closestPoint(benchmark::State& state) {
    Way way;
    for (auto _ : state) benchmark::DoNotOptimize(bumpy().closest(way.next(0.5), 2.0));
}
BENCHMARK(closestPoint);

/// Argument: corner radius in hundredths of a millimetre: ball, bull nose, flat.
void toolClearance(benchmark::State& state) {
    const std::vector<RevolvedPiece> pieces = tool(0.01 * static_cast<double>(state.range(0)));
    Way way;
    for (auto _ : state) {
        const glm::dvec3 tip = way.next(3.3) - glm::dvec3(0.0, 0.0, 3.0);
        benchmark::DoNotOptimize(bumpy().clearance(pieces, {tip, {0.0, 0.0, 1.0}}, 1.0));
    }
}
BENCHMARK(toolClearance)->Arg(300)->Arg(100)->Arg(0);

/// A body of 110 x 60 x 35 mm, like a computer mouse; 239,200 triangles.
void fieldOfTool(benchmark::State& state) {
    const MeshDistance part(shapes::starShaped(400, 300, [](double u, double v) {
        const double x = std::abs(std::cos(v) * std::cos(u)) / 55.0, y = std::abs(std::cos(v) * std::sin(u)) / 30.0;
        const double z = std::abs(std::sin(v)) / (v > 0.0 ? 25.0 : 10.0);
        return 1.0 / std::cbrt(x * x * x + y * y * y + z * z * z);
    }));
    const Box box = part.bounds();
    const ToolFieldRequest request{tool(0.01 * static_cast<double>(state.range(0))),
                                   {box.low - glm::dvec3(5.0, 5.0, 0.0), box.high + glm::dvec3(5.0, 5.0, 20.0)},
                                   0.5,
                                   1.0};
    for (auto _ : state) {
        Progress progress;
        const Result<ToolField> field = ToolField::build(part, request, progress);
        state.counters["megabytes"] = 1e-6 * static_cast<double>(field->memoryBytes());
    }
}
BENCHMARK(fieldOfTool)->Arg(300)->Arg(100)->Arg(0)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();

void fieldSample(benchmark::State& state) {
    Progress progress;
    const Result<ToolField> field =
        ToolField::build(bumpy(), {tool(3.0), {{-20, -20, 40}, {20, 20, 60}}, 0.5, 1.0}, progress);
    double place = 0.0;
    for (auto _ : state) {
        place = place < 20.0 ? place + 1e-4 : -20.0;
        benchmark::DoNotOptimize(field->at({place, 0.3, 51.0}));
    }
}
BENCHMARK(fieldSample);

} // namespace
