// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_lines.h"

#include "core/volume/volume_access.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::int16_t beyond = SurfaceLine::beyond;

std::int32_t endOf(const Segment& segment) {
    return static_cast<std::int32_t>(segment.end());
}
bool solidIn(const Segment& segment) {
    return segment.property() != airProperty;
}
unsigned stateBit(bool solid) {
    return solid ? 2 : 1;
}

} // namespace

/// Reads the scanlines of one window, row by row.
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
        , further_(lines.further_)
        , seen_(lines.seen_.data())
        , next_(lines.lines_.data())
        , firstSegments_(lines.firstSegments_.data()) {}

    void readRow(int row) {
        const std::int32_t firstV = (window_.firstV + row) << level_;
        for (std::int32_t v = firstV; v < firstV + window_.cell(); ++v) {
            const SurfaceLine* const first = next_;
            readLines(v);
            // So that lines can be looked at in whole lanes.
            for (; static_cast<std::size_t>(next_ - first) % surfaceLineLanes != 0; ++next_) {
                *next_ = next_[-1];
                *firstSegments_++ = nullptr;
            }
        }
    }
    const SurfaceChanges& changes() const { return changes_; }

private:
    void readLines(std::int32_t v) {
        const std::int32_t firstU = window_.firstU << level_, endU = firstU + (window_.columns << level_);
        const bool there = v >= 0 && v < grid_.lineCountV();
        const std::int32_t low = std::max(firstU, 0), high = there ? std::min(endU, grid_.lineCountU()) : low;
        addOutside(low - firstU);
        for (std::int32_t u = low; u < high;) {
            const std::int32_t end = std::min((u / tileSide + 1) * tileSide, high);
            addFrom(state_.store->tile(VolumeAccess::tileAt(state_, u / tileSide, v / tileSide)),
                    TileTable::lineInTile({u, v}), end - u, u - firstU);
            u = end;
        }
        addOutside(endU - high);
    }
    void addOutside(std::int32_t lines) {
        if (lines == 0) return;
        next_ = std::fill_n(next_, lines, SurfaceLine{});
        firstSegments_ = std::fill_n(firstSegments_, lines, nullptr);
        changes_.atBegin |= stateBit(false);
        changes_.atEnd |= stateBit(false);
    }
    /// Lines of a brick, one beside the other along u. Hardly any has more than one end within a window.
    void addFrom(const Tile& tile, int first, int count, std::int32_t place) {
        std::array<const Segment*, tileSide + 1> begins;
        for (int i = 0; i <= count; ++i) begins[static_cast<std::size_t>(i)] = tile.segments() + tile.offset(first + i);
        // Of its own, so that writing what was found can't change where to read.
        const Segment** const firstSegments = firstSegments_;
        SurfaceLine* const lines = next_;
        std::uint8_t* const seen = seen_;
        const std::int32_t low = low_, high = high_;
        std::ptrdiff_t skipped = 0; // segments before the window: mostly as many as in the line before
        unsigned atBegin = 0, atEnd = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const Segment *segment = begins[i] + skipped, *const end = begins[i + 1];
            if (segment >= end || endOf(*segment) <= low || (skipped > 0 && endOf(segment[-1]) > low)) {
                for (segment = begins[i]; endOf(*segment) <= low;) ++segment;
                skipped = segment - begins[i];
            }
            firstSegments[i] = segment;
            const bool solid = solidIn(*segment), one = endOf(*segment) < high;
            if ((low < 0 && solid) || (one && (segment + 1 == end || endOf(segment[1]) < high))) {
                lines[i] = anyEnds(segment, end, (place + static_cast<std::int32_t>(i)) >> level_);
                continue;
            }
            const Segment next = segment[one ? 1 : 0];
            const bool behind = solidIn(next);
            seen[segment->property()] = seen[next.property()] = 1;
            atBegin |= stateBit(solid);
            atEnd |= stateBit(behind);
            lines[i] = solid == behind ? uniformLine(solid) : change(endOf(*segment), solid);
        }
        next_ += count;
        firstSegments_ += count;
        changes_.atBegin |= atBegin;
        changes_.atEnd |= atEnd;
    }
    /// @param segment the first that ends within the window or behind it
    SurfaceLine anyEnds(const Segment* segment, const Segment* end, std::int32_t column) {
        bool solid = low_ >= 0 && solidIn(*segment), any = false;
        seen_[segment->property()] = 1;
        changes_.atBegin |= stateBit(solid);
        SurfaceLine first;
        const auto turn = [&](std::int32_t position) {
            const SurfaceLine line = change(position, solid);
            if (any) {
                further_.push_back({column, line});
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
        changes_.atEnd |= stateBit(solid);
        return any ? first : uniformLine(solid);
    }
    SurfaceLine change(std::int32_t position, bool fromSolid) const {
        SurfaceLine line;
        line.place = static_cast<std::int16_t>((position - origin_ + (1 << level_ >> 1)) >> level_);
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
    const std::int32_t origin_, low_, high_; ///< run units; changes behind low and before high count
    std::vector<Further>& further_;
    std::uint8_t* const seen_;
    SurfaceLine* next_;
    const Segment** firstSegments_;
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
    for (int row = 0; row < window.rows; ++row) {
        firstFurther_[static_cast<std::size_t>(row)] = further_.size();
        reader.readRow(row);
    }
    firstFurther_[static_cast<std::size_t>(window.rows)] = further_.size();
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
    for (std::size_t property = 1; property < seen_.size(); ++property)
        if (seen_[property] != 0) visit(static_cast<PropertyIndex>(property));
}

} // namespace burin
