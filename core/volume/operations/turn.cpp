// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/turn.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// A plane of the grid that contains both run axes, converted: scanlines along the new axis one after another.
struct Slice {
    std::vector<std::uint32_t> firsts; ///< by index along the old axis, and the end of the last
    std::vector<Segment> segments;
    RunPosition greatestDisplacement = 0;
};

/// A segment of an old scanline, and the properties of its neighbours.
struct Piece {
    RunPosition from = 0, to = 0;
    PropertyIndex property = airProperty;
    std::optional<PropertyIndex> below, above;
};

Piece pieceOf(std::span<const Segment> line, std::size_t index) noexcept {
    Piece piece;
    piece.to = line[index].end();
    piece.property = line[index].property();
    if (index > 0) {
        piece.from = line[index - 1].end();
        piece.below = line[index - 1].property();
    }
    if (index + 1 < line.size()) piece.above = line[index + 1].property();
    return piece;
}

/// A boundary between two properties that continues from one old scanline to the next.
struct Crossing {
    RunPosition here = 0, there = 0; ///< along the old axis, on this line and on the next
    RunPosition distance() const noexcept { return here < there ? there - here : here - there; }
};

/// Converts slices one by one; keeps its working memory.
class SliceTurning {
public:
    SliceTurning(const VolumeSnapshot& volume, RunAxis axis)
        : volume_(volume)
        , newAlongU_(volume.grid().axisOfU() == static_cast<int>(axis))
        , lineCount_(newAlongU_ ? volume.grid().lineCountU() : volume.grid().lineCountV()) {}

    /// @param index  along the axis that is perpendicular to both
    void turn(std::int32_t index, Slice& slice) {
        ends_.clear();
        displacement_ = 0;
        const auto along = static_cast<std::size_t>(volume_.grid().voxelsPerLine());
        std::span<const Segment> here = line(index, 0);
        for (std::int32_t at = 0; at < lineCount_; ++at) {
            notePlace(here);
            const std::span<const Segment> next = at + 1 < lineCount_ ? line(index, at + 1) : here;
            if (at + 1 < lineCount_) compare(here, next, at);
            here = next;
        }
        closeLines(here);
        // Sorted by index along the old axis; for each in the order in which they were found.
        slice.firsts.assign(along + 1, 0);
        for (const End& end : ends_) ++slice.firsts[static_cast<std::size_t>(end.place) + 1];
        for (std::size_t place = 0; place < along; ++place) slice.firsts[place + 1] += slice.firsts[place];
        next_.assign(slice.firsts.begin(), slice.firsts.end() - 1);
        slice.segments.resize(ends_.size());
        for (const End& end : ends_) slice.segments[next_[static_cast<std::size_t>(end.place)]++] = end.segment;
        slice.greatestDisplacement = displacement_;
    }

private:
    /// A new scanline's segment.
    struct End {
        std::int32_t place = 0; ///< along the old axis, voxels
        Segment segment;
    };

    std::span<const Segment> line(std::int32_t index, std::int32_t at) const noexcept {
        return volume_.line(newAlongU_ ? LineIndex{at, index} : LineIndex{index, at});
    }

    /// Rounding of run ends to voxel faces.
    void notePlace(std::span<const Segment> segments) noexcept {
        for (const Segment segment : segments) {
            const RunPosition beyond = segment.end() % unitsPerVoxel;
            displacement_ = std::max(displacement_, std::min(beyond, unitsPerVoxel - beyond));
        }
    }

    /// Finds the voxels in which two neighbouring lines differ.
    void compare(std::span<const Segment> here, std::span<const Segment> next, std::int32_t at) {
        if (here.size() == next.size() && std::ranges::equal(here, next)) return;
        RunPosition from = 0;
        for (std::size_t i = 0, k = 0; i < here.size();) {
            const RunPosition to = std::min(here[i].end(), next[k].end());
            const std::int32_t first = firstVoxelFrom(from), end = firstVoxelFrom(to);
            if (first < end && here[i].property() != next[k].property()) {
                const Piece a = pieceOf(here, i), b = pieceOf(next, k);
                const RunPosition face = static_cast<RunPosition>(at + 1) * unitsPerVoxel;
                const std::optional<Crossing> crossing = boundary(a, b);
                for (std::int32_t place = first; place < end; ++place)
                    ends_.push_back(
                        {place, Segment(crossing ? interpolated(*crossing, place, face) : face, a.property)});
            }
            from = to;
            if (here[i].end() == to) ++i;
            if (next[k].end() == to) ++k;
        }
    }

    /// The boundary between the properties of two adjacent pieces, if both lines have it.
    static std::optional<Crossing> boundary(const Piece& here, const Piece& next) noexcept {
        constexpr RunPosition farthest = 8 * unitsPerVoxel;
        std::optional<Crossing> best;
        const auto offer = [&](const Crossing& crossing) {
            const bool whole = crossing.here % unitsPerVoxel == 0 && crossing.there % unitsPerVoxel == 0;
            if (whole || crossing.distance() > farthest) return;
            if (!best || crossing.distance() < best->distance()) best = crossing;
        };
        if (here.above == next.property && next.below == here.property) offer({here.to, next.from});
        if (here.below == next.property && next.above == here.property) offer({here.from, next.to});
        return best;
    }

