// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"

#include <array>
#include <span>
#include <string_view>

namespace burin {

/// The unit of P in a dwell.
enum class DwellUnit : std::uint8_t {
    seconds,
    milliseconds,
    pointDecides ///< seconds with a decimal point, else milliseconds
};

/// The arcs that a control accepts, mm.
struct ArcRadiusRule {
    /// The radii at start and end of an arc given by its centre may differ by `absolute`, or by `relative` times the
    /// larger one (`ofStart`: times that at the start), but at most by `ceiling`.
    double absolute = 0.0, relative = 0.0, ceiling = 0.0;
    bool ofStart = false;
    double inchFactor = 1.0; ///< factor for absolute and ceiling while G20 is in force
    double shortBy = 0.0;    ///< R may be less than half the chord by this much: the arc is then half a turn
    double zero = 1e-9;      ///< a smaller radius by a centre counts as zero
    /// @param inch whether the block is in inches
    bool acceptsRadii(double start, double end, bool inch) const noexcept;
};

/// Where % may occur.
enum class TapeMarks : std::uint8_t {
    none,
    around, ///< before and after the program
    paired, ///< alone in the first line that is not blank; after the program only if it is there too
};

/// The effect of G80 on the motion in force.
enum class CycleCancel : std::uint8_t {
    alone,         ///< no motion stays in force; another motion in its block is a second word of the group
    withMotion,    ///< no motion stays in force except that of its own block
    restoresMotion ///< restores the motion from before the cycle: cycles are a modal group of their own
};

/// The way a control reads a program: a dialect of RS274. Facts and their sources: README.md.
struct Control {
    std::string_view id;                     ///< of the dialects that it reads, such as "linuxcnc"
    std::string_view letters;                ///< letters of words, without G, M, N
    AxisSet axes;                            ///< the axes that words of these letters move
    std::array<std::int8_t, 2000> gGroups{}; ///< by ten times the number: GGroup, or -1
    std::array<std::int8_t, 1000> mGroups{}; ///< by ten times the number: MGroup, or -1
    bool semicolonComments = true;
    TapeMarks tapeMarks = TapeMarks::around;
    CycleCancel cycleCancel = CycleCancel::alone;
    bool programNumbers = false;    ///< O with a number names the program
    bool expressions = false;       ///< #n and [ … ]
    bool namedParameters = false;   ///< #<name>
    bool slashIsDropped = false;    ///< / before a block has no effect
    bool pointNeeded = false;       ///< lengths without a decimal point are in smallest steps
    bool arcNeedsAxis = false;      ///< an arc must name an axis of its plane
    bool arcTurns = false;          ///< P of an arc is its number of turns
    bool blendWords = false;        ///< G64 takes P and Q
    bool repeatsByK = false;        ///< K repeats a canned cycle, like L
    bool dwellByX = false;          ///< G4 X, seconds
    bool retractsToHeight = false;  ///< G99 instead of G98 is in force at the start
    bool unitsByG70 = false;        ///< G70 and G71 mean G20 and G21
    bool bareLineNeedsFeed = false; ///< a G1 without motion needs a feed too
    bool blanksInNumbers = false;   ///< "X1 0" is X10
    bool readsOnBehindEnd = false;  ///< M2 and M30 reset modes, and execution continues with what follows
    /// A, B and C tilt the tool while X, Y and Z stay those of its tip, as the machine is configured, without a code
    /// for it: programs may move the rotary axes that the machine has (withRotaryAxes).
    bool rotaryWords = false;
    bool arcModeIsSetting = false; ///< until G90.1 or G91.1, the meaning of I J K depends on the machine
    DwellUnit dwellUnit = DwellUnit::seconds;
    ArcRadiusRule arcRadius;
    int lineLength = 255;                ///< characters
    int mostMWords = 0;                  ///< in a block; 0: unknown
    bool lengthCountsWordsAlone = false; ///< blanks and comments are not counted

    bool readsG(int tenfold) const noexcept;
    bool readsM(int tenfold) const noexcept;
};

/// All controls that Burin reads, LinuxCNC first.
std::span<const Control> controls() noexcept;
/// The control with that id; nullptr if there is none.
const Control* findControl(std::string_view id) noexcept;
/// A control as it reads the programs of a machine with these axes: with words for those of A, B and C that are among
/// them, if it has any (`rotaryWords`). Lives as long as the program.
const Control& withRotaryAxes(const Control& control, AxisSet axes) noexcept;
/// LinuxCNC, for text that names no control.
const Control& defaultControl() noexcept;

} // namespace burin
