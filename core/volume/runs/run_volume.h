// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/volume/runs/grid.h"
#include "core/volume/runs/property_list.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// Part of a scanline with one property, from the end of the previous segment (0 for the first) to `end`. The segments
/// of a line cover it without gaps, air included; neighbours differ in property.
class Segment {
public:
    Segment() = default;
    /// @param end  run units from the line's start, below 2^24
    Segment(RunPosition end, PropertyIndex property) noexcept : packed_((end << 8) | property) {}
    RunPosition end() const noexcept { return packed_ >> 8; }
    PropertyIndex property() const noexcept { return static_cast<PropertyIndex>(packed_ & 0xff); }
    friend bool operator==(Segment, Segment) = default;

private:
    std::uint32_t packed_ = 0; ///< 16.8 bits of position, 8 of property
};

/// A run of the paper: homogeneous voxels first … last (inclusive, from 0) of one scanline.
struct Run {
    std::int32_t first = 0, last = 0;
    PropertyIndex property = airProperty;
    friend bool operator==(const Run&, const Run&) = default;
};

/// Exact lengths of material by property, in run units (1/256 voxel of one scanline).
struct RunAmounts {
    std::array<std::uint64_t, 256> units{};
    friend bool operator==(const RunAmounts&, const RunAmounts&) = default;
};

/// The intervals to remove from a brick of 8 × 8 scanlines, with from < to and within the line. Line i lies at u = i %
/// 8, v = i / 8 of the brick. Does not own the data.
struct BrickSpans {
    std::uint64_t lines = 0; ///< bit i: line i has an interval
    std::span<const RunPosition, 64> from, to;
};

/// Reserved memory for clearing one brick, set aside while the intervals to remove are still being gathered. Belongs to
/// the volume that allocated it.
class BrickRoom {
public:
    bool empty() const noexcept { return block_ == 0; }

private:
    friend class RunVolume;
    std::uint32_t block_ = 0;
};

class VolumeState;
class BrickSink;

enum class Removal : std::uint8_t { nothing, removed, outOfMemory };

/// Result of inserting or removing one voxel.
enum class [[nodiscard]] VoxelEdit : std::uint8_t{
    nothing,     ///< nothing to insert or to remove; the paper's failure flag of removing
    done,        ///< the volume changed
    outOfMemory, ///< the reserved memory is used up; the volume is unchanged
};

/// State of a volume at one moment. Shared and immutable: any thread may read it for any length of time, and the writer
/// never waits for it. Cheap to copy.
class VolumeSnapshot {
public:
    /// An empty snapshot, to be assigned to.
    VolumeSnapshot() noexcept = default;
    VolumeSnapshot(const VolumeSnapshot& other) noexcept;
    VolumeSnapshot(VolumeSnapshot&& other) noexcept;
    VolumeSnapshot& operator=(VolumeSnapshot other) noexcept;
    /// The last copy returns memory that no other snapshot uses to the volume.
    ~VolumeSnapshot();

    bool empty() const noexcept { return state_ == nullptr; }
    const Grid& grid() const noexcept;
    const PropertyList& properties() const noexcept;
    /// Segments of a scanline, in order; the view is valid as long as any snapshot of this state exists. `line` must
    /// lie in the grid.
    std::span<const Segment> line(LineIndex line) const noexcept;
    /// Segments of the brick of 8 × 8 scanlines that contains `line`: of its 64 lines, one after another, u counting
    /// fastest. Each line ends with the segment that ends at `Grid::lineEnd`. The content of lines beyond the grid is
    /// undefined.
    std::span<const Segment> brick(LineIndex line) const noexcept;
    /// Total of every property, recounted over all scanlines (parallel).
    RunAmounts amounts() const;
    /// Whether both are snapshots of the same volume.
    bool sameVolume(const VolumeSnapshot& other) const noexcept;
    /// Whether both share the brick of 8 × 8 scanlines that contains `line`, so that nothing in it changed in between
    /// (otherwise it may have changed). Both must show the same volume. Cost: two look-ups.
    bool sharesBrick(const VolumeSnapshot& other, LineIndex line) const noexcept;

private:
    friend class RunVolume;
    friend class VolumeAccess;
    explicit VolumeSnapshot(VolumeState* state) noexcept;
    VolumeState* state_ = nullptr;
};

/// Spatial run-length encoding of a workpiece: a position array of scanlines with runs, cross-referenced to a property
/// list (Chen & Yang 2004, section 2), with run ends to 1/256 voxel. Copy-on-write bricks of 8 × 8 scanlines.
/// Thread: one writer; snapshots may be read on any thread.
class RunVolume {
public:
    /// A grid filled with air.
    /// @param reservedBytes  memory for bricks that edits may use; allocated and touched here, so that no edit
    ///        allocates. 0: `defaultReserve`.
    /// Errors: outOfMemory (also if the system does not have that much available).
    static Result<RunVolume> make(const Grid& grid, PropertyList properties, std::size_t reservedBytes = 0);
    /// 48 bytes per scanline (measured: 25 for a new part of 3.5 runs per line, 36 after heavy milling), four tables of
    /// tiles, and, for lattices and small grids, 16 bytes per voxel up to 32 MiB.
    static std::size_t defaultReserve(const Grid& grid) noexcept;
    ~RunVolume();
    RunVolume(RunVolume&&) noexcept;
    RunVolume& operator=(RunVolume&&) noexcept;

