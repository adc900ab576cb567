// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <vector>

namespace burin {

/// Number of scanlines along u and along v that share one block of memory.
inline constexpr std::int32_t brickSide = 8;
inline constexpr int linesPerBrick = brickSide * brickSide;

/// The new content of a whole brick, line after line; u counts fastest. Can be reused without allocating. Segments
/// always keep the rules of a volume: none is empty, none reaches beyond the line, and neighbours differ in property.
class BrickLines {
public:
    explicit BrickLines(RunPosition lineEnd) noexcept : lineEnd_(lineEnd) {}

    void clear() noexcept {
        count_ = lineBegin_ = 0;
        lines_ = 0;
    }
    /// Gives the current line `property` from its current end to `end`.
    void append(RunPosition end, PropertyIndex property) {
        if (end > lineEnd_) end = lineEnd_;
        if (count_ > lineBegin_) {
            Segment& last = segments_[count_ - 1];
            if (end <= last.end()) return;
            if (last.property() == property) {
                last = Segment(end, property);
                return;
            }
        } else if (end == 0) {
            return;
        }
        if (count_ == segments_.size()) segments_.resize(2 * count_ + linesPerBrick);
        segments_[count_++] = Segment(end, property);
    }
    void append(std::span<const Segment> segments) {
        for (const Segment segment : segments) append(segment.end(), segment.property());
    }
    /// Appends a whole line, the current one being empty: `property` between `from` and `to`, `around` elsewhere.
    void appendLine(RunPosition from, RunPosition to, PropertyIndex property, PropertyIndex around) {
        assert(count_ == lineBegin_ && lines_ < linesPerBrick && from <= to && to <= lineEnd_);
        if (segments_.size() < count_ + 3) segments_.resize(2 * std::size_t{count_} + linesPerBrick);
        if (property == around || from == to) {
            segments_[count_++] = Segment(lineEnd_, around);
        } else {
            segments_[count_] = Segment(from, around);
            count_ += from > 0 ? 1U : 0U;
            segments_[count_++] = Segment(to, property);
            segments_[count_] = Segment(lineEnd_, around);
            count_ += to < lineEnd_ ? 1U : 0U;
        }
        lineBegin_ = count_;
        offsets_[static_cast<std::size_t>(++lines_)] = count_;
    }
    /// Ends the current line, filling its remainder with air, and goes on to the next.
    void endLine() {
        assert(lines_ < linesPerBrick);
        append(lineEnd_, airProperty);
        lineBegin_ = count_;
        offsets_[static_cast<std::size_t>(++lines_)] = count_;
    }
    /// Makes every line of the brick a copy of the first, which must be the only one so far.
    void repeatFirst() {
        assert(lines_ == 1);
        const std::uint32_t each = count_;
        if (segments_.size() < std::size_t{each} * linesPerBrick) segments_.resize(std::size_t{each} * linesPerBrick);
        while (lines_ < linesPerBrick) {
            std::copy_n(segments_.begin(), each, segments_.begin() + count_);
            count_ += each;
            offsets_[static_cast<std::size_t>(++lines_)] = count_;
        }

        lineBegin_ = count_;
    }

    /// For algorithms that work on a whole brick at once. `write(Segment* segments, std::uint32_t* offsets)` gets room
    /// for `atMost` segments and for 65 offsets (where each line begins, and the end), fills them and has to keep the
    /// rules itself.
    template <class Write>
    void writeAll(std::size_t atMost, Write&& write) {
        if (segments_.size() < atMost) segments_.resize(atMost);
        write(segments_.data(), offsets_.data());
        count_ = lineBegin_ = offsets_[linesPerBrick];
        lines_ = linesPerBrick;
    }

    /// Whether all lines of the brick are the same.
    bool uniform() const noexcept {
        if (count_ % linesPerBrick != 0) return false;
        const std::uint32_t each = count_ / linesPerBrick;
        for (std::uint32_t i = each; i < count_; ++i) // lines all reach the same end, so a period is a line
            if (segments_[i] != segments_[i - each]) return false;
        return true;
    }
    bool complete() const noexcept { return lines_ == linesPerBrick; }
    std::uint32_t segmentCount() const noexcept { return count_; }
    /// Index of a line's first segment; for line 64, the end of the last line.
    std::uint32_t offset(int line) const noexcept { return offsets_[static_cast<std::size_t>(line)]; }
    std::span<const std::uint32_t, linesPerBrick + 1> offsets() const noexcept { return offsets_; }
    std::span<const Segment> segments() const noexcept { return std::span(segments_).first(count_); }
    std::span<const Segment> line(int line) const noexcept {
        return segments().subspan(offset(line), offset(line + 1) - offset(line));
    }

private:
    RunPosition lineEnd_;
    std::uint32_t count_ = 0, lineBegin_ = 0;
    int lines_ = 0;
    std::array<std::uint32_t, linesPerBrick + 1> offsets_{};
    std::vector<Segment> segments_; ///< only the first `count_` are valid
};

/// Receives new bricks for a row of them (RunVolume::rewriteBricks).
class BrickSink {
public:
    /// Sets scanlines low.u … low.u + 7, low.v … low.v + 7 to `lines`, which is copied. Scanlines beyond the grid are
    /// ignored. Called at most once for each brick.
    virtual void put(LineIndex low, const BrickLines& lines) = 0;

protected:
    ~BrickSink() = default;
};

} // namespace burin
