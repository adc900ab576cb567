// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_lines.h"

#include "core/volume/runs/volume_access.h"
#include "core/volume/surface/alike_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace burin {

namespace {

constexpr std::int16_t beyond = SurfaceLine::beyond;

std::int32_t endOf(const Segment& segment) {
    return static_cast<std::int32_t>(segment.end());
}
bool solidIn(const Segment& segment) {
    return segment.property() != airProperty;
}
/// Ordered by the end first.
std::uint32_t packed(Segment segment) {
    return std::bit_cast<std::uint32_t>(segment);
}

} // namespace

/// Reads the scanlines of one window, brick by brick.
class SurfaceLines::Reader {
public:
    Reader(SurfaceLines& lines, const VolumeSnapshot& workpiece, const SurfaceWindow& window)
        : state_(VolumeAccess::state(workpiece))
        , grid_(workpiece.grid())
        , window_(window)
        , level_(window.level)
        , origin_(window.firstNode * SurfaceLine::cell << level_)
        , low_(origin_ - (SurfaceLine::centre << level_))
        , high_(std::min(origin_ + ((window.nodes() * SurfaceLine::cell + SurfaceLine::centre) << level_),
                         static_cast<std::int32_t>(grid_.lineEnd()) + 1))
        , rounding_(origin_ - (1 << level_ >> 1))
        , packedLow_(low_ < 0 ? 0 : packed({static_cast<RunPosition>(low_), 255}))
        , packedHigh_(packed({static_cast<RunPosition>(high_), 0}))
        , lines_(lines)
        , seen_(lines.seen_.data()) {}

