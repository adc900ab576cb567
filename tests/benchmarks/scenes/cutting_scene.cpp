// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/scenes/cutting_scene.h"

#include "core/base/parallel.h"
#include "tests/benchmarks/measure/session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace burin::benchmarks {

namespace {

constexpr PropertyIndex partProperty = materialCount;

/// The content of one line, converted from shares of the grid's side to segments.
class LineMaker {
public:
    explicit LineMaker(const Grid& grid) : lineEnd_(grid.lineEnd()) {}

    void clear() { segments_.clear(); }
    /// Multiplies shares of the side by a factor.
    void interval(double by) noexcept { interval_ = by; }
    /// Material up to a position; positions below the last one add nothing.
    void upTo(double share, PropertyIndex property) {
        const double units = std::clamp(share * interval_, 0.0, 1.0) * lineEnd_;
        const auto end = static_cast<RunPosition>(std::lround(units));
        if (end > reached()) segments_.emplace_back(end, property);
    }
    const std::vector<Segment>& finish() {
        upTo(1.0, airProperty);
        return segments_;
    }

private:
    RunPosition reached() const { return segments_.empty() ? 0 : segments_.back().end(); }
    RunPosition lineEnd_;
    std::vector<Segment> segments_;
    double interval_ = 1.0;
};

/// Fills every line of a volume; `make(x, y, line)` gets the line's position as shares of the sides.
template <class Make>
RunVolume volumeOfLines(const Grid& grid, std::size_t reserve, const Make& make) {
    RunVolume volume = require(RunVolume::make(grid, sceneMaterials(), reserve), "a benchmark's volume");
    const std::int32_t countU = grid.lineCountU(), countV = grid.lineCountV();
    constexpr std::int32_t rowsAtOnce = 32; // made in parallel, written by the single writer
    std::vector<LineMaker> lines(static_cast<std::size_t>(rowsAtOnce * countU), LineMaker(grid));
    for (std::int32_t first = 0; first < countV; first += rowsAtOnce) {
        Session::throwIfCancelled();
        const std::int32_t end = std::min(first + rowsAtOnce, countV);
        parallelFor(first, end, [&](std::int32_t v) {
            for (std::int32_t u = 0; u < countU; ++u) {
                LineMaker& line = lines[static_cast<std::size_t>((v - first) * countU + u)];
                line.clear();
                make((u + 0.5) / countU, (v + 0.5) / countV, line);
            }
        });
        for (std::int32_t v = first; v < end; ++v)
            for (std::int32_t u = 0; u < countU; ++u)
                if (!volume.setLine({u, v}, lines[static_cast<std::size_t>((v - first) * countU + u)].finish()))
                    throw std::runtime_error("a benchmark's volume does not fit its reserve");
    }
    return volume;
}

bool inMargin(double x, double y) {
    constexpr double margin = 0.03;
    return x < margin || y < margin || x > 1.0 - margin || y > 1.0 - margin;
}

/// The two faces of the part above a point: a slightly flattened bumpy ball.
struct PartFaces {
    double low = 0.5, high = 0.5;
};
PartFaces partFaces(double x, double y) {
    const double dx = x - 0.5, dy = y - 0.5;
    const double square = 0.32 * 0.32 - dx * dx - dy * dy;
    if (square <= 0.0) return {};
    const double half = 0.8 * std::sqrt(square);
    const double fade = std::min(1.0, half / 0.05); // bumps fade out at the border of the part
    const double bump = 0.012 * fade * std::sin(40.0 * x) * std::cos(36.0 * y);
    return {0.5 - half - bump, 0.5 + half + bump};
}

/// Layers and part up to `top`, which is a share of the line.
void layeredLine(double x, double y, double top, LineMaker& line) {
    if (inMargin(x, y)) return;
    const PartFaces part = partFaces(x, y);
    const std::array<double, 4> tops{0.06 + 0.25 * x - 0.14 * y, 0.45 - 0.12 * x + 0.06 * y, 0.70 + 0.05 * x - 0.14 * y,
                                     0.97};
    line.upTo(0.03, airProperty);
    const auto layersUpTo = [&](double place) {
        for (std::size_t i = 0; i < tops.size(); ++i)
            line.upTo(std::min({tops[i], place, top}), static_cast<PropertyIndex>(i + 1));
    };
    layersUpTo(part.low);
    line.upTo(std::min(part.high, top), partProperty);
    layersUpTo(1.0);
}

/// The freeform face with the scallops of a ball of 25 voxels, rows 8 voxels apart.
double freeformHeight(double x, double y, double side) {
    const double smooth = 0.62 + 0.10 * std::sin(3.1 * x + 0.4) * std::cos(2.7 * y) + 0.05 * std::sin(7.0 * x * y);
    constexpr double radius = 25.0, stepOver = 8.0;
    const double aside = std::remainder(y * side, stepOver);
    return smooth + (radius - std::sqrt(radius * radius - aside * aside)) / side;
}

} // namespace