    RunPosition interpolated(const Crossing& crossing, std::int32_t place, RunPosition face) noexcept {
        const auto from = static_cast<double>(crossing.here), to = static_cast<double>(crossing.there);
        const double share = to == from ? 0.5 : (static_cast<double>(centreOf(place)) - from) / (to - from);
        // The voxels on both sides keep the property at their centres.
        const double offset = std::clamp(share * unitsPerVoxel, 1.0, static_cast<double>(unitsPerVoxel));
        const RunPosition end = face - unitsPerVoxel / 2 + static_cast<RunPosition>(offset + 0.5);
        displacement_ = std::max(displacement_, end < face ? face - end : end - face);
        return end;
    }

    /// Extends the properties of the last old line to the end of each new line.
    void closeLines(std::span<const Segment> last) {
        const RunPosition lineEnd = static_cast<RunPosition>(lineCount_) * unitsPerVoxel;
        std::int32_t place = 0;
        for (const Segment segment : last)
            for (const std::int32_t end = firstVoxelFrom(segment.end()); place < end; ++place)
                ends_.push_back({place, Segment(lineEnd, segment.property())});
    }

    const VolumeSnapshot& volume_;
    bool newAlongU_;
    std::int32_t lineCount_; ///< number of old scanlines in a slice
    std::vector<End> ends_;
    std::vector<std::uint32_t> next_;
    RunPosition displacement_ = 0;
};

/// Old scanlines that are neighbours along the new axis form a slice; slices follow each other along the third axis.
std::vector<Slice> turnSlices(const VolumeSnapshot& volume, RunAxis axis, Progress& progress) {
    const int across = 3 - static_cast<int>(volume.grid().axis()) - static_cast<int>(axis);
    std::vector<Slice> slices(static_cast<std::size_t>(volume.grid().count()[across]));
    ParallelProgress shared(progress, slices.size());
    parallelIntervals(std::size_t{0}, slices.size(), 8, [&](std::size_t from, std::size_t to) {
        SliceTurning turning(volume, axis);
        for (std::size_t i = from; i < to && !progress.cancelled(); ++i)
            turning.turn(static_cast<std::int32_t>(i), slices[i]);
        shared.add(to - from);
    });
    return slices;
}

Result<RunVolume> assembleSlices(const Grid& grid, const VolumeSnapshot& volume, const std::vector<Slice>& slices) {
    const bool slicesAlongV = grid.axisOfU() == volume.grid().axisOfRuns(); // otherwise along u
    return assembleBricks(grid, volume.properties(), [&](std::int32_t row, BrickSink& sink) {
        BrickLines lines(grid.lineEnd());
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            lines.clear();
            for (int line = 0; line < linesPerBrick; ++line) {
                const LineIndex index{low.u + line % brickSide, low.v + line / brickSide};
                if (grid.contains(index)) {
                    const Slice& slice = slices[static_cast<std::size_t>(slicesAlongV ? index.v : index.u)];
                    const auto place = static_cast<std::size_t>(slicesAlongV ? index.u : index.v);
                    lines.append(std::span(slice.segments)
                                     .subspan(slice.firsts[place], slice.firsts[place + 1] - slice.firsts[place]));
                }
                lines.endLine();
            }
            sink.put(low, lines);
        }
    });
}

Result<RunVolume> copyOf(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    return assemble(grid, volume.properties(), [&](LineIndex line, std::vector<Segment>& segments) {
        segments.assign(volume.line(line).begin(), volume.line(line).end());
    });
}

} // namespace

Result<TurnedVolume> turned(const VolumeSnapshot& volume, RunAxis axis, Progress& progress) {
    try {
        const Result<Grid> grid = Grid::make(volume.grid().low(), volume.grid().edge(), volume.grid().count(), axis);
        if (!grid) return grid.error();
        TurnLoss loss;
        const bool same = axis == volume.grid().axis();
        const std::vector<Slice> slices = same ? std::vector<Slice>() : turnSlices(volume, axis, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "turning", {}, {}};
        Result<RunVolume> result = same ? copyOf(volume) : assembleSlices(*grid, volume, slices);
        if (!result) return result.error();
        RunPosition greatest = 0;
        for (const Slice& slice : slices) greatest = std::max(greatest, slice.greatestDisplacement);
        loss.greatestDisplacement = static_cast<double>(greatest) / unitsPerVoxel;
        const RunAmounts before = volume.amounts();
        for (int i = 0; i < volume.properties().size(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            loss.changed.push_back(
                (static_cast<double>(result->amounts().units[at]) - static_cast<double>(before.units[at])) *
                grid->unitVolume());
        }
        return TurnedVolume{*std::move(result), std::move(loss)};
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "turning", {}, {}};
    }
}

} // namespace burin
