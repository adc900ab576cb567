// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where a scanline holds anything but air, in whole voxels: material begins at the first index, ends before the
/// second, begins again at the third, and so on. Rising, even in number.
using VoxelPlaces = std::span<const std::int32_t>;

/// Lists of voxel indices, one after the other; can be reused without allocating.
template <std::size_t count>
class PlaceLists {
public:
    void clear() noexcept { lists_ = end_ = 0; }
    VoxelPlaces operator[](std::size_t list) const noexcept {
        return {places_.data() + parts_[list].begin, parts_[list].size};
    }

    /// @param changes  positions in run units where material begins, ends, begins … ; rising, two may be equal
    void append(std::span<const RunPosition> changes) {
        std::int32_t* const first = room(changes.size());
        std::int32_t* end = first;
        for (const RunPosition position : changes) {
            const std::int32_t place = firstVoxelFrom(position);
            // A piece that holds no voxel's centre begins and ends at the same index: both vanish.
            if (end > first && end[-1] == place)
                --end;
            else
                *end++ = place;
        }
        close(static_cast<std::size_t>(end - first));
    }
    /// Appends the intersection of two lists. They must not belong to this object.
    void appendCommon(VoxelPlaces a, VoxelPlaces b) {
        std::int32_t* const first = room(a.size() + b.size());
        std::size_t i = 0, k = 0, found = 0;
        while (i < a.size() && k < b.size()) {
            const std::int32_t place = std::min(a[i], b[k]);
            i += a[i] == place ? 1U : 0U;
            k += b[k] == place ? 1U : 0U;
            first[found] = place;
            found += (i & k & 1) != (found & 1) ? 1U : 0U; // within both, or no longer
        }
        close(found);
    }

private:
    struct Part {
        std::size_t begin = 0, size = 0;
    };

    std::int32_t* room(std::size_t places) {
        if (places_.size() < end_ + places + 1) places_.resize(2 * (end_ + places + 1));
        return places_.data() + end_;
    }
    void close(std::size_t size) noexcept {
        parts_[lists_++] = {end_, size};
        end_ += size;
    }

    std::array<Part, count> parts_{};
    std::size_t lists_ = 0, end_ = 0;
    std::vector<std::int32_t> places_;
};

/// Where `count` scanlines change between air and anything else, in run units.
template <std::size_t count>
class LineChanges {
public:
    void clear() noexcept {
        lines_ = 0;
        begin_[0] = 0;
    }
    void appendEmpty(std::size_t lines) noexcept {
        for (; lines > 0; --lines, ++lines_) begin_[lines_ + 1] = begin_[lines_];
    }
    /// Reads the segments of whole lines that follow one another in memory; no branch depends on what they hold.
    void append(std::span<const Segment> segments, RunPosition lineEnd) {
        const std::size_t most = begin_[lines_] + 2 * segments.size() + 2;
        if (positions_.size() < most) positions_.resize(2 * most);
        RunPosition* const positions = positions_.data();
        std::size_t end = begin_[lines_], line = lines_;
        bool within = false;
        RunPosition start = 0;
        for (const Segment segment : segments) {
            const RunPosition position = segment.end();
            const bool material = segment.property() != airProperty, last = position == lineEnd;
            positions[end] = start;
            end += material != within ? 1U : 0U;
            positions[end] = position;
            end += last && material ? 1U : 0U;
            within = material && !last;
            start = last ? 0 : position;
            begin_[line + 1] = static_cast<std::uint32_t>(end);
            line += last ? 1U : 0U;
        }
        lines_ = line;
    }
    std::size_t size() const noexcept { return lines_; }
    std::span<const RunPosition> operator[](std::size_t line) const noexcept {
        return {positions_.data() + begin_[line], begin_[line + 1] - begin_[line]};
    }

private:
    std::size_t lines_ = 0;
    std::array<std::uint32_t, count + 2> begin_{}; ///< one more, which reading the last line may touch
    std::vector<RunPosition> positions_ = std::vector<RunPosition>(2);
};

} // namespace burin
