// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/grid.h"

#include <array>
#include <bit>
#include <cstdint>

namespace burin {

/// A vertex seen along the run axis of a grid: across it on an integer lattice of 1/65,536 voxel whose origin is the
/// centre of scanline (0, 0), so that which lines an edge has on which side is a matter of whole numbers. Triangles
/// that share an edge ask the same question and get the same answer: no line slips between them or hits both.
struct LatticeVertex {
    std::int64_t u = 0, v = 0;
    double along = 0.0; ///< run units from the low end of the grid
};

inline constexpr int latticeBits = 16;

/// Takes vertices to the lattice of a grid.
class LatticeProjection {
public:
    explicit LatticeProjection(const Grid& grid) noexcept
        : low_(grid.low())
        , voxelsPerMillimetre_(1.0 / grid.edge())
        , axisOfU_(grid.axisOfU())
        , axisOfV_(grid.axisOfV())
        , axisOfRuns_(grid.axisOfRuns()) {}

    LatticeVertex operator()(const glm::dvec3& point) const noexcept {
        return {toLattice(u(point)), toLattice(v(point)),
                (point[axisOfRuns_] - low_[axisOfRuns_]) * voxelsPerMillimetre_ * unitsPerVoxel};
    }
    /// Lattice coordinates before they are rounded, for bounds.
    double u(const glm::dvec3& point) const noexcept { return across(point[axisOfU_], low_[axisOfU_]); }
    double v(const glm::dvec3& point) const noexcept { return across(point[axisOfV_], low_[axisOfV_]); }
    /// To the nearest whole number; rises with its argument.
    static std::int64_t toLattice(double coordinate) noexcept {
        constexpr double wholeFromHere = 0x1.8p52; // a double as large has no fraction; holds for |coordinate| < 2^51
        return std::bit_cast<std::int64_t>(coordinate + wholeFromHere) - std::bit_cast<std::int64_t>(wholeFromHere);
    }
    /// Whether the lattice can hold it: finite, and within 2^34 voxels of the grid's low corner.
    bool reaches(const glm::dvec3& point) const noexcept;

private:
    double across(double coordinate, double low) const noexcept {
        return ((coordinate - low) * voxelsPerMillimetre_ - 0.5) * static_cast<double>(std::int64_t{1} << latticeBits);
    }

    glm::dvec3 low_;
    double voxelsPerMillimetre_;
    int axisOfU_, axisOfV_, axisOfRuns_;
};

/// A rectangle of scanlines, half-open.
struct LineRange {
    std::int32_t lowU = 0, lowV = 0, highU = 0, highV = 0;
    bool empty() const noexcept { return lowU >= highU || lowV >= highV; }
};

/// Lines that a triangle between these lattice coordinates may cross, and that lie in a range.
LineRange linesWithin(std::int64_t lowU, std::int64_t lowV, std::int64_t highU, std::int64_t highV,
                      const LineRange& range) noexcept;

/// Which scanlines pass through a triangle. A line on an edge belongs to one of the two triangles there: it counts as
/// moved by next to nothing along u, and by still less against v. Two ways, one answer: by the signs of the edges'
/// functions for small triangles, else by exact division of whole numbers.
class TriangleCover {
public:
    /// @param range only lines in it are looked at
    TriangleCover(const std::array<LatticeVertex, 3>& points, const LineRange& range) noexcept;

    /// Calls visit(u, v, along, leaves) for each line through the triangle: `along` in run units, between those of its
    /// corners; `leaves` where a line that runs upwards leaves an outward mesh. `lowest` and `highest` clamp `along`.
    template <class Visit>
    void forEachLine(double lowest, double highest, Visit&& visit) const;

private:
    struct Edge {
        std::int32_t value = 0, alongU = 0, alongV = 0; ///< inside where the value is not negative; its steps
    };
    struct Row {
        std::int32_t first = 0, end = 0;
        bool leaves = false;
    };

    bool isSmall() const noexcept;
    Edge edge(const LatticeVertex& from, const LatticeVertex& to) const noexcept;
    Row row(std::int32_t v) const noexcept;

    std::array<LatticeVertex, 3> points_;
    LineRange lines_;
};

} // namespace burin

#include "core/volume/line_crossings_impl.h"