PropertyList sceneMaterials() {
    PropertyList list;
    for (int i = 1; i <= materialCount; ++i) {
        Property material;
        material.id = i < materialCount ? "stock-" + std::to_string(i) : std::string("part");
        (void)require(list.add(material), "a benchmark's material");
    }
    return list;
}

Grid sceneGrid(std::int32_t side, RunAxis axis) {
    return require(Grid::make(glm::dvec3(0.0), 1.0, glm::ivec3(side), axis), "a benchmark's grid");
}

RunVolume layeredBlock(std::int32_t side, RunAxis axis) {
    return volumeOfLines(sceneGrid(side, axis), 0,
                         [](double x, double y, LineMaker& line) { layeredLine(x, y, 1.0, line); });
}

RunVolume halfBlock(std::int32_t side) {
    constexpr double half = 0.53; // at this height the walks' depths pass through layers and part
    return volumeOfLines(sceneGrid(side), 0, [](double x, double y, LineMaker& line) {
        line.interval(1.0 / half);
        layeredLine(x, y, half, line);
    });
}

RunVolume shiftedBlock(std::int32_t side) {
    return volumeOfLines(sceneGrid(side), 0,
                         [](double x, double y, LineMaker& line) { layeredLine(1.09 - y, x - 0.13, 0.88, line); });
}

Box layeredBlockBox(double side) {
    return {glm::dvec3(0.03 * side), glm::dvec3(0.97 * side)};
}

Box shiftedBlockBox(double side) {
    return {side * glm::dvec3(0.16, 0.12, 0.03), side * glm::dvec3(1.0, 1.0, 0.88)};
}

RunVolume scallopedFreeform(std::int32_t side) {
    return volumeOfLines(sceneGrid(side), 0, [=](double x, double y, LineMaker& line) {
        layeredLine(x, y, freeformHeight(x, y, side), line);
    });
}

RunVolume gyroidLattice(std::int32_t side, int runsPerLine) {
    const Grid grid = sceneGrid(side);
    const double turns = 2.0 * std::numbers::pi * runsPerLine;
    const std::size_t segments =
        static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(2 * runsPerLine + 8);
    // sin x cos y + sin y cos z + sin z cos x > 0 is sin(z + phase) > level on a line along z.
    return volumeOfLines(grid, 2 * segments * sizeof(Segment), [=](double x, double y, LineMaker& line) {
        const double a = turns * x, b = turns * y;
        const double along = std::cos(a), across = std::sin(b), rest = std::sin(a) * std::cos(b);
        const double size = std::hypot(along, across), phase = std::atan2(across, along);
        const double level = -rest / size;
        if (level >= 1.0) return;
        if (level <= -1.0) return line.upTo(1.0, 1);
        const double rise = std::asin(level);
        for (int turn = -1; turn <= runsPerLine + 1; ++turn) {
            const double start = 2.0 * std::numbers::pi * turn + rise - phase;
            line.upTo(start / turns, airProperty);
            line.upTo((start + std::numbers::pi - 2.0 * rise) / turns, 1);
        }
    });
}

RunVolume plainBlock(const glm::ivec3& extent) {
    SlotStock stock;
    stock.extent = extent;
    stock.top = extent.z;
    return slotStock(stock);
}

RunVolume slotStock(const SlotStock& stock) {
    const Grid grid = require(Grid::make(glm::dvec3(0.0), stock.edge, stock.extent, stock.axis), "a benchmark's grid");
    constexpr std::size_t reserve = 8U << 20U; // bytes: many volumes are made one after another
    // x and y are shares of u and v: of x and y for runs along z, of y and z for runs along x.
    if (stock.axis == RunAxis::z)
        return volumeOfLines(grid, reserve, [&](double x, double y, LineMaker& line) {
            const glm::dvec2 place(x * stock.extent.x, y * stock.extent.y);
            if (!stock.half || glm::dot(stock.side, place - stock.through) > 0.0)
                line.upTo(stock.top / stock.extent.z, 1);
        });
    return volumeOfLines(grid, reserve, [&](double y, double z, LineMaker& line) {
        if (z * stock.extent.z > stock.top) return;
        if (!stock.half) return line.upTo(1.0, 1);
        // side.x (x - through.x) > -side.y (y - through.y)
        const double rest = stock.side.y * (y * stock.extent.y - stock.through.y);
        if (stock.side.x == 0.0) return line.upTo(rest > 0.0 ? 1.0 : 0.0, 1);
        const double crossing = (stock.through.x - rest / stock.side.x) / stock.extent.x;
        line.upTo(stock.side.x > 0.0 ? crossing : 0.0, airProperty);
        line.upTo(stock.side.x > 0.0 ? 1.0 : crossing, 1);
    });
}

std::uint64_t countRuns(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    std::uint64_t runs = 0;
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            for (const Segment segment : volume.line({u, v})) runs += segment.property() != airProperty ? 1U : 0U;
    return runs;
}

} // namespace burin::benchmarks
