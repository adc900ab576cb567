// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits of the recorded motion, in any order. Points stay one tick apart, so that filters in time may follow any of
// them.

/// Leaves out parts that removed nothing, unless the boundary held the tool (a finishing pass over finished stock is
/// work, not air) or the part is shorter than `shortest`. A stroke that did nothing at all is left out as well.
struct DropAirCuts {
    double shortest = 3.0; ///< mm
};
EditResult apply(const DropAirCuts& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Leaves out samples while the tip stays slower than `speed` for longer than `time` and removes nothing. A slowly
/// moving tip keeps a point every 0.05 mm, so that the shape is preserved.
struct DropDwells {
    double speed = 1.0; ///< mm/s
    double time = 0.15; ///< s
};
EditResult apply(const DropDwells& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Smooths the shape of strokes and keeps their timing: a cubic spline over the arc length of the stroke, with a
/// penalty on its third derivative (P-spline), has the gain 1 / (1 + (wavelength / w)⁶) for the wavelength w across the
/// stroke. Tremor along the stroke does not belong to the shape: steps back of less than half of the wavelength are
/// removed. Each point lies within `tolerance` of the curve, and the curve within `tolerance` of the stroke, so that
/// corners stay where the tolerance requires it.
struct SmoothShape {
    double wavelength = 3.0; ///< mm, the cut-off
    double tolerance = 0.03; ///< mm
};
EditResult apply(const SmoothShape& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

// Smoothing in time, as used by paths of earlier versions: where the hand stops and goes on, it may step back.

/// Zero-phase low pass in time (forward-backward Butterworth, second order), cut-off in Hz, kept within `tolerance` of
/// the recorded tips. Steps of an encoder are removed first, so that clamping to the tolerance does not reintroduce
/// them. Never filters across a gap.
struct Smooth {
    double cutOff = 5.0;     ///< Hz
    double tolerance = 0.03; ///< mm
};
EditResult apply(const Smooth& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Zero-phase smoothing by a cubic spline in time with evenly spaced knots and a penalty on its third derivative
/// (P-spline): its gain is 1 / (1 + (f / cut-off)⁶) for a frequency f. Where it would deviate from the recording by
/// more than `tolerance`, it is pulled towards it, so that corners stay where the tolerance requires it; every point of
/// either lies within `tolerance` of the other.
struct SmoothSpline {
    double cutOff = 5.0;     ///< Hz
    double tolerance = 0.03; ///< mm
};
EditResult apply(const SmoothSpline& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

// Unless stated otherwise, the following edits apply to all of each stroke that has a moment in their interval. Without
// an interval: to all strokes.

/// Deletes part of the path. The stroke ends before it and a new one begins behind it.
struct CutOut {
    SourceInterval interval;
};
EditResult apply(const CutOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Shortens strokes, measured along the path. Strokes that have no length left are dropped.
struct Trim {
    SourceInterval interval;
    double fromStart = 0.0, fromEnd = 0.0; ///< mm
};
EditResult apply(const Trim& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Extends strokes straight on in the direction in which they begin and end (over their first and last millimetre). The
/// new points are as far apart as those next to them; they remove no known material, and a later edit keeps them out of
/// the part.
struct Extend {
    SourceInterval interval;
    double atStart = 0.0, atEnd = 2.0; ///< mm
};
EditResult apply(const Extend& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Splits a stroke in two; both have the point.
struct Split {
    Moment at;
};
EditResult apply(const Split& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Joins consecutive strokes of one take by a straight move, where their ends are no farther apart than `longest`. The
/// move gets points as far apart as those around it.
struct Join {
    SourceInterval interval;
    double longest = 5.0; ///< mm
};
EditResult apply(const Join& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Moves the stroke that has one moment before the stroke that has the other; to the end if there is no such stroke.
struct Reorder {
    Moment stroke, before;
};
EditResult apply(const Reorder& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Reverses strokes: climb becomes conventional, and vice versa.
struct Reverse {
    SourceInterval interval;
};
EditResult apply(const Reverse& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Mirrors strokes at a vertical plane: climb becomes conventional.
struct Mirror {
    enum class Across { x, y };
    SourceInterval interval;
    Across across = Across::x;
    double at = 0.0;   ///< mm, of the plane
    bool keep = false; ///< the originals stay, before their images
};
EditResult apply(const Mirror& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Rotates strokes about a vertical axis.
struct Rotate {
    SourceInterval interval;
    glm::dvec3 centre{0.0}; ///< mm
    double angle = 0.0;     ///< rad, anticlockwise seen from above
};
EditResult apply(const Rotate& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Copies strokes: the k-th copy is rotated by k times `turn` about a vertical axis, then moved by k times `step`. All
/// copies come after the existing strokes.
struct Array {
    SourceInterval interval;
    glm::dvec3 step{10.0, 0.0, 0.0}; ///< mm
    glm::dvec3 centre{0.0};          ///< mm
    double turn = 0.0;               ///< rad
    double copies = 1.0;             ///< besides the original
};
EditResult apply(const Array& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Moves the points of an interval, and those along the stroke up to `falloff` beyond it, with decreasing displacement
/// (cosine). On the surface only the component along the part is applied, and the tool keeps its distance from the
/// part.
struct MovePoints {
    enum class Along { free, surface };
    SourceInterval interval;
    glm::dvec3 by{0.0};   ///< mm
    double falloff = 5.0; ///< mm
    Along along = Along::free;

    /// The fraction of `by` that a point gets at this distance along the stroke from the points of the interval, mm.
    double shareAt(double way) const noexcept;
};
EditResult apply(const MovePoints& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Inserts a point into the stroke that has a moment, and into its copies, at that moment or `beyond` it along the
/// stroke (no farther than its end), displaced by `by`. The stroke within `length` of it on either side follows:
/// smoothly (cosine), or along straight lines that meet in the point; moves there are divided, so that the smooth curve
/// is followed to within 0.001 mm where the stroke is straight. Without a length only the point is displaced, and the
/// moves to it from the points on either side are straight.
struct InsertPoint {
    enum class Form { smooth, corner };
    Moment at;                ///< of no source: nothing is inserted
    double beyond = 0.0;      ///< mm, in the direction of the stroke
    glm::dvec3 by{0.0};       ///< mm; 0: the point lies on the stroke, which stays unchanged
    double length = 5.0;      ///< mm
    Form form = Form::smooth; ///< of the blend

    /// The fraction of `by` that a point gets at this distance along the stroke from the inserted point, mm.
    double shareAt(double way) const noexcept;
};
/// Errors: argumentInvalid, if the path no longer has the moment.
EditResult apply(const InsertPoint& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Replaces an interval by points, with its timing and straight moves between them.
struct ReplaceInterval {
    SourceInterval interval;
    std::vector<glm::dvec3> places; ///< mm; none: nothing is replaced
};
/// Errors: argumentInvalid, if the path has no such interval.
EditResult apply(const ReplaceInterval& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Deletes what lies in an area, cut off exactly at its border.
struct RemoveArea : Area {};
EditResult apply(const RemoveArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Retracts within an area, straight up and down at its border.
struct LiftArea : Area {
    double lift = 1.0; ///< mm
};
EditResult apply(const LiftArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Leaves holding tabs between part and stock: where the tip passes one of the points in plan, it goes over a tab that
/// is `width` wide in every direction and `height` high above the lowest point of any stroke there, up and down at 30°.
/// All strokes that pass do so, at any level, so that none cuts a tab that another one has left.
struct KeepTabs {
    std::vector<glm::dvec3> places; ///< mm, setup frame; heights are ignored. Empty: no tabs
    double width = 5.0;             ///< mm, of the tab between the cutter's sides
    double height = 1.0;            ///< mm
};
EditResult apply(const KeepTabs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using RecordingEdits = EditKinds<DropAirCuts, DropDwells, CutOut, Trim, Extend, Split, Join, Reorder, Reverse, Mirror,
                                 Rotate, Array, MovePoints, InsertPoint, ReplaceInterval, RemoveArea, LiftArea,
                                 KeepTabs, SmoothShape, Smooth, SmoothSpline>;

} // namespace burin
