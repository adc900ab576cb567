// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that make strokes one path of a machine: links, then feeds.

/// Joins the stretches: retract, at the feed as long as the flutes may cut on the way up, then rapidly, to
/// `clearanceAbove` over the top of the stock and of what stands there, rapid across, rapid down to `approach` above
/// what is left at the entry, plunge. What is left is known from a conservative height map of the strokes before. Ends
/// no farther apart than the cutter's diameter are joined straight at the cutting feed, where that keeps the allowance
/// and shank and holder stay in empty space. Under an overhang the tool leaves along the way it came. Instead of over
/// everything it may travel at the lowest height at which the whole tool, on its straight way across, stays `approach`
/// above what the height map says is left, and clear of part and obstacles; a machine whose axes run independently goes
/// askew over everything all the same. Where the straight way is not clear so low, it may go round what stands there,
/// at the height and on the way that are shortest of some that were looked at, where that is shorter than over
/// everything. Corners between rapid moves may be rounded, inside, by arcs in chords, as far as what is inside stays
/// clear in the same way; and level strokes are then left, and entered, tangent to them by a quarter of a circle at the
/// feed, where that keeps what the stroke keeps. A stroke that begins in material may be entered by a ramp: to and fro
/// along its own beginning, so that nothing is removed that it leaves; a helix beside it where it is too short and
/// there is room; straight down at the plunge feed where neither is clear and the tool may.
struct Link {
    enum class Travel { safe, lowest, around };
    enum class Entry { plunge, ramp };
    double clearanceAbove = 5.0; ///< mm
    double approach = 1.0;       ///< mm
    Travel travel = Travel::safe;
    double rounding = 0.0; ///< mm of either move that a rounded corner takes, and radius of quarters, at most; 0: sharp
    Entry entry = Entry::plunge;
    double rampAngle = 0.0; ///< rad, of ramps and helices, at most; 0: by material and tool
};
/// Errors: those of PathContext::lendStock.
EditResult apply(const Link& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Feed, plunge feed, spindle speed and coolant from tool, material and machine. Plunges, and moves that go down by
/// more than 45°, get the plunge feed; ramps half of the feed, but go down no faster than a plunge. Another spindle
/// speed keeps the chip load, so feeds go with it; both stay within what tool and machine can do. The material's advice
/// for a coolant that the machine lacks is left aside, a coolant that was asked for by name is refused then.
struct SetFeed {
    enum class Cooling { advised, off, mist, flood };
    enum class Spindle {
        one,       ///< speed for the path: the least that any material on it allows
        byMaterial ///< speed for each: it changes at the borders (spindleSchedule)
    };
    enum class Feeds {
        tables, ///< of tool and material
        program ///< as a program states them that the path is made of; the tables' where none does
    };
    double speedFactor = 1.0; ///< of the tables' (or the program's) spindle speed
    double feedFactor = 1.0;  ///< of the tables' (or the program's) chip load
    Cooling cooling = Cooling::advised;
    Spindle spindle = Spindle::one;
    Feeds feeds = Feeds::tables;
};
EditResult apply(const SetFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Feeds by what the tool meets: the path is cut again out of the stock as the paths before it leave it, and each
/// stretch of a straight cutting move gets the feed at which the tangential force, or the removal rate, is what is
/// aimed at. Arcs get one feed, the least that one of their stretches asks for; plunges keep theirs. Feeds stay within
/// the chip loads and the machine's limit, never need more than its acceleration to come down in time, nor (but for the
/// smallest chip) more than the limits of spindle and tool where they are stated: power and torque, the tool's bending
/// stress and its chip. They change where they differ by more than `leastChange`, to the lower one. `limits` keeps the
/// feeds that there are and only brings them down for these limits; without a stock, or where nothing is stated, it
/// changes nothing.
struct LevelFeed {
    enum class Goal { force, removal, limits };
    Goal goal = Goal::force;
    double target = 0.0; ///< N or mm³/s; 0: the mean over time that the path has where it cuts
    double smallestChip = 0.005, largestChip = 0.2; ///< mm a tooth
    double leastChange = 0.1;                       ///< of the feed
    double sampling = 0.5;                          ///< mm of a move between looks
};
/// Errors: argumentInvalid (no stock, no feeds yet), those of PathContext::lendStock.
EditResult apply(const LevelFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Feeds in an area are multiplied by a factor; the machine's limit holds. Lines are split at its border; an arc counts
/// where its middle lies.
struct AreaFeed : Area {
    double factor = 0.5;
};
EditResult apply(const AreaFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Feeds of strokes, or of a part of them, are multiplied by a factor; the machine's limit holds. A move counts where
/// the moment at which it ends does; what links strokes has none.
struct ScaleFeed {
    SourceStretch stretch;
    double factor = 0.5;
};
EditResult apply(const ScaleFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using MachineEdits = EditKinds<Link, SetFeed, LevelFeed, AreaFeed, ScaleFeed>;

} // namespace burin
