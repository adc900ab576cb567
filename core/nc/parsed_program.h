// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/geometry/arc.h"
#include "core/machine/axis_values.h"

#include <cstdint>
#include <vector>

namespace burin {

enum class NcMotionKind : std::uint8_t { rapid, line, arc, dwell };
enum class SpindleState : std::uint8_t { off, clockwise, anticlockwise };

/// What an F word means.
enum class FeedMode : std::uint8_t {
    perMinute,    ///< G94
    inverseTime,  ///< G93: each move takes 1/F min
    perRevolution ///< G95: per turn of the spindle
};

/// How a program requests corners to be taken, where its control has words for that (LinuxCNC's G61, G61.1, G64 P).
enum class PathMode : std::uint8_t {
    machine,   ///< not stated: as the machine is set
    exactPath, ///< G61: exactly along the move, stopping where it bends
    exactStop, ///< G61.1: stops at the end of every block
    blend      ///< G64
};

/// One move, or a dwell, as the control makes it. Positions are values of the machine's axes in the frame of the work
/// offset in force (G54 …), including shifts by G52 and G92; `Kinematics` converts them to tool poses.
struct NcMotion {
    NcMotionKind kind = NcMotionKind::line;
    SpindleState spindle = SpindleState::off;
    FeedMode feedMode = FeedMode::perMinute; ///< in force; `feed` is converted to mm/min in any mode
    PathMode pathMode = PathMode::machine;
    bool mist = false, flood = false; ///< coolant
    bool clockwise = false;           ///< arc: seen against its axis (G2)
    std::uint8_t arcAxis = 2;         ///< arc: 0 X (G19), 1 Y (G18), 2 Z (G17)
    /// Excludes axes that no block has set yet, or not since a tool change, a change to another work offset or (Z)
    /// length offset, or a move in the machine's frame. `from` has no meaning for these.
    AxisSet fromKnown = linearAxes;
    /// Excludes axes that are unknown and that the block does not set, or that it moves in the machine's frame (G28,
    /// G30, G53).
    AxisSet toKnown = linearAxes;
    std::uint32_t wholeTurns = 0; ///< arc: turns made before the last one; `arc` describes the last one
    AxisValues from, to;
    glm::dvec3 centre{0.0}; ///< arc, mm; its component along the axis has no meaning
    /// mm/min along the move of X, Y and Z, or degrees/min if only rotary axes move; 0 for rapids, dwells and where the
    /// text does not state it
    double feed = 0.0;
    double seconds = 0.0;        ///< of a dwell
    double spindleSpeed = 0.0;   ///< 1/min
    double blendTolerance = 0.0; ///< mm, of PathMode::blend; 0: without limit
    /// mm, of the same: largest deviation of lines from one that replaces them; 0: none are replaced
    double mergeTolerance = 0.0;
    int tool = 0;         ///< loaded
    int lengthOffset = 0; ///< H number in force; 0: none, -1: one that the program itself states (G43.1)
    int workOffset = 54;  ///< 54 … 59; 591 … 593: G59.1 … G59.3; 1000 + n: G54.1 Pn, G154 Pn
    /// The program sets a work offset, or (G92) a zero at a position that it does not know: its positions are then not
    /// in the frame of the offset that the machine had.
    bool ownZero = false;
    std::uint32_t line = 0;   ///< of the text, from 1
    std::uint32_t column = 0; ///< of the word in the block that makes the move, from 1

    bool rapid() const noexcept { return kind == NcMotionKind::rapid; }
    bool spindleOn() const noexcept { return spindle != SpindleState::off && spindleSpeed > 0.0; }
    /// Whether the program determines where the move begins. @param axes axes that have to be known
    bool startKnown(AxisSet axes = linearAxes) const noexcept { return fromKnown.hasAll(axes); }
    /// whether it determines the end
    bool endKnown(AxisSet axes = linearAxes) const noexcept { return toKnown.hasAll(axes); }
    /// Whether the move takes an axis to a position in the frame of the work offset, rather than of the machine (G28,
    /// G53). False for a dwell.
    bool takes(Axis axis) const noexcept {
        return kind != NcMotionKind::dwell && toKnown.has(axis) && (!fromKnown.has(axis) || to[axis] != from[axis]);
    }
    /// Whether it takes any axis there.
    bool takesAny() const noexcept {
        for (const Axis axis : toKnown)
            if (takes(axis)) return true;
        return false;
    }
    /// The arc without its whole turns, of X, Y and Z; of an arc alone.
    Arc arc() const noexcept { return {from.linear(), to.linear(), centre, arcAxis, clockwise}; }
    /// The whole sweep of an arc, `wholeTurns` included.
    ArcTurn turn() const noexcept;
};

/// Flood if both are on.
inline Coolant coolantOf(const NcMotion& motion) noexcept {
    return motion.flood ? Coolant::flood : motion.mist ? Coolant::mist : Coolant::off;
}

/// Words that stay in force and may be the cause of a finding many lines later.
enum class NcSettingKind : std::uint8_t {
    toolSelected, ///< T; value: its number
    toolChange,   ///< M6, M61; value: the number
    spindle,      ///< M3, M4, M5; value: SpindleState
    lengthOffset, ///< G43, G43.1, G49; value: as NcMotion::lengthOffset
    workOffset,   ///< G54 …; value: as NcMotion::workOffset
    shift,        ///< G52, G92 … G92.3; value: 1 if a shift may be in force afterwards
    distance,     ///< G90, G91; value: 1 if distances are incremental
    pathControl   ///< G61, G61.1, G64 of a control that blends; value: PathMode
};

/// A line that makes one of these settings.
struct NcSetting {
    NcSettingKind kind = NcSettingKind::toolChange;
    int value = 0;
    std::uint32_t line = 0;  ///< of the text, from 1
    std::size_t motions = 0; ///< number of motions before it
};

/// What a program does, read back from its text.
struct ParsedProgram {
    std::vector<NcMotion> motions;
    std::vector<NcSetting> settings;  ///< in the order in which they come into force
    std::size_t blocks = 0;           ///< lines that hold at least one word
    double maximumSpindleSpeed = 0.0; ///< 1/min
    int workOffset = 54;              ///< in force at the end, numbered as in NcMotion
    bool ended = false;               ///< M2, M30 or a closing %
};

/// The length of a move's path in X, Y and Z, mm: of a line, or of an arc with all its turns. For a spiral, whose
/// radius changes evenly from one value to the other, it is the sum of chords of a 512th of a turn: too short by less
/// than 1e-4 of the length.
double lengthOf(const NcMotion& motion) noexcept;
/// The largest rotation of a rotary axis on a move, degrees.
double rotationOf(const NcMotion& motion) noexcept;
/// The positions of the axes at a fraction of a move's path, whole turns included.
AxisValues placeIn(const NcMotion& motion, double share);

/// The moves, for callers that need straight ones: arcs become lines whose chords deviate from them by no more than
/// `chordTolerance` mm, > 0; dwells are left out. All other properties of a motion are kept.
std::vector<NcMotion> straightMoves(const ParsedProgram& program, double chordTolerance);
/// The same for one motion, appended to `moves`.
void appendStraightMoves(const NcMotion& motion, double chordTolerance, std::vector<NcMotion>& moves);

} // namespace burin
