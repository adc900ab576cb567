// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/moments.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

/// A third moment of one line may have 70 bits, and there may be 2^30 lines.
__extension__ typedef __int128 Wide;

/// Sums over the runs of one property: u and v are the line's, counted in lines; s and e the run's begin and end, in
/// run units.
struct RunSums {
    Wide length = 0;             ///< e - s
    Wide u = 0, v = 0;           ///< (e - s) u
    Wide uu = 0, uv = 0, vv = 0; ///< (e - s) u²
    Wide along = 0;              ///< e² - s²: twice the integral
    Wide alongU = 0, alongV = 0; ///< (e² - s²) u
    Wide alongAlong = 0;         ///< e³ - s³: three times the integral

    void addRun(LineIndex line, RunPosition begin, RunPosition end) noexcept {
        const std::int64_t s = begin, e = end, lineU = line.u, lineV = line.v;
        const std::int64_t first = e - s, second = e * e - s * s;
        length += first;
        u += first * lineU;
        v += first * lineV;
        uu += Wide{first * lineU} * lineU;
        uv += Wide{first * lineU} * lineV;
        vv += Wide{first * lineV} * lineV;
        along += second;
        alongU += Wide{second} * lineU;
        alongV += Wide{second} * lineV;
        alongAlong += Wide{e * e} * e - Wide{s * s} * s;
    }
    RunSums& operator+=(const RunSums& other) noexcept {
        length += other.length;
        u += other.u;
        v += other.v;
        uu += other.uu;
        uv += other.uv;
        vv += other.vv;
        along += other.along;
        alongU += other.alongU;
        alongV += other.alongV;
        alongAlong += other.alongAlong;
        return *this;
    }
    /// The sums relative to another origin of lines and positions, all in integers, so that what remains to be rounded
    /// is small.
    RunSums from(std::int64_t lineU, std::int64_t lineV, std::int64_t position) const noexcept {
        RunSums moved;
        moved.length = length;
        moved.u = u - length * lineU;
        moved.v = v - length * lineV;
        moved.uu = uu - 2 * u * lineU + length * lineU * lineU;
        moved.vv = vv - 2 * v * lineV + length * lineV * lineV;
        moved.uv = uv - u * lineV - v * lineU + length * lineU * lineV;
        moved.along = along - 2 * length * position;
        moved.alongU = alongU - 2 * u * position - moved.along * lineU;
        moved.alongV = alongV - 2 * v * position - moved.along * lineV;
        moved.alongAlong = alongAlong - 3 * along * position + 3 * length * position * position;
        return moved;
    }
};

using SumsByProperty = std::array<RunSums, 256>;

std::int64_t nearest(Wide sum, Wide count) {
    return static_cast<std::int64_t>((2 * sum + count) / (2 * count)); // sums are not negative
}

BodyMoments momentsOf(const RunSums& sums, const Grid& grid) {
    BodyMoments body;
    if (sums.length == 0) return body;
    const std::int64_t lineU = nearest(sums.u, sums.length), lineV = nearest(sums.v, sums.length);
    const std::int64_t position = nearest(sums.along, 2 * sums.length);
    const RunSums near = sums.from(lineU, lineV, position);

    // In voxels, relative to the centre of line (lineU, lineV) and that position; the along axis is the third.
    constexpr double unit = 1.0 / unitsPerVoxel;
    const auto number = [](Wide value) { return static_cast<double>(value); };
    const double volume = number(near.length) * unit;
    const glm::dvec3 first = glm::dvec3(number(near.u), number(near.v), number(near.along) * unit / 2.0) * unit;
    const glm::dvec3 offset = first / volume;
    constexpr double ofSquare = 1.0 / 12.0; // of a line's own width
    const double uu = number(near.uu) * unit + volume * ofSquare, vv = number(near.vv) * unit + volume * ofSquare;
    const double uv = number(near.uv) * unit;
    const double ua = number(near.alongU) * unit * unit / 2.0, va = number(near.alongV) * unit * unit / 2.0;
    const double aa = number(near.alongAlong) * unit * unit * unit / 3.0;
    const glm::dmat3 about(uu, uv, ua, uv, vv, va, ua, va, aa);
    const glm::dmat3 second = about - glm::outerProduct(first, offset);

    const double edge = grid.edge(), edge3 = edge * edge * edge;
    const std::array axes{grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    const glm::dvec3 place = offset + glm::dvec3(static_cast<double>(lineU) + 0.5, static_cast<double>(lineV) + 0.5,
                                                 static_cast<double>(position) * unit);
    body.volume = volume * edge3;
    for (int i = 0; i < 3; ++i) {
        const int axis = axes[static_cast<std::size_t>(i)];
        body.centroid[axis] = grid.low()[axis] + edge * place[i];
        for (int k = 0; k < 3; ++k)
            body.secondMoments[axis][axes[static_cast<std::size_t>(k)]] = second[i][k] * edge3 * edge * edge;
    }
    return body;
}

} // namespace

glm::dmat3 BodyMoments::inertia() const noexcept {
    const double trace = secondMoments[0][0] + secondMoments[1][1] + secondMoments[2][2];
    return glm::dmat3(trace) - secondMoments;
}

VolumeMoments moments(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    constexpr std::int32_t rowsPerPart = 32;
    const std::int32_t rows = grid.lineCountV();
    std::vector<SumsByProperty> parts(static_cast<std::size_t>((rows + rowsPerPart - 1) / rowsPerPart));
    parallelFor(std::size_t{0}, parts.size(), [&](std::size_t part) {
        const std::int32_t first = static_cast<std::int32_t>(part) * rowsPerPart;
        for (std::int32_t v = first; v < std::min(first + rowsPerPart, rows); ++v)
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                RunPosition begin = 0;
                for (const Segment segment : volume.line({u, v})) {
                    if (segment.property() != airProperty)
                        parts[part][segment.property()].addRun({u, v}, begin, segment.end());
                    begin = segment.end();
                }
            }
    });
    VolumeMoments result;
    RunSums all;
    for (std::size_t property = 0; property < static_cast<std::size_t>(volume.properties().size()); ++property) {
        RunSums sums;
        for (const SumsByProperty& part : parts) sums += part[property];
        all += sums;
        result.byProperty.push_back(momentsOf(sums, grid));
    }
    result.material = momentsOf(all, grid);
    return result;
}

} // namespace burin
