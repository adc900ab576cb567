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

/// Part of a scanline with one property: from the end of the segment before it (0 for the first) to `end`. The segments
/// of a line cover it without gaps, air included; neighbours differ in property.
class Segment {
public:
    Segment() = default;
    /// @param end run units from the line's start, below 2^24
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

/// Lengths of material by property, in run units (1/256 voxel of one scanline): exact.
struct RunAmounts {
    std::array<std::uint64_t, 256> units{};
    friend bool operator==(const RunAmounts&, const RunAmounts&) = default;
};

/// What is to be removed from a brick of 8 × 8 scanlines: stretches with from < to that lie within the line. Line i
/// lies at u = i % 8, v = i / 8 of the brick. Views of what somebody else owns.
struct BrickSpans {
    std::uint64_t lines = 0; ///< bit i: line i has a stretch
    std::span<const RunPosition, 64> from, to;
};

/// Reserved memory that clearing one brick may need, set aside while what is to be removed is still being gathered.
/// It belongs to the volume that gave it.
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

/// How inserting or removing one voxel ended.
enum class [[nodiscard]] VoxelEdit : std::uint8_t{
    nothing,     ///< there was nothing to insert or to remove; the paper's failure flag of removing
    done,        ///< the volume changed
    outOfMemory, ///< the reserved memory is used up; the volume is unchanged
};

/// What a volume held at one moment. Shared and immutable: any thread may read it as long as it likes; the writer never
/// waits for it. Copying is cheap.
class VolumeSnapshot {
public:
    /// Shows nothing; only to be assigned to.
    VolumeSnapshot() noexcept = default;
    VolumeSnapshot(const VolumeSnapshot& other) noexcept;
    VolumeSnapshot(VolumeSnapshot&& other) noexcept;
    VolumeSnapshot& operator=(VolumeSnapshot other) noexcept;
    /// The last one to go gives the memory that it alone held back to the volume.
    ~VolumeSnapshot();

    bool empty() const noexcept { return state_ == nullptr; }
    const Grid& grid() const noexcept;
    const PropertyList& properties() const noexcept;
    /// Segments of a scanline, in order; the view lives as long as a snapshot of this moment. `line` must lie in the
    /// grid.
    std::span<const Segment> line(LineIndex line) const noexcept;
    /// Segments of the brick of 8 × 8 scanlines around `line`: of its 64 lines, one after another, u counting fastest.
    /// Each line ends with the segment that ends at `Grid::lineEnd`. What lines of it beyond the grid say means
    /// nothing.
    std::span<const Segment> brick(LineIndex line) const noexcept;
    /// Total of every property, recounted over all scanlines (parallel).
    RunAmounts amounts() const;
    /// Whether both show moments of one and the same volume.
    bool sameVolume(const VolumeSnapshot& other) const noexcept;
    /// Whether the brick of 8 × 8 scanlines around `line` is one and the same in both: nothing in it changed in between
    /// (otherwise it may have). Both must show the same volume. Cost: two look-ups.
    bool sharesBrick(const VolumeSnapshot& other, LineIndex line) const noexcept;

private:
    friend class RunVolume;
    friend class VolumeAccess;
    explicit VolumeSnapshot(VolumeState* state) noexcept;
    VolumeState* state_ = nullptr;
};

/// Spatial run-length encoding of a workpiece: a position array of scanlines with runs, cross-referenced to a property
/// list (Chen & Yang 2004, section 2), run ends to 1/256 voxel. Copy-on-write bricks of 8 × 8 scanlines.
/// Thread: one writer; snapshots are read anywhere.
class RunVolume {
public:
    /// A grid filled with air.
    /// @param reservedBytes memory for bricks that editing may use up; allocated and touched here, so that no edit
    ///        allocates. 0: `defaultReserve`.
    /// Errors: outOfMemory (also when the system has not that much available).
    static Result<RunVolume> make(const Grid& grid, PropertyList properties, std::size_t reservedBytes = 0);
    /// 48 bytes a scanline (measured: 25 for a new part of 3.5 runs a line, 36 after heavy milling), four tables of
    /// tiles, and, for lattices and small grids, 16 bytes a voxel up to 32 MiB.
    static std::size_t defaultReserve(const Grid& grid) noexcept;
    ~RunVolume();
    RunVolume(RunVolume&&) noexcept;
    RunVolume& operator=(RunVolume&&) noexcept;

    const Grid& grid() const noexcept;
    const PropertyList& properties() const noexcept;
    /// As VolumeSnapshot::line and brick, of what stands now: the views end with the next edit of their brick. Writer's
    /// thread. What MaterialRemoval has cut and not written yet is still there.
    std::span<const Segment> line(LineIndex line) const noexcept;
    std::span<const Segment> brick(LineIndex line) const noexcept;