    void read() {
        const LineIndex low{window_.firstU << level_, window_.firstV << level_};
        const LineIndex high{low.u + (window_.columns << level_), low.v + (window_.rows << level_)};
        const LineIndex inside{std::max(low.u, 0), std::max(low.v, 0)};
        const LineIndex end{std::min(high.u, grid_.lineCountU()), std::min(high.v, grid_.lineCountV())};
        if (inside != low || end != high) addOutside();
        for (std::int32_t v = inside.v, nextV = 0; v < end.v; v = nextV) {
            nextV = std::min((v / tileSide + 1) * tileSide, end.v);
            for (std::int32_t u = inside.u, nextU = 0; u < end.u; u = nextU) {
                nextU = std::min((u / tileSide + 1) * tileSide, end.u);
                const Tile tile = state_.store->tile(VolumeAccess::tileAt(state_, u / tileSide, v / tileSide));
                addFrom(tile, {u, v}, {nextU, nextV});
            }
        }
        fillUp();
    }
    const SurfaceChanges& changes() const { return changes_; }

private:
    /// Lines of the window that are not read lie outside the grid.
    void addOutside() {
        std::ranges::fill(lines_.lines_, SurfaceLine{});
        std::ranges::fill(lines_.firstSegments_, nullptr);
        changes_.atBegin |= SurfaceChanges::bitOf(false);
        changes_.atEnd |= SurfaceChanges::bitOf(false);
    }
    /// Pads the rows so that lines can be processed in whole lanes.
    void fillUp() {
        const auto count = static_cast<std::ptrdiff_t>(window_.columns << level_),
                   step = static_cast<std::ptrdiff_t>(lines_.step_);
        for (auto row = lines_.lines_.begin(); row != lines_.lines_.end(); row += step)
            std::fill(row + count, row + step, row[count - 1]);
    }
    /// The lines low.u … high.u - 1, low.v … high.v - 1 of a brick.
    void addFrom(const Tile& tile, LineIndex low, LineIndex high) {
        last_.segments = tile.segments();
        TileOffsets offsets;
        tile.readOffsets(offsets);
        const LineIndex origin{window_.firstU << level_, window_.firstV << level_};
        const auto count = static_cast<std::size_t>(high.u - low.u);
        for (std::int32_t v = low.v;; ++v) {
            v += static_cast<std::int32_t>(addAlike(offsets, {low.u, v}, high));
            if (v >= high.v) return;
            const Further where{v - origin.v, low.u - origin.u, {}};
            const std::size_t at = placeOf(where);
            last_.offsets = offsets.data() + TileTable::lineInTile({low.u, v});
            addEach(last_, count, &lines_.lines_[at], &lines_.firstSegments_[at],
                    {where.row >> level_, where.column, {}});
        }
    }
    /// Index of a line, given by its row and its position among the scanlines that are read.
    std::size_t placeOf(const Further& where) const {
        return static_cast<std::size_t>(where.row) * lines_.step_ + static_cast<std::size_t>(where.column);
    }
    /// Reads the next rows of a brick, from a line on, up to one whose lines are not alike. @return number of rows read
    std::size_t addAlike(const TileOffsets& offsets, LineIndex low, LineIndex high) {
        const AlikeRows rows{last_.segments,
                             offsets.data() + TileTable::lineInTile(low),
                             static_cast<std::size_t>(high.u - low.u),
                             static_cast<std::size_t>(high.v - low.v),
                             packedLow_,
                             packedHigh_,
                             low_ < 0,
                             rounding_,
                             level_};
        const std::size_t at = placeOf({low.v - (window_.firstV << level_), low.u - (window_.firstU << level_), {}});
        return readAlikeRows(rows, last_.skipped, {&lines_.lines_[at], &lines_.firstSegments_[at], lines_.step_, seen_},
                             changes_);
    }
    /// State kept from line to line, because most lines are like the previous one.
    struct LastLine {
        const Segment* segments = nullptr;      ///< of the brick
        const std::uint32_t* offsets = nullptr; ///< of the lines of one row
        std::uint32_t skipped = 0;              ///< segments before the window
        unsigned properties = ~0U;              ///< of the two segments that it may see
        bool changes = false, solid = false;    ///< exactly one of them is air; the first is not
        SurfaceLine line;                       ///< if both are alike
    };
    /// Only few lines have more than one end within a window.
    void addEach(LastLine& last, std::size_t count, SurfaceLine* lines, const Segment** firstSegments, Further where) {
        const std::uint32_t low = packedLow_, high = packedHigh_;
        std::ptrdiff_t skipped = last.skipped;
        for (std::size_t i = 0; i < count; ++i) {
            const Segment *const begin = last.segments + last.offsets[i], *const end =
                                                                              last.segments + last.offsets[i + 1];
            const Segment* segment = begin + skipped;
            if (segment >= end || packed(*segment) <= low || (skipped > 0 && packed(segment[-1]) > low)) {
                for (segment = begin; packed(*segment) <= low;) ++segment;
                skipped = segment - begin;
            }
            firstSegments[i] = segment;
            const Segment* const next = packed(*segment) < high ? segment + 1 : segment;
            if ((low_ < 0 && solidIn(*segment)) || next == end || packed(*next) < high) {
                lines[i] = anyEnds(segment, end, {where.row, (where.column + static_cast<int>(i)) >> level_, {}});
                continue;
            }
            if (const unsigned both = segment->property() * 256U + next->property(); both != last.properties) {
                last.properties = both;
                last.solid = solidIn(*segment);
                last.changes = last.solid != solidIn(*next);
                last.line = uniformLine(last.solid);
                see(*segment, *next);
            }
            lines[i] = last.changes ? change(endOf(*segment), last.solid) : last.line;
        }
        last.skipped = static_cast<std::uint32_t>(skipped);
    }
    void see(Segment before, Segment behind) {
        seen_[before.property()] = seen_[behind.property()] = 1;
        changes_.atBegin |= SurfaceChanges::bitOf(solidIn(before));
        changes_.atEnd |= SurfaceChanges::bitOf(solidIn(behind));
    }
    /// @param segment  the first that ends within the window or behind it
    SurfaceLine anyEnds(const Segment* segment, const Segment* end, Further where) {
        bool solid = low_ >= 0 && solidIn(*segment), any = false;
        seen_[segment->property()] = 1;
        changes_.atBegin |= SurfaceChanges::bitOf(solid);
        SurfaceLine first;
        const auto turn = [&](std::int32_t position) {
            const SurfaceLine line = change(position, solid);
            if (any) {
                lines_.further_.push_back({where.row, where.column, line});
                changes_.lowest = std::min(changes_.lowest, line.place);
                changes_.highest = std::max(changes_.highest, line.place);
            } else
                first = line;
            any = true;
            solid = !solid;
        };
        if (low_ < 0 && solidIn(*segment)) turn(0);
        for (; endOf(*segment) < high_; ++segment) {
            if (segment + 1 == end) { // the grid ends within the window
                if (solid) turn(endOf(*segment));
                break;
            }
            seen_[segment[1].property()] = 1;
            if (solidIn(segment[1]) != solid) turn(endOf(*segment));
        }
        changes_.atEnd |= SurfaceChanges::bitOf(solid);
        return any ? first : uniformLine(solid);
    }
    SurfaceLine change(std::int32_t position, bool fromSolid) const {
        SurfaceLine line;
        line.place = static_cast<std::int16_t>((position - rounding_) >> level_);
        line.toAir = fromSolid ? -1 : 0;
        return line;
    }
    static SurfaceLine uniformLine(bool solid) {
        SurfaceLine line;
        line.place = solid ? -beyond : beyond;
        return line;
    }

