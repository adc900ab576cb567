// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/line_interval.h"
#include "core/tool/span_rows_tilted.h"
#include "core/tool/tilted_shadow.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// The pose of a piece of a tool relative to scanlines. Lengths are voxels; x counts lines along u, y along v (lines
/// lie at integer x and y), z lies along the runs from the low end of the grid.
struct LinePose {
    glm::dvec3 tip{0.0};
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< unit length
};

/// Spans of the scanlines of a brick, in run units: eight rows of eight lines, v and u counted from the brick's corner.
struct alignas(64) BrickOfSpans {
    EightIntegers low[8], high[8];
};

/// The spans of some groups of eight lines of a row: lines 8 × firstGroup … at u. They form one row in each of several
/// bricks.
struct RowSpans {
    std::int32_t v = 0, firstGroup = 0, groups = 0;
    BrickOfSpans* bricks = nullptr; ///< `groups` of them

    static constexpr std::ptrdiff_t pitch = sizeof(BrickOfSpans) / sizeof(EightIntegers); ///< distance between groups
    EightIntegers* lows() const noexcept { return &bricks->low[v & 7]; }
    EightIntegers* highs() const noexcept { return &bricks->high[v & 7]; }
};

/// Computes the spans swept by a ball-ended, flat or bull-nosed piece on entire rows of scanlines, eight lines at a
/// time, for a straight move with a constant axis, in run units (1/256 voxel), rounded to the nearest.
///
/// A span depends on the line and separately on each end of the move: two moves that meet in a tip position agree on
/// what is covered there, to the last bit, so a tool that rests after a move finds nothing left to remove.
///
/// Accuracy: float, relative to the tip. A span is that of a piece whose outline is off by at most `outlineError` ×
/// (radius + length of the move), with ends then accurate to `endError` units.
class SpanRows {
public:
    static constexpr double outlineError = 1.0 / (1 << 20);
    static constexpr double endError = 1.0;      ///< run units, rounding included
    static constexpr double unitsAVoxel = 256.0; ///< run units
    /// Voxels by which the span of a tilted piece may fall short of what its smooth sides sweep between the ends of a
    /// move.
    static constexpr double leaningWayError = 0.01;
    /// Voxels by which a piece may lean over its length and still count as upright.
    static constexpr double uprightError = 1.0 / 512.0;
    static constexpr std::int32_t none = 1 << 30;
    static constexpr int rowsAtOnce = 8;

    /// Whether this class supports the shape of a piece. @param piece in voxels
    static bool serves(const RevolvedPiece& piece) noexcept;

    /// @param piece   in voxels; one that `serves`
    /// @param lineEnd of the scanlines, run units
    SpanRows(const RevolvedPiece& piece, std::int32_t lineEnd) noexcept;

    /// Whether the piece with this axis counts as upright.
    bool isUpright(const glm::dvec3& axis) const noexcept;
    /// Returns the longest move that can be swept at once, voxels; longer moves must be divided, which loses nothing.
    double longestWay(const glm::dvec3& axis) const noexcept;
    /// Returns the largest distance of any point of the piece from its tip, voxels.
    double reach() const noexcept { return reach_; }

    /// Sets the move for the next rows.
    /// @param withStart false: what the piece covers at the start, or left behind it, is not requested, and lines that
    ///        can't get more may be left out
    void begin(const LinePose& from, const glm::dvec3& toTip, bool withStart) noexcept;
    /// Returns the rows that the swept piece can meet.
    LineInterval rows() const noexcept { return rows_; }
    /// Returns the lines of any row that the swept piece can meet.
    LineInterval columns() const noexcept { return columns_; }
    /// Finds the intervals of some rows that the swept piece can meet.
    /// @param rows    at most `rowsAtOnce`, from `first` on
    /// @param groups  of eight lines that may be requested
    /// @param bricks  storage for all those groups
    /// @param intervals receives the intervals; rows without one are left out
    /// @return number of intervals
    int intervals(std::int32_t first, int rows, const LineInterval& groups, BrickOfSpans* bricks,
                  RowSpans* intervals) noexcept;
    /// Computes the spans of intervals that lie within `rowsAtOnce` rows of each other; low >= high where there is
    /// none. Limited to the ends of the lines.
    void spans(std::span<const RowSpans> intervals) noexcept;

