// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/line_interval.h"
#include "core/tool/tool_solid.h"
#include "core/volume/runs/grid.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

struct Cutter;

/// Positions of the tip along the runs, in run units from the low end of a grid, while it is nearest to one point of
/// the lattice across the runs.
struct SolidStay {
    std::int32_t u = 0, v = 0;      ///< the scanline that tool lines are counted from
    std::int32_t layer = 0;         ///< of SolidColumns: where the point lies within a voxel
    std::int64_t low = 0, high = 0; ///< run units
};

/// A tool that doesn't turn or is hollow as runs on the scanlines of a workpiece (paper, eq. 3: an S-RLE of the tool).
/// Across the runs its tip is moved to the nearest point of a lattice of a quarter of a voxel (of half a voxel or a
/// voxel, if the tool is so large that its runs would take too much memory): by half of that at most along u and along
/// v. Along the runs it is exact to a run unit. For each of these positions within a voxel (a layer) the runs of the
/// tool are computed in advance, so that a pose is a merge of runs, line by line. Immutable after construction; any
/// number of threads may read it.
class SolidColumns {
public:
    enum class Section : std::uint8_t { flutes, shank };

    /// Cost: voxelises the tool up to 16 times. @throws std::bad_alloc
    SolidColumns(const ToolSolid& solid, const Grid& grid);

    bool hasShank() const noexcept { return hasShank_; }

    /// Calls `visit(line, from, to)` for each run of a section over all poses of a stay, clipped to the grid, in rows
    /// (v) of `rows`; stops when it returns false. Leaves out what the poses of another stay hold as well.
    /// @param covered may be null
    template <class Visit>
    void forEachSpan(Section section, const Grid& grid, const SolidStay& stay, const SolidStay* covered,
                     LineInterval rows, Visit&& visit) const noexcept {
        const Layer& layer = layerOf(section, stay);
        const Layer* before = covered != nullptr ? &layerOf(section, *covered) : nullptr;
        const std::int64_t end = grid.lineEnd();
        const std::int32_t lastV = std::min(rows.last, stay.v + layer.lowV + layer.countV - 1);
        const std::int32_t firstU = std::max(0, stay.u + layer.lowU);
        const std::int32_t lastU = std::min(grid.lineCountU(), stay.u + layer.lowU + layer.countU) - 1;
        for (std::int32_t v = std::max(rows.first, stay.v + layer.lowV); v <= lastV; ++v)
            for (std::int32_t u = firstU; u <= lastU; ++u)
                for (const Piece& piece : layer.at(u - stay.u, v - stay.v)) {
                    const std::int64_t from = piece.from + stay.low, to = piece.to + stay.high;
                    if (to <= 0 || from >= end) continue;
                    if (before != nullptr && holds(before->at(u - covered->u, v - covered->v), *covered, from, to))
                        continue;
                    if (!visit(LineIndex{u, v}, static_cast<RunPosition>(std::max<std::int64_t>(from, 0)),
                               static_cast<RunPosition>(std::min(to, end))))
                        return;
                }
    }

private:
    friend class SolidTrack;

    /// A run of the tool on one line, run units from the tip.
    struct Piece {
        std::int32_t from = 0, to = 0;
    };
    /// The runs of a section for one position of the tip within a voxel; lines are counted from that of the tip.
    struct Layer {
        std::int32_t lowU = 0, lowV = 0, countU = 0, countV = 0;
        std::vector<std::uint32_t> begin; ///< of each line, u counting fastest, and the end of the last
        std::vector<Piece> pieces;

        std::span<const Piece> at(std::int32_t u, std::int32_t v) const noexcept {
            u -= lowU;
            v -= lowV;
            if (u < 0 || v < 0 || u >= countU || v >= countV) return {};
            const auto line =
                static_cast<std::size_t>(v) * static_cast<std::size_t>(countU) + static_cast<std::size_t>(u);
            return std::span(pieces).subspan(begin[line], begin[line + 1] - begin[line]);
        }
    };
    static bool holds(std::span<const Piece> pieces, const SolidStay& stay, std::int64_t from,
                      std::int64_t to) noexcept {
        return std::ranges::any_of(
            pieces, [&](const Piece& piece) { return piece.from + stay.low <= from && piece.to + stay.high >= to; });
    }
    const Layer& layerOf(Section section, const SolidStay& stay) const noexcept {
        return (section == Section::flutes ? flutes_ : shank_)[static_cast<std::size_t>(stay.layer)];
    }
    void addLayer(const TriangleMesh& flutes, const TriangleMesh& shank, const Grid& lines, std::int32_t pointU,
                  std::int32_t pointV);

    std::int32_t points_ = 4; ///< of the lattice per voxel, along u and along v: 4, 2 or 1
    bool hasShank_ = false;
    std::vector<Layer> flutes_, shank_; ///< pointU + points_ * pointV
    glm::dvec3 low_{0.0}, high_{0.0};   ///< voxels from the tip, line frame: a box around the tool
};

/// The columns of a cutter's solid, for all that share them; null if the cutter has none. @throws std::bad_alloc
std::shared_ptr<const SolidColumns> columnsOf(const Cutter& cutter, const Grid& grid);

/// A straight move of an upright tool as stays, in order; their poses are those of the move, with the tip on the
/// lattice. The union of the tool over the stays is what the tool so moved sweeps, however long the move is: splitting
/// a move changes nothing but the rounding of its ends. Stays that can't reach the grid are left out.
class SolidTrack {
public:
    /// @param from, to tips, mm, setup frame, finite
    SolidTrack(const SolidColumns& columns, const Grid& grid, const glm::dvec3& from, const glm::dvec3& to) noexcept;

    /// The next stay; empty after the last one.
    std::optional<SolidStay> next() noexcept;

    /// The stay of a tip at rest; empty if it is too far away to reach the grid.
    static std::optional<SolidStay> at(const SolidColumns& columns, const Grid& grid, const glm::dvec3& tip) noexcept;

private:
    glm::dvec3 placeAt(double share) const noexcept;

    std::int32_t points_;
    glm::dvec3 from_, to_;                 ///< tips: points of the lattice across the runs, run units along them
    double share_ = 0.0, last_ = 0.0;      ///< of the move: where the next stay begins, where the last one ends
    std::int64_t u_ = 0, v_ = 0;           ///< point of the lattice
    std::int64_t stepsU_ = 0, stepsV_ = 0; ///< still to be made along u and along v
    bool more_ = false;
};

} // namespace burin
