// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cut_cache.h"

#include "core/cutting/cut_cache_kernels.h"
#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burin {

namespace {

static_assert(lanes == brickSide); // a register of eight holds a row of a brick's lines

constexpr std::int32_t far = 1 << 29; ///< beyond any run position; the sum of two of them and a run position does not
                                      ///< overflow

bool isMachinable(const PropertyList& properties, PropertyIndex property) noexcept {
    return property != airProperty && !properties.isProtected(property);
}

/// The lines of a brick, one after another: their gaps around one position.
class LinesAbout {
public:
    LinesAbout(const RunVolume& workpiece, LineIndex corner, std::int32_t place) noexcept
        : properties_(workpiece.properties())
        , next_(workpiece.brick(corner).data())
        , lineEnd_(static_cast<std::int32_t>(workpiece.grid().lineEnd()))
        , place_(place) {}

    CutCache::LineGap next() noexcept {
        CutCache::LineGap gap{0, lineEnd_, 0, 0};
        std::int32_t start = 0;
        for (bool passed = false; start != lineEnd_; ++next_) {
            const auto end = static_cast<std::int32_t>(next_->end());
            const PropertyIndex property = next_->property();
            if (!passed && isMachinable(properties_, property)) {
                if (start < place_) {
                    gap.low = std::min(end, place_);
                    gap.left = static_cast<std::uint32_t>(start) << 8 | property;
                }
                if (end > place_) {
                    gap.high = std::max(start, place_);
                    gap.right = static_cast<std::uint32_t>(end) << 8 | property;
                    passed = true;
                }
            }
            start = end;
        }
        return gap;
    }

private:
    const PropertyList& properties_;
    const Segment* next_;
    std::int32_t lineEnd_, place_;
};

/// Returns the number of bricks along each side of a cache.
std::size_t sideOf(const Grid& grid, double reach) noexcept {
    // The largest number of bricks that an interval of lines may overlap, wherever it begins.
    const auto bricks = (static_cast<std::uint32_t>(std::ceil(std::clamp(2.0 * reach, 0.0, 65536.0))) + 15) / 8;
    // No more than the grid has, plus the brick beyond its end that the lines of a group may reach.
    const auto most = static_cast<std::uint32_t>(std::max(grid.lineCountU(), grid.lineCountV())) / 8 + 2;
    return std::bit_ceil(std::min(bricks, most));
}

/// A sum over lanes.
double sumOf(const CutCache::Sums::Lanes<float>& values) noexcept {
    double sums[4]{}; // independent partial sums
    for (std::size_t i = 0; i < values.size(); ++i) sums[i % 4] += static_cast<double>(values[i]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

CutCache::CutCache(const Grid& grid, double reach)
    : lineCountU_(grid.lineCountU())
    , lineCountV_(grid.lineCountV())
    , side_(sideOf(grid, reach))
    , mask_(static_cast<std::int32_t>(side_) - 1)
    , gaps_(side_ * side_)
    , bricks_(gaps_.size())
    , queue_(bricks_.size()) {
    mostRows_ = std::max(1, static_cast<int>((std::int64_t{1} << 31) - 1) /
                                static_cast<int>(std::min<std::int64_t>(
                                    static_cast<std::int64_t>(side_) * grid.lineEnd(), (std::int64_t{1} << 31) - 1)));
    open_.resize(side_ * SpanRows::rowsAtOnce);
}

/// Assigns a brick's memory to other lines, which are not known yet.
void CutCache::claim(Brick& brick, std::int32_t u, std::int32_t v) noexcept {
    brick.known = false;
    brick.u = u;
    brick.v = v;
    Gaps& gaps = gapsOf(brick);
    gaps.low.fill(far);
    gaps.high.fill(-far);
    if ((u + 1) * brickSide <= lineCountU_ && (v + 1) * brickSide <= lineCountV_) return;
    // For a line that the grid does not have, no span can reach beyond the gap.
    for (std::int32_t line = 0; line < brickSide * brickSide; ++line)
        if (u * brickSide + line % brickSide >= lineCountU_ || v * brickSide + line / brickSide >= lineCountV_)
            gaps.set(static_cast<std::size_t>(line), {-far, far, 0, 0});
}

std::optional<int> CutCache::cover(RunVolume& workpiece, std::int32_t firstRow, std::int32_t lastRow,
                                   std::int32_t firstGroup, std::int32_t lastGroup) noexcept {
    const std::int32_t first = firstRow >> 3, last = lastRow >> 3;
    if (first >= coveredFirstRow_ && last <= coveredLastRow_ && firstGroup >= coveredFirstGroup_ &&
        lastGroup <= coveredLastGroup_)
        return 0;
    coveredLastRow_ = -1; // until this is complete
    int claimed = 0;
    for (std::int32_t v = first; v <= last; ++v)
        for (std::int32_t u = firstGroup; u <= lastGroup; ++u) {
            Brick& brick = bricks_[brickAt(u, v)];
            if (brick.u == u && brick.v == v) continue;
            if (brick.owing != 0 && !write(workpiece, brick)) return std::nullopt;
            if (queue_.holds(placeOf(brick))) queue_.remove(placeOf(brick));
            brick.ready = false;
            workpiece.giveBack(brick.room);
            claim(brick, u, v);
            ++claimed;
            if (u * brickSide < lineCountU_ && v * brickSide < lineCountV_)
                workpiece.fetch({u * brickSide, v * brickSide});
        }
    coveredFirstRow_ = first;
    coveredLastRow_ = last;
    coveredFirstGroup_ = firstGroup;
    coveredLastGroup_ = lastGroup;
    return claimed;
}

/// Prepares the first cut of a brick: reserves memory to write it, and adds it to the queue.
bool CutCache::expectCuts(RunVolume& workpiece, Brick& brick) noexcept {
    if (brick.room.empty() && !workpiece.setAside({brick.u * brickSide, brick.v * brickSide}, brick.room)) return false;
    if (!queue_.holds(placeOf(brick))) queue_.add(placeOf(brick));
    brick.ready = true;
    return true;
}

bool CutCache::write(RunVolume& workpiece, Brick& brick) noexcept {
    if (brick.owing == 0) return true;
    const Gaps& gaps = gapsOf(brick);
    const auto positions = [](const std::array<std::int32_t, 64>& ends) {
        // A gap with a pending write lies within its line.
        return std::span<const RunPosition, 64>(reinterpret_cast<const RunPosition*>(ends.data()), ends.size());
    };
    const BrickSpans spans{brick.owing, positions(gaps.low), positions(gaps.high)};
    if (!workpiece.clear({brick.u * brickSide, brick.v * brickSide}, spans, brick.room)) return false;
    brick.owing = 0;
    brick.ready = false; // its reserved room went into the volume
    return true;
}

/// Writes the first brick of the queue and removes it; the queue must not be empty.
bool CutCache::writeNext(RunVolume& workpiece) noexcept {
    const std::uint32_t place = *queue_.first();
    if (!write(workpiece, bricks_[place])) return false;
    bricks_[place].ready = false;
    queue_.remove(place);
    return true;
}

bool CutCache::writeDue(RunVolume& workpiece) noexcept {
    for (std::uint32_t pace = queue_.pace(); pace > 0 && !queue_.empty(); --pace)
        if (!writeNext(workpiece)) return false;
    queue_.nextTick();
    // Without a spare page, which may have been used by the writes just now, it is certain only before the next
    // snapshot that everything can be written.
    return workpiece.hasPagesToSpare() || writeAll(workpiece);
}

bool CutCache::writeAll(RunVolume& workpiece) noexcept {
    while (!queue_.empty())
        if (!writeNext(workpiece)) return false;
    for (Brick& brick : bricks_) workpiece.giveBack(brick.room);
    return true;
}

void CutCache::forget() noexcept {
    for (Brick& brick : bricks_) {
        brick.u = brick.v = -1;
        brick.owing = 0;
        brick.ready = brick.known = false;
        brick.room = {};
    }
    queue_.clear();
    coveredLastRow_ = -1;
}

int CutCache::take(RunVolume& workpiece, std::span<const RowSpans> rows, RemovedUnits& removed) noexcept {
    int read = 0;
    while (!rows.empty() && !removed.outOfMemory) {
        const auto now = rows.first(std::min(rows.size(), static_cast<std::size_t>(mostRows_ - sums_.rows)));
        read += takeSome(workpiece, now, removed);
        if (sums_.rows == mostRows_) collect(removed);
        rows = rows.subspan(now.size());
    }
    return read;
}

/// Returns the bricks that some rows of lines share.
CutCache::BrickRow CutCache::brickRow(std::span<const RowSpans> rows) noexcept {
    const std::int32_t v = rows.front().v >> 3;
    BrickRow all{&gaps_[brickAt(0, v)], &bricks_[brickAt(0, v)], static_cast<std::uint32_t>(mask_)};
    all.firstLine = v * brickSide;
    const RowSpans* first = rows.data();
    for (const RowSpans& row : rows) {
        const int line = row.v & 7;
        all.begins[line] = row.firstGroup;
        all.ends[line] = row.firstGroup + row.groups;
        all.end = std::max(all.end, all.ends[line]);
        if (row.firstGroup < first->firstGroup) first = &row;
    }
    all.first = first->firstGroup;
    all.spans = first->bricks;
    return all;
}

int CutCache::takeSome(RunVolume& workpiece, std::span<const RowSpans> spans, RemovedUnits& removed) noexcept {
    const BrickRow row = brickRow(spans);
    if (sums_.rows == 0) {
        const RowSpans& middle = spans[spans.size() / 2];
        sums_.originU = middle.firstGroup * brickSide;
        sums_.originV = middle.v;
        const std::int32_t low = middle.bricks[middle.groups / 2].low[middle.v & 7][0];
        sums_.alongOrigin = low < far ? 2 * low : 0;
    }
    sums_.rows += static_cast<int>(spans.size());
    kernels::Growth growth{open_.data(), 0, row.first};
    int read = 0;
    while (!kernels::growGaps(row, sums_, growth)) {
        Brick& brick = row.bricks[growth.brick & mask_];
        const BrickOfSpans& brickSpans = row.spans[growth.brick - row.first];
        if (const int cost = know(workpiece, brick, brickSpans, row.asked(growth.brick)); cost > 0) {
            read += cost; // then take the remaining spans
            continue;
        }
        if (!expectCuts(workpiece, brick)) {
            removed.outOfMemory = true;
            break;
        }
    }
    return read + takeOpen(workpiece, row, std::span(open_).first(growth.openCount), removed);
}

/// Reads all lines of a brick in the order in which they lie in memory, which is much faster than reading each when a
/// span first reaches it.
/// @param place position around which the gaps are taken: that of the first span that reaches the brick
void CutCache::learn(const RunVolume& workpiece, Brick& brick, std::int32_t place) noexcept {
    brick.known = true;
    const LineIndex corner{brick.u * brickSide, brick.v * brickSide};
    const int rows = std::min(brickSide, lineCountV_ - corner.v), columns = std::min(brickSide, lineCountU_ - corner.u);
    Gaps& gaps = gapsOf(brick);
    LinesAbout all(workpiece, corner, place);
    for (int row = 0; row < rows; ++row)
        for (int lane = 0; lane < brickSide; ++lane) {
            const LineGap found = all.next();
            if (lane < columns) gaps.set(static_cast<std::size_t>(row * brickSide + lane), found);
        }
}

/// Takes the spans of the lines for which the arithmetic was not sufficient.
int CutCache::takeOpen(RunVolume& workpiece, const BrickRow& row, std::span<const Open> open,
                       RemovedUnits& removed) noexcept {
    int read = 0;
    for (const Open& one : open) {
        Brick& brick = row.bricks[one.brick & mask_];
        const BrickOfSpans& spans = row.spans[one.brick - row.first];
        for (std::uint32_t left = one.lanesOf; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const LineIndex line{one.brick * brickSide + lane, row.firstLine + one.row};
            if (!widen(workpiece, line, brick, {spans.low[one.row][lane], spans.high[one.row][lane]}, removed)) {
                removed.outOfMemory = true;
                return read;
            }
            ++read;
        }
    }
    return read;
}

void CutCache::collect(RemovedUnits& removed) noexcept {
    if (sums_.rows == 0) return;
    for (std::size_t word = 0; word < sums_.used.size(); ++word)
        for (; sums_.used[word] != 0; sums_.used[word] &= sums_.used[word] - 1) {
            const std::size_t property = word * 64 + static_cast<std::size_t>(std::countr_zero(sums_.used[word]));
            std::uint64_t units = 0;
            for (const std::int32_t some : sums_.byProperty[property]) units += static_cast<std::uint64_t>(some);
            sums_.byProperty[property] = {};
            removed.byProperty[property] += units;
            removed.total += units;
        }
    const double units = sumOf(sums_.units);
    removed.momentU += sumOf(sums_.momentU) + units * sums_.originU;
    removed.momentV += sumOf(sums_.momentV) + units * sums_.originV;
    removed.momentAlong += 0.5 * (sumOf(sums_.momentAlong) + units * sums_.alongOrigin);
    sums_.units = sums_.momentU = sums_.momentV = sums_.momentAlong = {};
    sums_.rows = 0;
}

/// Examines the line from `around`, an interval in which nothing is left, to the end of `span` and on to the next
/// machinable segments. Within `around` the volume may still show removed material; material beyond it exists, and is
/// counted as taken up to the end of `span`.
CutCache::Found CutCache::lookAround(const RunVolume& workpiece, LineIndex line, Bounds around, Bounds span,
                                     RemovedUnits& removed) noexcept {
    const PropertyList& properties = workpiece.properties();
    const std::span<const Segment> segments = workpiece.line(line);
    Found found{{around.low, around.high, 0, 0}, 0};
    const auto take = [&](PropertyIndex property, std::int32_t from, std::int32_t to) {
        const std::int32_t units = std::max(to - from, 0);
        removed.byProperty[property] += static_cast<std::uint64_t>(units);
        removed.momentAlong += 0.5 * units * (static_cast<double>(to) + from);
        found.taken += static_cast<std::uint64_t>(units);
    };
    const Segment *const first = segments.data(), *const last = first + segments.size();
    const Segment* holdsHigh = first;
    while (holdsHigh != last && static_cast<std::int32_t>(holdsHigh->end()) <= around.high) ++holdsHigh;
    for (const Segment* segment = holdsHigh; segment != last; ++segment) {
        const auto end = static_cast<std::int32_t>(segment->end());
        if (const PropertyIndex property = segment->property(); isMachinable(properties, property)) {
            const std::int32_t reached = end > span.high ? std::max(found.high, span.high) : end;
            take(property, found.high, reached);
            found.high = reached;
            if (reached == end) continue;
            found.right = static_cast<std::uint32_t>(end) << 8 | property;
            break;
        }
        found.high = end;
    }
    for (const Segment* segment = holdsHigh == last ? last : holdsHigh + 1; segment != first;) {
        --segment;
        const std::int32_t start = segment == first ? 0 : static_cast<std::int32_t>(segment[-1].end());
        if (start >= found.low) continue;
        if (const PropertyIndex property = segment->property(); isMachinable(properties, property)) {
            const std::int32_t reached = start < span.low ? std::min(found.low, span.low) : start;
            take(property, reached, found.low);
            found.low = reached;
            if (reached == start) continue;
            found.left = static_cast<std::uint32_t>(start) << 8 | property;
            break;
        }
        found.low = start;
    }
    return found;
}

/// Takes a span that extends beyond the neighbours of its gap: across the border of two materials, or apart from the
/// gap.
bool CutCache::widen(RunVolume& workpiece, LineIndex line, Brick& brick, Bounds span, RemovedUnits& removed) noexcept {
    const LineGap gap = gapsOf(brick).at(bitOf(line));
    Bounds around{gap.low, gap.high};
    if (span.low > around.high || span.high < around.low) {
        if ((brick.owing >> bitOf(line) & 1) != 0 && !write(workpiece, brick)) return false;
        around = {span.low, span.low};
    }
    if (!brick.ready && !expectCuts(workpiece, brick)) return false;
    const Found found = lookAround(workpiece, line, around, span, removed);
    gapsOf(brick).set(bitOf(line), found);
    if (found.taken == 0) return true;
    removed.total += found.taken;
    removed.momentU += static_cast<double>(found.taken) * line.u;
    removed.momentV += static_cast<double>(found.taken) * line.v;
    brick.owing |= std::uint64_t{1} << bitOf(line);
    return true;
}

/// Reads the lines of a brick if some rows of it have a span and the lines are not known. @return the cost, in lines
int CutCache::know(const RunVolume& workpiece, Brick& brick, const BrickOfSpans& spans, std::uint32_t rows) noexcept {
    if (brick.known) return 0;
    for (; rows != 0; rows &= rows - 1) {
        const EightIntegers &low = spans.low[std::countr_zero(rows)], &high = spans.high[std::countr_zero(rows)];
        for (int lane = 0; lane < brickSide; ++lane)
            if (low[lane] < high[lane]) {
                learn(workpiece, brick, high[lane]);
                return brickInLines;
            }
    }
    return 0;
}

int CutCache::look(const RunVolume& workpiece, const RowSpans& row) noexcept {
    int read = 0;
    for (std::int32_t group = 0; group < row.groups; ++group)
        read +=
            know(workpiece, bricks_[brickAt(row.firstGroup + group, row.v >> 3)], row.bricks[group], 1U << (row.v & 7));
    return read;
}

} // namespace burin
