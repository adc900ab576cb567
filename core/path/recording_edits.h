// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits of what the hand did, in any order. Points stay a tick apart, so that filters in time may follow any of them.

/// Leaves out stretches that removed nothing, unless the boundary held the tool (a finishing pass over finished stock
/// is work, not air) or the stretch is shorter than `shortest`. A stroke in which nothing was done at all goes as well.
struct DropAirCuts {
    double shortest = 3.0; ///< mm
};
EditResult apply(const DropAirCuts& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Leaves out samples while the tip stays slower than `speed` for longer than `time` and removes nothing. A tip that
/// creeps keeps a point every 0.05 mm, so that the shape stays.
struct DropDwells {
    double speed = 1.0; ///< mm/s
    double time = 0.15; ///< s
};
EditResult apply(const DropDwells& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Smooths the shape of strokes and leaves the law of time: a cubic spline by the stroke's own length, with a penalty
/// on its third derivative (P-spline), leaves 1 / (1 + (wavelength / w)⁶) of what has the wavelength w across the
/// stroke. Tremor along it is no shape: steps back of less than half of the wavelength go. Each point lies within
/// `tolerance` of the curve, and the curve within `tolerance` of the stroke, so that corners stay where the tube
/// demands it.
struct SmoothShape {
    double wavelength = 3.0; ///< mm, the cut-off
    double tolerance = 0.03; ///< mm
};
EditResult apply(const SmoothShape& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

// Smoothing in time, as paths made by earlier versions have it: where the hand stops and goes on, it may step back.

/// Zero-phase low pass in time (forward-backward Butterworth, second order), cut-off in Hz, held within `tolerance` of
/// the recorded tips. Steps of an encoder are taken out first, so that holding the tolerance does not bring them back.
/// Never across a gap.
struct Smooth {
    double cutOff = 5.0;     ///< Hz
    double tolerance = 0.03; ///< mm
};
EditResult apply(const Smooth& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Zero-phase smoothing by a cubic spline in time with evenly spaced knots and a penalty on its third derivative
/// (P-spline): leaves 1 / (1 + (f / cut-off)⁶) of a frequency f. Where it would leave the recording by more than
/// `tolerance`, it is drawn to it there, so that corners stay where the tube demands it; every place of one lies within
/// `tolerance` of the other.
struct SmoothSpline {
    double cutOff = 5.0;     ///< Hz
    double tolerance = 0.03; ///< mm
};
EditResult apply(const SmoothSpline& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

// The following mean the strokes that have a moment in their stretch, whole, unless they say otherwise. No stretch:
// all strokes.

/// Leaves a stretch out. The stroke ends before it and a new one begins behind it.
struct CutOut {
    SourceStretch stretch;
};
EditResult apply(const CutOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Makes strokes shorter, along their way. One that has no length left goes.
struct Trim {
    SourceStretch stretch;
    double fromStart = 0.0, fromEnd = 0.0; ///< mm
};
EditResult apply(const Trim& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Makes strokes longer, straight on as they begin and end (over their first and last millimetre). The new points are
/// as far apart as those beside them; they cut nothing that is known, and a later edit keeps them off the part.
struct Extend {
    SourceStretch stretch;
    double atStart = 0.0, atEnd = 2.0; ///< mm
};
EditResult apply(const Extend& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Makes two strokes of one; both have the point.
struct Split {
    Moment at;
};
EditResult apply(const Split& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Joins strokes of one take that follow each other by a straight way, where their ends are no farther apart than
/// `longest`. The way gets points as far apart as those around it.
struct Join {
    SourceStretch stretch;
    double longest = 5.0; ///< mm
};
EditResult apply(const Join& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Moves the stroke that has a moment to before the stroke that has another one; no such: to the end.
struct Reorder {
    Moment stroke, before;
};
EditResult apply(const Reorder& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Turns strokes round: climb becomes conventional, and the other way round.
struct Reverse {
    SourceStretch stretch;
};
EditResult apply(const Reverse& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Mirrors strokes at an upright plane: climb becomes conventional.
struct Mirror {
    enum class Across { x, y };
    SourceStretch stretch;
    Across across = Across::x;
    double at = 0.0;   ///< mm, of the plane
    bool keep = false; ///< the originals stay, before their images
};
EditResult apply(const Mirror& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Turns strokes about an upright axis.
struct Rotate {
    SourceStretch stretch;
    glm::dvec3 centre{0.0}; ///< mm
    double angle = 0.0;     ///< rad, anticlockwise seen from above
};
EditResult apply(const Rotate& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Copies strokes: the k-th copy is turned by k times `turn` about an upright axis, then moved by k times `step`. All
/// copies come behind the strokes that are there.
struct Array {
    SourceStretch stretch;
    glm::dvec3 step{10.0, 0.0, 0.0}; ///< mm
    glm::dvec3 centre{0.0};          ///< mm
    double turn = 0.0;               ///< rad
    double copies = 1.0;             ///< besides the original
};
EditResult apply(const Array& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Moves the points of a stretch, and those along the stroke up to `falloff` beyond, ever less (cosine). On the surface
/// only what goes along the part counts, and the tool ends as far from it as it was.
struct MovePoints {
    enum class Along { free, surface };
    SourceStretch stretch;
    glm::dvec3 by{0.0};   ///< mm
    double falloff = 5.0; ///< mm
    Along along = Along::free;

    /// How much of `by` a point takes that lies so far along the stroke from those that are meant, mm.
    double shareAt(double way) const noexcept;
};
EditResult apply(const MovePoints& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Puts places in a stretch's stead, in its time and straight from one to the next.
struct ReplaceStretch {
    SourceStretch stretch;
    std::vector<glm::dvec3> places; ///< mm; none: nothing is replaced
};
/// Errors: argumentInvalid, where the path has no such stretch.
EditResult apply(const ReplaceStretch& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Leaves out what lies in an area, cut off exactly at its border.
struct RemoveArea : Area {};
EditResult apply(const RemoveArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Lifts what lies in an area, up and down at its border.
struct LiftArea : Area {
    double lift = 1.0; ///< mm
};
EditResult apply(const LiftArea& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Leaves tabs between part and stock: where the tip passes a place in plan it goes over a tab that is `width` wide in
/// every direction and `height` high above the lowest point of any stroke there, up and down at 30°. All strokes that
/// pass do so, whatever their level, so that none cuts a tab that another one has left.
struct KeepTabs {
    std::vector<glm::dvec3> places; ///< mm, setup frame; heights have no meaning. None: no tabs
    double width = 5.0;             ///< mm, of what is left between the cutter's sides
    double height = 1.0;            ///< mm
};
EditResult apply(const KeepTabs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using RecordingEdits =
    EditKinds<DropAirCuts, DropDwells, CutOut, Trim, Extend, Split, Join, Reorder, Reverse, Mirror, Rotate, Array,
              MovePoints, ReplaceStretch, RemoveArea, LiftArea, KeepTabs, SmoothShape, Smooth, SmoothSpline>;

} // namespace burin
