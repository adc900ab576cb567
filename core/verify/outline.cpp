// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/outline.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::size_t grain = 16; // number of rows or columns that justify another core

bool holdsThePart(const RunVolume& workpiece, LineIndex line) {
    for (const Segment segment : workpiece.line(line))
        if (workpiece.properties().isProtected(segment.property())) return true;
    return false;
}

/// Squares of the distances, in lines, to the nearest line outside, after Felzenszwalb & Huttenlocher (2012): one lower
/// envelope of parabolas per row, then per column. Positions beyond the grid count as outside.
void envelope(std::vector<double>& values) {
    const auto count = static_cast<int>(values.size());
    std::vector<int> vertex(values.size());
    std::vector<double> border(values.size() + 1);
    const auto meet = [&](int p, int q) {
        return (values[static_cast<std::size_t>(q)] + q * q - values[static_cast<std::size_t>(p)] - p * p) /
               (2.0 * (q - p));
    };
    int last = 0;
    vertex[0] = 0;
    border[0] = -1e300;
    border[1] = 1e300;
    for (int q = 1; q < count; ++q) {
        double at = meet(vertex[static_cast<std::size_t>(last)], q);
        while (last > 0 && at <= border[static_cast<std::size_t>(last)])
            at = meet(vertex[static_cast<std::size_t>(--last)], q);
        if (at <= border[static_cast<std::size_t>(last)]) { // the new parabola is lowest everywhere
            vertex[0] = q;
            last = 0;
            border[1] = 1e300;
            continue;
        }
        vertex[static_cast<std::size_t>(++last)] = q;
        border[static_cast<std::size_t>(last)] = at;
        border[static_cast<std::size_t>(last) + 1] = 1e300;
    }
    std::vector<double> result(values.size());
    int segment = 0;
    for (int q = 0; q < count; ++q) {
        while (border[static_cast<std::size_t>(segment) + 1] < q) ++segment;
        const int p = vertex[static_cast<std::size_t>(segment)];
        result[static_cast<std::size_t>(q)] = (q - p) * (q - p) + values[static_cast<std::size_t>(p)];
    }
    values = std::move(result);
}

} // namespace

ShrunkOutline::ShrunkOutline(const RunVolume& workpiece, double distance) : grid_(workpiece.grid()) {
    const auto width = static_cast<std::size_t>(grid_.lineCountU()),
               height = static_cast<std::size_t>(grid_.lineCountV());
    constexpr double far = 1e12;
    std::vector<double> squares((width + 2) * (height + 2), 0.0); // with a border of outside cells around the grid
    parallelIntervals(std::size_t{1}, height + 1, grain, [&](std::size_t from, std::size_t to) {
        std::vector<double> row(width + 2);
        for (std::size_t v = from; v != to; ++v) {
            for (std::size_t u = 1; u <= width; ++u)
                row[u] = holdsThePart(workpiece, {static_cast<std::int32_t>(u - 1), static_cast<std::int32_t>(v - 1)})
                             ? far
                             : 0.0;
            row.front() = row.back() = 0.0;
            envelope(row);
            std::copy(row.begin(), row.end(), squares.begin() + static_cast<std::ptrdiff_t>(v * (width + 2)));
        }
    });
    const double limit = distance / grid_.edge();
    inside_.resize(width * height);
    parallelIntervals(std::size_t{1}, width + 1, grain, [&](std::size_t from, std::size_t to) {
        std::vector<double> column(height + 2);
        for (std::size_t u = from; u != to; ++u) {
            for (std::size_t v = 0; v < height + 2; ++v) column[v] = squares[v * (width + 2) + u];
            envelope(column);
            for (std::size_t v = 1; v <= height; ++v) inside_[(v - 1) * width + u - 1] = column[v] > limit * limit;
        }
    });
}

bool ShrunkOutline::contains(double x, double y) const noexcept {
    const glm::dvec2 place = (glm::dvec2(x, y) - glm::dvec2(grid_.low())) / grid_.edge();
    const LineIndex line{static_cast<std::int32_t>(std::floor(place.x)),
                         static_cast<std::int32_t>(std::floor(place.y))};
    if (!grid_.contains(line)) return false;
    return inside_[static_cast<std::size_t>(line.v) * static_cast<std::size_t>(grid_.lineCountU()) +
                   static_cast<std::size_t>(line.u)] != 0;
}

} // namespace burin