    const VolumeState& state_;
    const Grid& grid_;
    const SurfaceWindow& window_;
    const int level_;
    const std::int32_t origin_, low_, high_;     ///< run units; changes after low and before high count
    const std::int32_t rounding_;                ///< the origin, offset so that positions are rounded to the nearest
    const std::uint32_t packedLow_, packedHigh_; ///< a segment ends after low if greater, before high if less
    SurfaceLines& lines_;
    std::uint8_t* const seen_;
    LastLine last_;
    SurfaceChanges changes_;
};

void SurfaceLines::read(const VolumeSnapshot& workpiece, const SurfaceWindow& window) {
    level_ = window.level;
    step_ = (static_cast<std::size_t>(window.columns << level_) + surfaceLineLanes - 1) / surfaceLineLanes *
            surfaceLineLanes;
    lineEnd_ = static_cast<std::int32_t>(workpiece.grid().lineEnd());
    lines_.resize(step_ * (static_cast<std::size_t>(window.rows) << level_));
    firstSegments_.resize(lines_.size());
    further_.clear();
    seen_ = {};
    Reader reader(*this, workpiece, window);
    reader.read();
    std::ranges::sort(further_, {}, [](const Further& further) { return std::pair(further.row, further.column); });
    auto next = further_.begin();
    for (int row = 0; row <= window.rows; ++row) {
        while (next != further_.end() && next->row < row) ++next;
        firstFurther_[static_cast<std::size_t>(row)] = static_cast<std::size_t>(next - further_.begin());
    }
    box_ = findSurfaceBox(window, reader.changes(), lines_);
}

PropertyIndex SurfaceLines::onlyProperty() const {
    int count = 0;
    PropertyIndex found = airProperty;
    eachMaterial([&](PropertyIndex property) {
        found = property;
        ++count;
    });
    return count == 1 ? found : airProperty;
}

bool SurfaceLines::holdsProtected(const PropertyList& properties) const {
    bool any = false;
    eachMaterial([&](PropertyIndex property) { any = any || properties.isProtected(property); });
    return any;
}

template <class Visit>
void SurfaceLines::eachMaterial(Visit visit) const {
    std::uint64_t eight = 0;
    for (std::size_t first = 0; first < seen_.size(); first += sizeof eight) {
        std::memcpy(&eight, &seen_[first], sizeof eight);
        for (std::size_t i = first; eight != 0 && i < first + sizeof eight; ++i) // usually none of them occurs
            if (seen_[i] != 0 && i != airProperty) visit(static_cast<PropertyIndex>(i));
    }
}

} // namespace burin
