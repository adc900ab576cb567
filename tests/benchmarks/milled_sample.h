// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <algorithm>
#include <cmath>

namespace burin::test {

/// A dome in a block of 120 × 70 × 45 mm, like a computer mouse: roughed in terraces, one half finished with a ball end
/// mill of 6 mm, which leaves scallops.
class MilledSample {
public:
    static constexpr double length = 120.0, width = 70.0, height = 45.0, floor = 8.0;

    explicit MilledSample(double voxel) : workpiece(block(voxel)) {
        addDome();
        rough();
        finish();
    }

    static double domeHeight(double x, double y) {
        const double a = (x - 60.0) / 50.0, b = (y - 35.0) / 27.0, rest = 1.0 - a * a - b * b;
        return rest <= 0.0 ? 0.0 : floor + 28.0 * std::sqrt(rest) * (1.0 - 0.2 * a);
    }

    /// One pass of the finishing ball along x; the cut stays in the workpiece.
    void pass(double y, double fromX, double toX, double step = 0.5) {
        MaterialRemoval ball({CutterType::ball, 6.0, 3.0, 20.0, 6.0, 50.0, {}}, workpiece.grid());
        const auto tip = [&](double x) { return glm::dvec3(x, y, tipHeight(x, y)); };
        for (double x = fromX; x < toX; x += step) ball.cut(workpiece, tip(x), tip(x + step));
    }

    RunVolume workpiece;

private:
    static RunVolume block(double voxel) {
        const glm::ivec3 count(glm::round(glm::dvec3(length, width, height) / voxel));
        const Grid grid = Grid::make(glm::dvec3(0.0), voxel, count).value();
        PropertyList properties;
        Property stock, protectedPart;
        stock.id = "stock";
        stock.colour = {190, 195, 200};
        protectedPart.id = "part";
        protectedPart.machinability = Machinability::isProtected;
        (void)properties.add(stock);
        (void)properties.add(protectedPart);
        RunVolume volume = RunVolume::make(grid, properties).value();
        (void)volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.lineEnd(), 1);
        return volume;
    }
    void addDome() {
        const Grid& grid = workpiece.grid();
        for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                const glm::dvec2 place = grid.lineCentre({u, v});
                const double top = domeHeight(place.x, place.y);
                if (top > floor)
                    (void)workpiece.fillSpan({u, v}, grid.toRunPosition(floor), grid.toRunPosition(top), 2);
            }
    }
    /// Roughs round the dome with a flat end mill of 10 mm, 4 mm deeper each time.
    void rough() {
        MaterialRemoval flat({CutterType::flat, 10.0, 0.0, 30.0, 10.0, 60.0, {}}, workpiece.grid());
        for (double z = height - 4.0; z > floor; z -= 4.0)
            for (double y = 4.0; y < width - 4.0; y += 4.0)
                for (double x = 4.0; x < length - 4.0; x += 2.0) {
                    const auto high = [&](double at) { return highestDome(at, y, 6.0) > z ? height : z; };
                    flat.cut(workpiece, {x, y, high(x)}, {x, y, high(x)});
                    if (high(x) == z && high(x + 2.0) == z) flat.cut(workpiece, {x, y, z}, {x + 2.0, y, z});
                }
    }
    void finish() {
        for (double y = 6.0; y < 35.0; y += 1.0) pass(y, 6.0, length - 6.0);
    }
    static double highestDome(double x, double y, double radius) {
        double highest = 0.0;
        for (double turn = 0.0; turn < 6.28; turn += 0.2)
            for (const double reach : {0.0, 0.5 * radius, radius})
                highest = std::max(highest, domeHeight(x + reach * std::cos(turn), y + reach * std::sin(turn)));
        return highest;
    }
    /// The height of a ball's tip that rests on the dome.
    static double tipHeight(double x, double y) {
        double highest = floor;
        for (double dx = -3.0; dx <= 3.0; dx += 0.5)
            for (double dy = -3.0; dy <= 3.0; dy += 0.5) {
                const double square = 9.0 - dx * dx - dy * dy;
                if (square < 0.0) continue;
                highest = std::max(highest, domeHeight(x + dx, y + dy) + std::sqrt(square) - 3.0);
            }
        return highest;
    }
};

} // namespace burin::test
