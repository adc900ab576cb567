// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_tilted_corners.h"

#include <algorithm>
#include <array>

namespace burin::kernels {

namespace {

/// The groups of a row, and where their spans are stored.
struct Groups {
    std::int32_t begin = 0, end = 0; ///< counted from the interval's first
};

/// Calls `take(heights, places, group)` for what the piece covers of some groups in its position.
template <Rounding rounding, bool rises, class Take>
BURIN_INLINE void forEachGroup(const RowPiece<rounding, rises>& row, Floats firstU, Groups groups,
                               const Take& take) noexcept {
    if constexpr (rounding == Rounding::bullNose) {
        Part part;
        for (; groups.begin < groups.end; groups.begin += Part::mostGroups) {
            const std::int32_t count = std::min(groups.end - groups.begin, Part::mostGroups);
            Floats u = firstU + static_cast<float>(groups.begin * lanes);
            coverPart(row, u, count, part);
            for (std::int32_t i = 0; i < count; ++i, u += lanes)
                take({load(part.low[i]), load(part.high[i])}, u, groups.begin + i);
        }
    } else {
        Floats u = firstU + static_cast<float>(groups.begin * lanes);
        for (std::int32_t i = groups.begin; i < groups.end; ++i, u += lanes) take(row.at(u), u, i);
    }
}

/// Returns the positions of an interval's first group: lines counted from the integer part of an end's x. These are
/// integers, so that the result for a line does not depend on where its interval begins.
BURIN_INLINE Floats linesFrom(const TiltedPiece::End& end, const RowSpans& interval) noexcept {
    return floatsOf(Integers{0, 1, 2, 3, 4, 5, 6, 7} + (interval.firstGroup * lanes - end.wholeX));
}

/// Where the spans of a row are stored.
struct Kept {
    EightIntegers *lows, *highs;
    Integers base, lineEnd;
    BURIN_INLINE EightIntegers& low(std::int32_t group) const noexcept { return lows[group * RowSpans::pitch]; }
    BURIN_INLINE EightIntegers& high(std::int32_t group) const noexcept { return highs[group * RowSpans::pitch]; }
    BURIN_INLINE Kept(const TiltedPiece& piece, const TiltedPiece::End& end, const RowSpans& interval) noexcept
        : lows(interval.lows()), highs(interval.highs()), base(integers(end.base)), lineEnd(integers(piece.lineEnd)) {}
};

/// Stores what the piece covers at the end of its move.
struct KeepEnd : Kept {
    using Kept::Kept;
    BURIN_INLINE void operator()(const Heights& all, Floats, std::int32_t group) const noexcept {
        // Empty spans are marked first, as clipping to the lines' ends would hide them. Without a span, the upper end
        // (of a steep plane) may exceed the range of an integer: this is harmless, but requires an unsigned addition.
        const Floats from = all.low < all.high ? all.low : floats(nowhere);
        store(most(wholeOf(from) + base, Integers{}), low(group));
        const Words to = reinterpret_cast<Words>(wholeOf(all.high)) + reinterpret_cast<Words>(base);
        store(least(reinterpret_cast<Integers>(to), lineEnd), high(group));
    }
};

/// Adds what the piece covers at the start, and the walls swept by rims from there.
template <std::size_t count>
struct AddWay : Kept {
    const std::array<RowRim, count>& walls;
    BURIN_INLINE AddWay(const TiltedPiece& piece, const RowSpans& interval,
                        const std::array<RowRim, count>& itsWalls) noexcept
        : Kept(piece, piece.from, interval), walls(itsWalls) {}
    BURIN_INLINE void operator()(const Heights& start, Floats u, std::int32_t group) const noexcept {
        Heights all;
        all.include(start);
        for (std::size_t i = 0; i < count; ++i) all.include(walls[i].at(u));
        const Integers oldLow = load(low(group)), oldHigh = load(high(group)),
                       none = oldLow > integers(SpanRows::none / 2);
        const Integers newLow = wholeOf(all.low) + base, newHigh = wholeOf(all.high) + base;
        store(most(none ? newLow : least(oldLow, newLow), Integers{}), low(group));
        store(least(none ? newHigh : most(oldHigh, newHigh), lineEnd), high(group));
    }
};

/// The groups of some rows that a rim passes. A row usually has one or two adjacent groups: these are handled without a
/// branch.
class RimPlaces {
public:
    struct Place {
        std::uint32_t interval = 0;
        std::int32_t group = 0;
    };
    static constexpr std::size_t most = 256;

    BURIN_INLINE void add(std::uint32_t interval, Groups groups) noexcept {
        const std::int32_t all = std::max(groups.end - groups.begin, 0);
        places_[count_] = {interval, groups.begin};
        places_[count_ + 1] = {interval, groups.begin + 1};
        count_ += static_cast<std::size_t>(std::min(all, 2));
        for (std::int32_t i = 2; i < all; ++i) places_[count_++] = {interval, groups.begin + i};
    }
    BURIN_INLINE bool hasRoom(std::int32_t groups) const noexcept {
        return count_ + static_cast<std::size_t>(groups) + 4 <= most;
    }
    BURIN_INLINE const Place* begin() const noexcept { return places_; }
    BURIN_INLINE const Place* end() const noexcept { return places_ + count_; }
    BURIN_INLINE void clear() noexcept { count_ = 0; }

private:
    Place places_[most];
    std::size_t count_ = 0;
};

/// The requested rows of a piece.
template <Rounding rounding, bool rises>
struct Cover {
    using Row = RowPiece<rounding, rises>;
    static constexpr std::size_t firstRim = rounding == Rounding::none ? 0 : 1;
    const TiltedPiece& piece;
    const TiltedRows& rows;
    Intervals intervals;

