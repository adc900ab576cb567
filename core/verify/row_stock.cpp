// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/row_stock.h"

#include "core/cutting/line_frame.h"

#include <algorithm>

namespace burin {

namespace {

void count(LineIndex line, std::int32_t from, std::int32_t to, UnitSum& sum) noexcept {
    const auto units = static_cast<std::uint64_t>(to - from);
    sum.units += units;
    sum.momentU += units * static_cast<std::uint64_t>(line.u);
    sum.momentV += units * static_cast<std::uint64_t>(line.v);
    sum.along += units * static_cast<std::uint64_t>(from + to);
}

} // namespace

glm::dvec3 UnitSum::centroid(const Grid& grid) const noexcept {
    const auto all = static_cast<double>(units);
    const glm::dvec3 low = inLineFrame(grid, grid.low());
    const glm::dvec3 voxels(static_cast<double>(momentU) / all + 0.5, static_cast<double>(momentV) / all + 0.5,
                            0.5 * static_cast<double>(along) / all / unitsPerVoxel);
    return inSetupFrame(grid, low + grid.edge() * voxels);
}

RowStock::RowStock(const RunVolume& volume, std::int32_t row)
    : volume_(volume)
    , firstV_(row * brickSide)
    , countV_(std::min(brickSide, volume.grid().lineCountV() - firstV_))
    , bricks_((volume.grid().lineCountU() + brickSide - 1) / brickSide)
    , width_(static_cast<std::size_t>(bricks_) * brickSide)
    , top_(width_ * brickSide)
    , base_(width_ * brickSide)
    , below_(width_ * brickSide)
    , brickTop_(static_cast<std::size_t>(bricks_))
    , protectedTop_(static_cast<std::size_t>(bricks_))
    , cut_(static_cast<std::size_t>(bricks_)) {
    for (LineIndex line{0, firstV_}; line.v < firstV_ + countV_; ++line.v)
        for (line.u = 0; line.u < volume.grid().lineCountU(); ++line.u)
            read(line, protectedTop_[static_cast<std::size_t>(line.u / brickSide)]);
    for (std::int32_t brick = 0; brick < bricks_; ++brick) settle(brick);
}

void RowStock::read(LineIndex line, std::int32_t& brickProtected) {
    const PropertyList& properties = volume_.properties();
    const std::size_t at = lineAt(line);
    std::int32_t start = 0;
    for (const Segment segment : volume_.line(line)) {
        const auto end = static_cast<std::int32_t>(segment.end());
        if (segment.property() != airProperty) {
            if (properties.isProtected(segment.property())) {
                brickProtected = std::max(brickProtected, end);
            } else if (top_[at] == start && start > 0) {
                top_[at] = end; // another material on top of the previous one
            } else {
                if (top_[at] > 0) below_[at].push_back({base_[at], top_[at]});
                base_[at] = start;
                top_[at] = end;
            }
        }
        start = end;
    }
}

std::int32_t RowStock::reach() const noexcept {
    std::int32_t highest = 0;
    for (std::int32_t brick = 0; brick < bricks_; ++brick) highest = std::max(highest, brickReach(brick));
    return highest;
}

void RowStock::popTop(std::size_t at) {
    if (below_[at].empty()) {
        top_[at] = base_[at] = 0;
        return;
    }
    base_[at] = below_[at].back().from;
    top_[at] = below_[at].back().to;
    below_[at].pop_back();
}

void RowStock::cut(LineIndex line, RunPosition from, RunPosition to, UnitSum& removed) {
    const std::size_t at = lineAt(line);
    const auto low = static_cast<std::int32_t>(from), high = static_cast<std::int32_t>(to);
    const std::uint64_t before = removed.units;
    while (top_[at] > low && high >= top_[at]) { // from the top, which is by far the most frequent case
        const std::int32_t begin = std::max(low, base_[at]);
        count(line, begin, top_[at], removed);
        if (begin > base_[at])
            top_[at] = begin;
        else
            popTop(at);
    }
    if (top_[at] > low) { // undercut: something remains above
        if (high > base_[at]) {
            const std::int32_t begin = std::max(low, base_[at]);
            count(line, begin, high, removed);
            if (begin > base_[at]) below_[at].push_back({base_[at], begin});
            base_[at] = high;
        }
        if (!below_[at].empty()) cutBelow(below_[at], low, high, line, removed);
    }
    if (removed.units > before) cut_[static_cast<std::size_t>(line.u / brickSide)] = true;
}

void RowStock::cutBelow(std::vector<Interval>& intervals, std::int32_t from, std::int32_t to, LineIndex line,
                        UnitSum& removed) {
    for (std::size_t i = intervals.size(); i-- > 0 && intervals[i].to > from;) {
        Interval& interval = intervals[i];
        if (interval.from >= to) continue;
        const Interval taken{std::max(interval.from, from), std::min(interval.to, to)};
        count(line, taken.from, taken.to, removed);
        const Interval under{interval.from, taken.from}, over{taken.to, interval.to};
        const bool keepsUnder = under.from < under.to, keepsOver = over.from < over.to;
        const auto place = intervals.begin() + static_cast<std::ptrdiff_t>(i);
        if (keepsUnder && keepsOver) {
            interval = over;
            intervals.insert(place, under);
        } else if (keepsUnder || keepsOver) {
            interval = keepsUnder ? under : over;
        } else {
            intervals.erase(place);
        }
    }
}

void RowStock::settle(std::int32_t brick) noexcept {
    std::int32_t highest = 0;
    for (std::int32_t v = 0; v < countV_; ++v) {
        const std::int32_t* const lines = tops(firstV_ + v) + static_cast<std::ptrdiff_t>(brick) * brickSide;
        for (std::int32_t u = 0; u < brickSide; ++u) highest = std::max(highest, lines[u]);
    }
    brickTop_[static_cast<std::size_t>(brick)] = highest;
}

std::uint64_t RowStock::overlap(LineIndex line, RunPosition from, RunPosition to, UnitSum& sum) const {
    const auto low = static_cast<std::int32_t>(from), high = static_cast<std::int32_t>(to);
    const std::uint64_t before = sum.units;
    const auto add = [&](std::int32_t start, std::int32_t end) {
        start = std::max(start, low);
        end = std::min(end, high);
        if (start < end) count(line, start, end, sum);
    };
    forEachInterval(lineAt(line), add);
    std::int32_t start = 0;
    for (const Segment segment : volume_.line(line)) {
        const auto end = static_cast<std::int32_t>(segment.end());
        if (segment.property() != airProperty && volume_.properties().isProtected(segment.property())) add(start, end);
        start = end;
    }
    return sum.units - before;
}

void RowStock::brick(std::int32_t brick, BrickLines& lines) const {
    const Grid& grid = volume_.grid();
    lines.clear();
    for (std::int32_t v = firstV_; v < firstV_ + brickSide; ++v)
        for (std::int32_t u = brick * brickSide; u < (brick + 1) * brickSide; ++u) {
            if (!grid.contains(LineIndex{u, v})) {
                lines.endLine();
                continue;
            }
            RunPosition start = 0;
            for (const Segment segment : volume_.line({u, v})) {
                const PropertyIndex property = segment.property();
                if (property != airProperty && !volume_.properties().isProtected(property))
                    forEachInterval(lineAt({u, v}), [&](std::int32_t from, std::int32_t to) {
                        const RunPosition low = std::max(start, static_cast<RunPosition>(from));
                        const RunPosition high = std::min(segment.end(), static_cast<RunPosition>(to));
                        if (low >= high) return;
                        lines.append(low, airProperty);
                        lines.append(high, property);
                    });
                const bool stays = property == airProperty || volume_.properties().isProtected(property);
                lines.append(segment.end(), stays ? property : airProperty);
                start = segment.end();
            }
            lines.endLine();
        }
}

} // namespace burin
