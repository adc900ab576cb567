// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that turn strokes into one machine path: links, then feeds.

/// Links the strokes: retract, at the feed as long as the flutes may cut on the way up, then as a rapid, to
/// `clearanceAbove` over the top of the stock and of everything on it; rapid across; rapid down to `approach` above the
/// remaining stock at the entry; plunge. The remaining stock is known from a conservative height map of the strokes
/// before. Ends no farther apart than the cutter's diameter are joined straight at the cutting feed, where that keeps
/// the allowance and shank and holder stay in empty space. Under an overhang the tool retraces its path to leave.
/// Instead of going over everything, the tool may travel at the lowest height at which, on the straight line across,
/// the whole tool stays `approach` above the remaining stock according to the height map, and clear of part and
/// obstacles; a machine whose axes run independently still goes over everything on diagonal moves. Where the straight
/// line is not clear at that height, the tool may go around obstacles, on the shortest of the routes and heights that
/// were examined, if that is shorter than going over everything. Corners between rapids may be rounded, on the inside,
/// by arcs in chords, as far as the arc is clear in the same sense; level strokes are then also left and entered by a
/// tangent quarter of a circle at the feed, where that keeps the stroke's distances. A stroke that begins in material
/// may be entered by a ramp: back and forth along its own beginning, so that nothing is removed that the stroke keeps;
/// by a helix beside it where the stroke is too short and there is room; straight down at the plunge feed where neither
/// is clear and the tool may plunge.
struct Link {
    enum class Travel { safe, lowest, around };
    enum class Entry { plunge, ramp };
    double clearanceAbove = 5.0; ///< mm
    double approach = 1.0;       ///< mm
    Travel travel = Travel::safe;
    double rounding = 0.0; ///< mm of either move that a rounded corner takes, and largest radius of quarters; 0: sharp
    Entry entry = Entry::plunge;
    double rampAngle = 0.0; ///< rad, largest angle of ramps and helices; 0: by material and tool
};
/// Errors: those of PathContext::lendStock.
EditResult apply(const Link& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Sets feed, plunge feed, spindle speed and coolant from tool, material and machine. Plunges, and moves that descend
/// at more than 45°, get the plunge feed; ramps get half of the feed, but descend no faster than a plunge. Another
/// spindle speed keeps the chip load, so feeds change with it; both stay within the limits of tool and machine. The
/// coolant advised for the material is ignored if the machine lacks it; a coolant that was requested by name is then
/// refused.
struct SetFeed {
    enum class Cooling {
        advised,
        off,
        mist,
        flood,
        program ///< as stated by the program that the path is made from, move by move; as advised where there is none
    };
    enum class Spindle {
        one,       ///< one speed for the path: the lowest of what its materials allow
        byMaterial ///< a speed for each material: it changes at the borders (spindleSchedule)
    };
    enum class Feeds {
        tables, ///< of tool and material
        program ///< as stated by the program that the path is made from; those of the tables where there is none
    };
    double speedFactor = 1.0; ///< of the tables' (or the program's) spindle speed
    double feedFactor = 1.0;  ///< of the tables' (or the program's) chip load
    Cooling cooling = Cooling::advised;
    Spindle spindle = Spindle::one;
    Feeds feeds = Feeds::tables;
};
EditResult apply(const SetFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Feed optimisation by engagement: the path is cut again out of the stock as the paths before it leave it, and each
/// interval of a straight cutting move gets the feed at which the tangential force, or the removal rate, has its target
/// value. Arcs get one feed, the least of their intervals; plunges keep theirs. Feeds stay within the chip loads and
/// the machine's limit, never need more than its acceleration to slow down in time, and (except for the smallest chip)
/// never exceed the limits of spindle and tool where they are stated: power and torque, the tool's bending stress and
/// its chip load. Feeds change where they differ by more than `leastChange`, to the lower one. `limits` keeps the
/// present feeds and only reduces them to these limits; without a stock, or if no limit is stated, it changes nothing.
struct FeedOptimisation {
    enum class Goal { force, removal, limits };
    Goal goal = Goal::force;
    double target = 0.0;                            ///< N or mm³/s; 0: the time average over the path's cutting moves
    double smallestChip = 0.005, largestChip = 0.2; ///< mm per tooth
    double leastChange = 0.1;                       ///< relative change of the feed
    double sampling = 0.5;                          ///< mm of a move between samples
};
/// Errors: argumentInvalid (no stock, no feeds yet), those of PathContext::lendStock.
EditResult apply(const FeedOptimisation& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Multiplies feeds in an area by a factor; the machine's limit holds. Lines are split at the border of the area; an
/// arc is inside if its middle is.
struct AreaFeed : Area {
    double factor = 0.5;
};
EditResult apply(const AreaFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Multiplies feeds of strokes, or of a part of them, by a factor; the machine's limit holds. A move is included if the
/// moment at which it ends is; links between strokes have no moments.
struct ScaleFeed {
    SourceInterval interval;
    double factor = 0.5;
};
EditResult apply(const ScaleFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Sets spindle speed and coolant of part of a path (moves, also arcs, are divided at its ends), or, for a single
/// moment, of all moves between the two rapids around it. Feeds stay unchanged, so another speed changes the chip load.
/// Plunges and other moves made by links get the values of the next cut that follows without a rapid, otherwise those
/// of the cut before.
struct SpindleAndCoolant {
    enum class Cooling { kept, off, mist, flood };
    SourceInterval interval;
    double speed = 0.0;  ///< 1/min; 0: the present speed of each move
    double factor = 1.0; ///< of that speed
    Cooling cooling = Cooling::kept;
};
/// Errors: argumentInvalid (no speeds yet, a speed beyond the tool's limit), programLimit (a speed beyond the machine's
/// range), notSupported (a coolant that the machine lacks).
EditResult apply(const SpindleAndCoolant& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Tilts the tool on part of a path, on a machine whose rotary axes can do so. The tool is tilted from +Z, or from the
/// normal of the part, by `lead` in the direction of motion and by `tilt` to its left; or it has a fixed direction; or
/// that which a program states. Direction and normal are averaged over `blend` along the stroke. At borders of the part
/// of the path within a stroke, the axis turns evenly over `blend` inside the part (half of a shorter part); so it does
/// at ends of strokes, or it turns in the rapids before and after them.
///
/// The tool keeps its contact: a ball its centre, any other cutter the plane that it touches, normal to the part, or
/// beside the part to the motion; or it keeps its tip. Arcs become lines, and moves are divided so that the axis turns
/// by at most 1° on each. At every pose, as the machine moves between the points, the whole tool keeps the clearance
/// from the part that it had upright, or the allowance if that is less, and the margin of each fixture.
struct ToolAxis {
    enum class From {
        upright,
        normal, ///< of the part where the tool is nearest to it
        fixed,
        program ///< of each move, as stated by the program that the path is made from
    };
    enum class Ends { links, blend };
    enum class Keep { contact, tip };
    SourceInterval interval;
    From from = From::upright;
    double lead = 0.0;        ///< rad; above 0: the holder leans ahead
    double tilt = 0.0;        ///< rad; above 0: the holder leans to the left
    double inclination = 0.0; ///< rad from +Z, of a fixed direction
    double azimuth = 0.0;     ///< rad, anticlockwise from +X, of a fixed direction in plan
    double blend = 5.0;       ///< mm
    Ends ends = Ends::links;
    Keep keep = Keep::contact;
};
/// Errors: argumentInvalid (not linked yet, no axes stated by a program), notSupported (a machine without rotary axes,
/// a tool that cuts as a solid), programLimit (the rotary axes can't reach the direction), checkFailed (the tool would
/// enter the part or a fixture).
EditResult apply(const ToolAxis& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using MachineEdits = EditKinds<Link, SetFeed, FeedOptimisation, AreaFeed, ScaleFeed, SpindleAndCoolant, ToolAxis>;

} // namespace burin