    // ---- Scanlines. No allocation, no exception: fit for the haptic loop.

    /// Fetches what is shown of the brick of a line from memory, for whoever is going to read it soon.
    void fetch(LineIndex line) const noexcept;

    /// Turns the machinable runs between `from` and `to` to air; protected runs stay.
    /// @param removed what was taken is added to it.
    /// outOfMemory: the line is unchanged and the reserved memory is used up; cutting has to stop.
    Removal removeSpan(LineIndex line, RunPosition from, RunPosition to, RunAmounts& removed) noexcept;
    /// Sets memory aside to clear the brick of a line, so that what is gathered for it can't fail to be written. False:
    /// out of reserved memory, or no page of the table of tiles to spare; `room` must be empty and stays so.
    bool setAside(LineIndex line, BrickRoom& room) noexcept;
    /// Gives back what was set aside.
    void giveBack(BrickRoom& room) noexcept;
    /// Turns the machinable runs within `spans` to air, all lines of a brick at once; protected runs stay. `room` is
    /// used up. Cost: one pass over the brick. False: out of reserved memory, the brick unchanged, `room` kept. That
    /// can only be when the brick was edited otherwise since its room was set aside, or without pages to spare.
    /// @param line any of the brick
    bool clear(LineIndex line, const BrickSpans& spans, BrickRoom& room) noexcept;
    /// False: a snapshot that is taken now could leave `clear` without a page of its table. Whoever holds rooms clears
    /// the bricks before.
    bool hasPagesToSpare() const noexcept;
    /// Gives the stretch `from` … `to` one property, whatever was there. False: out of reserved memory, line unchanged.
    bool fillSpan(LineIndex line, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    /// Gives the stretch `from` … `to` of every scanline with low.u <= u < high.u, low.v <= v < high.v one property.
    /// Bricks that become equal share one block. False: out of reserved memory; some lines are filled already.
    bool fillBlock(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    /// Replaces a line. `segments` must rise and cover it; empty ones and equal neighbours are merged. They must not be
    /// this volume's own (a snapshot's may be). False: out of reserved memory, line unchanged.
    bool setLine(LineIndex line, std::span<const Segment> segments) noexcept;

    // ---- Bricks of 8 × 8 scanlines, whole. Not for the haptic loop.

    /// Rewrites bricks on all cores; about ten times as fast as line by line.
    /// @param describe gets a row of bricks (from 0 along v) and hands over those of them that change (brick_lines.h).
    ///        Called on several threads at once, and again for a row that the memory did not suffice for at first. It
    ///        may read its own row of bricks only, which stands unchanged until it returns.
    /// False: out of reserved memory; some rows are rewritten already, the others unchanged. An exception of
    /// `describe` goes on to the caller; nothing is rewritten then or some rows are.
    /// Bricks whose 64 lines are the same share one block.
    bool rewriteBricks(const std::function<void(std::int32_t row, BrickSink& sink)>& describe);

    // ---- The paper's operations on whole voxels (section 3), an exact special case. A voxel belongs to the property
    // that its centre lies in.

    /// Belonging: is the voxel part of the object, that is, not air?
    bool belongs(VoxelIndex voxel) const noexcept;
    /// Locating: the run that holds the voxel, nothing for air.
    std::optional<Run> locate(VoxelIndex voxel) const noexcept;
    /// Inserting. Nothing: the voxel belongs already, whatever its property, lies outside the grid, or is to be air.
    VoxelEdit insert(VoxelIndex voxel, PropertyIndex property) noexcept;
    /// Removing, whatever the property. Nothing: the voxel lies outside the object.
    VoxelEdit remove(VoxelIndex voxel) noexcept;
    /// Runs of a scanline in the paper's whole-voxel view.
    std::vector<Run> runs(LineIndex line) const;

    // ---- Whole volume

    /// Total of every property, kept up to date with each edit: O(1).
    const RunAmounts& amounts() const noexcept;
    /// Cost: below a tick. Bricks are copied when they are next written. Allocates only when more than 64 snapshots
    /// are held at once. Writer's thread.
    VolumeSnapshot snapshot();
    /// Puts back what a snapshot of this volume held (undo). Needs no memory; snapshots taken since stay as they are.
    /// Writer's thread, outside the haptic loop: it may wait for a reader that is just letting a snapshot go.
    void restore(const VolumeSnapshot& snapshot);
    /// Memory that was set aside for bricks when the volume was made, and how much of it holds any: also blocks that
    /// only snapshots still show. Writer's thread.
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