    const Grid& grid() const noexcept;
    const PropertyList& properties() const noexcept;
    /// As VolumeSnapshot::line and brick, for the current state: the views are valid until the next edit of their
    /// brick. Writer's thread. Does not include pending writes of MaterialRemoval.
    std::span<const Segment> line(LineIndex line) const noexcept;
    std::span<const Segment> brick(LineIndex line) const noexcept;

    // ---- Scanlines. No allocation, no exception: suitable for the haptic loop.

    /// Prefetches the brick of a line, for a caller that will read it soon.
    void fetch(LineIndex line) const noexcept;

    /// Turns the machinable runs between `from` and `to` into air; protected runs stay.
    /// @param removed  the removed amounts are added to it
    /// outOfMemory: the line is unchanged and the reserved memory is used up; cutting has to stop.
    Removal removeSpan(LineIndex line, RunPosition from, RunPosition to, RunAmounts& removed) noexcept;
    /// Sets memory aside for clearing the brick of a line, so that writing the intervals gathered for it can't fail.
    /// False if the reserved memory is used up or no page of the table of tiles is spare; `room` must be empty and then
    /// stays empty.
    bool setAside(LineIndex line, BrickRoom& room) noexcept;
    /// Releases the memory that was set aside.
    void giveBack(BrickRoom& room) noexcept;
    /// Turns the machinable runs within `spans` into air, all lines of a brick at once; protected runs stay. `room` is
    /// consumed. Cost: one pass over the brick. False if the reserved memory is used up; the brick is then unchanged
    /// and `room` is kept. This happens only if the brick was edited in another way since its room was set aside, or
    /// without spare pages.
    /// @param line  any line of the brick
    bool clear(LineIndex line, const BrickSpans& spans, BrickRoom& room) noexcept;
    /// False if a snapshot taken now could leave `clear` without a page for its table. Callers that hold rooms must
    /// clear their bricks first.
    bool hasPagesToSpare() const noexcept;
    /// Sets the interval `from` … `to` to one property. False if the reserved memory is used up; the line is then
    /// unchanged.
    bool fillSpan(LineIndex line, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    /// Sets the interval `from` … `to` of every scanline with low.u <= u < high.u, low.v <= v < high.v to one property.
    /// Bricks that become equal share one block. False if the reserved memory is used up; some lines are then filled
    /// already.
    bool fillBlock(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    /// Replaces a line. `segments` must have rising ends and cover the line; empty ones and equal neighbours are
    /// merged. They must not be this volume's own (a snapshot's may be). False if the reserved memory is used up; the
    /// line is then unchanged.
    bool setLine(LineIndex line, std::span<const Segment> segments) noexcept;

    // ---- Whole bricks of 8 × 8 scanlines. Not for the haptic loop.

    /// Rewrites bricks on all cores; about ten times as fast as line by line.
    /// @param describe  gets the index of a row of bricks (from 0 along v) and hands over those of its bricks that
    ///        change (brick_lines.h). Called on several threads at once, and again for a row for which the memory was
    ///        insufficient at first. It may read only its own row of bricks, which is unchanged until it returns.
    /// False if the reserved memory is used up; some rows are then rewritten already, the others are unchanged. An
    /// exception from `describe` is passed on to the caller; some rows may then be rewritten.
    /// Bricks whose 64 lines are the same share one block.
    bool rewriteBricks(const std::function<void(std::int32_t row, BrickSink& sink)>& describe);

    // ---- The paper's operations on whole voxels (section 3), an exact special case. A voxel has the property at its
    // centre.

    /// Belonging: whether the voxel is part of the object, that is, not air.
    bool belongs(VoxelIndex voxel) const noexcept;
    /// Locating: the run that holds the voxel, or empty for air.
    std::optional<Run> locate(VoxelIndex voxel) const noexcept;
    /// Inserting. `nothing` if the voxel belongs already, whatever its property, lies outside the grid, or `property`
    /// is air.
    VoxelEdit insert(VoxelIndex voxel, PropertyIndex property) noexcept;
    /// Removing, whatever the property. `nothing` if the voxel lies outside the object.
    VoxelEdit remove(VoxelIndex voxel) noexcept;
    /// Runs of a scanline in the paper's whole-voxel view.
    std::vector<Run> runs(LineIndex line) const;

    // ---- Whole volume

    /// Total of every property, updated by each edit: O(1).
    const RunAmounts& amounts() const noexcept;
    /// Cost: less than a tick. Bricks are copied when they are next written. Allocates only if more than 64 snapshots
    /// are held at once. Writer's thread.
    VolumeSnapshot snapshot();
    /// Restores the state of a snapshot of this volume (undo). Needs no memory; later snapshots stay valid. Writer's
    /// thread, outside the haptic loop: it may wait for a reader that is releasing a snapshot.
    void restore(const VolumeSnapshot& snapshot);
    /// Memory that was reserved for bricks when the volume was made, and how much of it is in use, including blocks
    /// that only snapshots still use. Writer's thread.
    std::size_t reservedBytes() const noexcept;
    std::size_t usedBytes() const noexcept;

private:
    friend class VolumeSnapshot;
    friend class VolumeAccess;
    class Impl;
    explicit RunVolume(std::unique_ptr<Impl> impl);
    VoxelEdit fillVoxel(VoxelIndex voxel, PropertyIndex property) noexcept;
    std::unique_ptr<Impl> impl_;
};

} // namespace burin