    BURIN_INLINE int rowOf(const RowSpans& interval) const noexcept { return interval.v - rows.first; }

    /// Computes what the piece covers at the end of its move.
    BURIN_INLINE void end() const noexcept {
        const RowsPiece standing(piece, piece.to, rows.first);
        for (const RowSpans& interval : intervals) {
            const Row row(standing, rowOf(interval));
            const Floats lines = linesFrom(piece.to, interval);
            const KeepEnd keep(piece, piece.to, interval);
            if constexpr (rounding == Rounding::ball) {
                const Groups simple = within(interval, rows.ballToFaceBegin, rows.ballToFaceEnd);
                forEachGroup(row, lines, {0, simple.begin}, keep);
                Floats u = lines + static_cast<float>(simple.begin * lanes);
                for (std::int32_t i = simple.begin; i < simple.end; ++i, u += lanes) keep(row.ballToFaceAt(u), u, i);
                forEachGroup(row, lines, {simple.end, interval.groups}, keep);
            } else {
                forEachGroup(row, lines, {0, interval.groups}, keep);
            }
        }
    }
    /// Adds what it covers at the start and during the move, everywhere.
    BURIN_INLINE void way() const noexcept {
        const RowsPiece standing(piece, piece.from, rows.first);
        const RowsRim lower(piece.rims[0], piece.from, rows.first), upper(piece.rims[1], piece.from, rows.first);
        for (const RowSpans& interval : intervals) {
            const int row = rowOf(interval);
            const Floats lines = linesFrom(piece.from, interval);
            if constexpr (firstRim == 0)
                forEachGroup(Row(standing, row), lines, {0, interval.groups},
                             AddWay(piece, interval, std::array{RowRim(lower, row), RowRim(upper, row)}));
            else
                forEachGroup(Row(standing, row), lines, {0, interval.groups},
                             AddWay(piece, interval, std::array{RowRim(upper, row)}));
        }
    }
    /// The same only where rims pass.
    BURIN_INLINE void rims() const noexcept {
        const RowsPiece standing(piece, piece.from, rows.first);
        for (std::size_t i = firstRim; i < 2; ++i) {
            const RowsRim rim(piece.rims[i], piece.from, rows.first);
            RimPlaces places;
            std::uint32_t number = 0;
            for (const RowSpans& interval : intervals) {
                const Groups before = within(interval, rows.rims[i].outerBegin, rows.rims[i].innerBegin),
                             behind = within(interval, rows.rims[i].innerEnd, rows.rims[i].outerEnd);
                if (rounding == Rounding::bullNose || !places.hasRoom(interval.groups)) {
                    addGroups(standing, rim, interval, before);
                    addGroups(standing, rim, interval, behind);
                } else {
                    places.add(number, before);
                    places.add(number, behind);
                }
                ++number;
            }
            addPlaces(standing, rim, places);
        }
    }

private:
    BURIN_INLINE Groups within(const RowSpans& interval, const EightIntegers& begin,
                               const EightIntegers& end) const noexcept {
        const int row = rowOf(interval);
        return {std::clamp(begin[row] - interval.firstGroup, 0, interval.groups),
                std::clamp(end[row] - interval.firstGroup, 0, interval.groups)};
    }
    BURIN_INLINE void addGroups(const RowsPiece& standing, const RowsRim& rim, const RowSpans& interval,
                                Groups groups) const noexcept {
        const int row = rowOf(interval);
        forEachGroup(Row(standing, row), linesFrom(piece.from, interval), groups,
                     AddWay(piece, interval, std::array{RowRim(rim, row)}));
    }
    BURIN_INLINE void addPlaces(const RowsPiece& standing, const RowsRim& rim, const RimPlaces& places) const noexcept {
        if constexpr (rounding != Rounding::bullNose)
            for (const RimPlaces::Place& place : places) {
                const RowSpans& interval = intervals[place.interval];
                const int row = rowOf(interval);
                const Floats u = linesFrom(piece.from, interval) + static_cast<float>(place.group * lanes);
                const std::array walls{RowRim(rim, row)};
                AddWay(piece, interval, walls)(Row(standing, row).at(u), u, place.group);
            }
    }
};

template <Rounding rounding, bool rises>
BURIN_INLINE void coverRows(const TiltedPiece& piece, const TiltedRows& rows, Intervals intervals) noexcept {
    const Cover<rounding, rises> cover{piece, rows, intervals};
    cover.end();
    if (!piece.moves) return;
    if (piece.withStart || piece.rimsEverywhere)
        cover.way();
    else
        cover.rims();
}

} // namespace

BURIN_VECTORISED_TO_AVX512 void tiltedBall(const TiltedPiece& piece, const TiltedRows& rows,
                                           Intervals intervals) noexcept {
    if (piece.rises)
        coverRows<Rounding::ball, true>(piece, rows, intervals);
    else
        coverRows<Rounding::ball, false>(piece, rows, intervals);
}

BURIN_VECTORISED_TO_AVX512 void tiltedFlat(const TiltedPiece& piece, const TiltedRows& rows,
                                           Intervals intervals) noexcept {
    coverRows<Rounding::none, true>(piece, rows, intervals);
}

BURIN_VECTORISED_TO_AVX512 void tiltedBullNose(const TiltedPiece& piece, const TiltedRows& rows,
                                               Intervals intervals) noexcept {
    coverRows<Rounding::bullNose, true>(piece, rows, intervals);
}

} // namespace burin::kernels