    enum class Shape : std::uint8_t { ball, flat, bullNose };
    /// One end of an upright piece's move.
    struct End {
        std::int32_t wholeX = 0, wholeY = 0; ///< voxels, integer part
        float partX = 0.0F, partY = 0.0F;    ///< voxels, fractional part
        std::int32_t top = 0;                ///< units, of the upper face
        std::int32_t base = 0;               ///< units, reference of the heights
        float middle = 0.0F;                 ///< units from base, of the rounding's middle, + 1/2
        float flatHeight = 0.0F;             ///< units above that, of the flat middle
    };
    /// An upright piece during its move.
    struct Upright {
        float radius = 0.0F, flatRadius = 0.0F, cornerRadius = 0.0F; ///< voxels
        End from, to;
        std::int32_t lineEnd = 0;
        bool topRises = false;       ///< the upper face lies within the grid and at two heights
        std::int32_t levelTop = 0;   ///< units, of the upper face otherwise
        std::int32_t highestTop = 0; ///< units
        bool joins = true;           ///< what is covered at both ends overlaps, or touches, on every line
        // The move between the ends: direction and length across the runs, rise along them.
        float wayX = 1.0F, wayY = 0.0F;      ///< unit
        float reach = 0.0F, perReach = 0.0F; ///< voxels, its inverse
        float rise = 0.0F, riseSign = 0.0F;  ///< units
        float sine = 0.0F, cosine = 1.0F;    ///< of the move's slope
        std::int32_t topBase = 0;            ///< units, reference of the upper face between the ends
        float topMiddle = 0.0F;              ///< units from there, of the upper face at the end, + 1/2
        // The requested part of the move.
        bool withStart = true, moves = false;
        bool clipsLow = false; ///< lines behind the piece can't be lower than at the start
        bool clips = false;    ///< lines behind the piece can't get more
        float slope = 0.0F;    ///< of a ball's move; 0 for others
    };
    /// Returns the move of an upright piece as used by the inner loops (for a test of these).
    const Upright& upright() const noexcept { return upright_; }
    /// Rows of lines that an upright piece meets, one row per lane. Groups consist of eight lines, counted from the
    /// start of the grid.
    struct alignas(64) UprightRows {
        static constexpr std::size_t count = 16;
        using Numbers = std::array<float, count>;
        using Groups = std::array<std::int32_t, count>;
        Numbers fromSquare, toSquare;    ///< R² - y² at both ends, voxels²
        Numbers ahead, aside;            ///< voxels along and across the move, from the start to the line at its x
        Groups begin, end;               ///< groups that the piece can meet
        Groups coveredBegin, coveredEnd; ///< groups with every line covered at both ends; if the top rises
        Groups deeperBegin, deeperEnd;   ///< groups with all lines that can be lower than at the start
        Groups betweenBegin, betweenEnd; ///< groups with all lines where a ball is lowest between the ends
        std::int32_t first = 0;          ///< row
    };

private:
    void plan(std::int32_t first, std::int32_t end) noexcept;
    void beginTilted(const LinePose& from, const glm::dvec3& toTip) noexcept;
    void beginEnd(End& end, const glm::dvec3& tip) const noexcept;
    void beginWay(const glm::dvec3& from, const glm::dvec3& to) noexcept;

    RevolvedPiece piece_;
    Shape shape_ = Shape::ball;
    double radius_ = 0.0, longestWay_ = 0.0;
    double depth_ = 0.0; ///< units, below a rounding's middle, to the reference of the heights
    LineInterval rows_, columns_;
    bool tilts_ = false;
    double reach_ = 0.0;
    glm::dvec3 axis_{0.0, 0.0, 1.0};
    TiltedShadow shadow_; ///< of a tilted piece at the end of its move
    float margin_ = 0.0F; ///< around the shadow, needed by the move
    Upright upright_;
    UprightRows rowsOfUpright_;
    TiltedPiece tilted_;
    TiltedRows rowsOfTilted_;
};

} // namespace burin
