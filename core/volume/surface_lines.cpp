// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_lines.h"

#include "core/volume/volume_access.h"

#include <algorithm>
#include <limits>

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
        , next_(lines.lines_.data()) {}

    void readRow(int row) {
        const std::int32_t firstV = (window_.firstV + row) << level_;
        for (std::int32_t v = firstV; v < firstV + window_.cell(); ++v) {
            const SurfaceLine* const first = next_;
            readLines(v);
            // So that lines can be looked at in whole lanes.
            for (; static_cast<std::size_t>(next_ - first) % surfaceLineLanes != 0; ++next_) *next_ = next_[-1];
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
        changes_.atBegin |= stateBit(false);
        changes_.atEnd |= stateBit(false);
    }
    /// Lines of a brick, one beside the other along u.
    void addFrom(const Tile& tile, int first, int count, std::int32_t place) {
        const std::int32_t low = low_, whole = low < 0 ? std::numeric_limits<std::int32_t>::max() : high_;
        const Segment *const segments = tile.segments(), *begin = segments + tile.offset(first);
        std::ptrdiff_t skipped = 0; // segments before the window: mostly as many as in the line before
        unsigned states = 0;
        for (int i = 0; i < count; ++i) {
            const Segment *const end = segments + tile.offset(first + i + 1), *segment = begin + skipped;
            if (segment >= end || endOf(*segment) <= low || (skipped > 0 && endOf(segment[-1]) > low)) {
                for (segment = begin; endOf(*segment) <= low;) ++segment;
                skipped = segment - begin;
            }
            if (endOf(*segment) >= whole) {
                const bool solid = solidIn(*segment);
                seen_[segment->property()] = 1;
                states |= stateBit(solid);
                next_[i].place = solid ? -beyond : beyond;
                next_[i].toAir = 0;
            } else
                next_[i] = readChanges(segment, end, (place + i) >> level_);
            begin = end;
        }
        next_ += count;
        changes_.atBegin |= states;
        changes_.atEnd |= states;
    }
    /// @param segment the first that ends within the window or behind it
    SurfaceLine readChanges(const Segment* segment, const Segment* end, std::int32_t column) {
        bool solid = low_ >= 0 && solidIn(*segment), any = false;
        changes_.atBegin |= stateBit(solid);
        seen_[segment->property()] = 1;
        SurfaceLine first;
        const auto change = [&](std::int32_t position) {
            SurfaceLine line;
            line.place = static_cast<std::int16_t>((position - origin_ + (1 << level_ >> 1)) >> level_);
            line.toAir = solid ? -1 : 0;
            changes_.lowest = std::min(changes_.lowest, line.place);
            changes_.highest = std::max(changes_.highest, line.place);
            if (any)
                further_.push_back({column, line});
            else
                first = line;
            any = true;
            solid = !solid;
        };
        if (low_ < 0 && solidIn(*segment)) change(0);
        for (; endOf(*segment) < high_; ++segment) {
            if (segment + 1 == end) { // the grid ends within the window
                if (solid) change(endOf(*segment));
                break;
            }
            seen_[segment[1].property()] = 1;
            if (solidIn(segment[1]) != solid) change(endOf(*segment));
        }
        changes_.atEnd |= stateBit(solid);
        if (!any && solid) first.place = -beyond;
        return first;
    }

    const VolumeState& state_;
    const Grid& grid_;
    const SurfaceWindow& window_;
    const int level_;
    const std::int32_t origin_, low_, high_; ///< run units; changes behind low and before high count
    std::vector<Further>& further_;
    std::uint8_t* const seen_;
    SurfaceLine* next_;
    SurfaceChanges changes_;
};

void SurfaceLines::read(const VolumeSnapshot& workpiece, const SurfaceWindow& window) {
    level_ = window.level;
    step_ = (static_cast<std::size_t>(window.columns << level_) + surfaceLineLanes - 1) / surfaceLineLanes *
            surfaceLineLanes;
    lines_.resize(step_ * (static_cast<std::size_t>(window.rows) << level_));
    further_.clear();
    seen_.fill(0);
    Reader reader(*this, workpiece, window);
    for (int row = 0; row < window.rows; ++row) {
        firstFurther_[static_cast<std::size_t>(row)] = further_.size();
        reader.readRow(row);
    }
    firstFurther_[static_cast<std::size_t>(window.rows)] = further_.size();
    box_ = findSurfaceBox(window, reader.changes(), lines_);
}

PropertyIndex SurfaceLines::onlyProperty() const {
    const auto first = std::find(seen_.begin() + 1, seen_.end(), std::uint8_t{1});
    const bool one = first != seen_.end() && std::find(first + 1, seen_.end(), std::uint8_t{1}) == seen_.end();
    return one ? static_cast<PropertyIndex>(first - seen_.begin()) : airProperty;
}

bool SurfaceLines::holdsProtected(const PropertyList& properties) const {
    for (std::size_t i = 1; i < seen_.size(); ++i)
        if (seen_[i] != 0 && properties.isProtected(static_cast<PropertyIndex>(i))) return true;
    return false;
}

} // namespace burin
