// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"

#include <array>
#include <span>
#include <string_view>

namespace burin {

/// What P of a dwell counts.
enum class DwellUnit : std::uint8_t {
    seconds,
    milliseconds,
    pointDecides ///< seconds with a decimal point, else milliseconds
};

/// Which arcs a control takes, mm.
struct ArcRadiusRule {
    /// The two radii of an arc by its centre may differ by `absolute`, or by `relative` of the larger one (`ofStart`:
    /// of that at the start) and at most `ceiling`.
    double absolute = 0.0, relative = 0.0, ceiling = 0.0;
    bool ofStart = false;
    double inchFactor = 1.0; ///< on absolute and ceiling while G20 is in force
    double shortBy = 0.0;    ///< by which R may be less than half the chord: a half turn then
    double zero = 1e-9;      ///< a smaller radius by a centre is none
    /// @param inch units of the block
    bool acceptsRadii(double start, double end, bool inch) const noexcept;
};

/// Where % may stand.
enum class TapeMarks : std::uint8_t {
    none,
    around, ///< before the program and behind it
    paired, ///< alone in the first line that has something in it; behind the program only where it stands there too
};

/// What G80 does to the motion in force.
enum class CycleCancel : std::uint8_t {
    alone,         ///< none is in force; with another motion in its block it is a second word of their group
    withMotion,    ///< none is in force, but that of its own block
    restoresMotion ///< that from before the cycle is in force again: cycles are a modal group of their own
};

/// How a control reads a program: a flavour of RS274. Facts and their sources: README.md.
struct Control {
    std::string_view id;                     ///< of the dialects that it reads: "linuxcnc"
    std::string_view letters;                ///< of words, without G, M, N
    AxisSet axes;                            ///< that words of these letters move
    std::array<std::int8_t, 2000> gGroups{}; ///< by ten times the number: GGroup, or -1
    std::array<std::int8_t, 1000> mGroups{}; ///< by ten times the number: MGroup, or -1
    bool semicolonComments = true;
    TapeMarks tapeMarks = TapeMarks::around;
    CycleCancel cycleCancel = CycleCancel::alone;
    bool programNumbers = false;    ///< O and a number names the program
    bool expressions = false;       ///< #n and [ … ]
    bool namedParameters = false;   ///< #<name>
    bool slashIsDropped = false;    ///< / before a block has no meaning at all
    bool pointNeeded = false;       ///< lengths without a decimal point count smallest steps
    bool arcNeedsAxis = false;      ///< an arc names an axis of its plane
    bool arcTurns = false;          ///< P of an arc counts turns
    bool blendWords = false;        ///< G64 takes P and Q
    bool repeatsByK = false;        ///< K repeats a canned cycle, besides L
    bool dwellByX = false;          ///< G4 X, seconds
    bool retractsToHeight = false;  ///< G99 rather than G98 is in force at the start
    bool unitsByG70 = false;        ///< G70 and G71 are G20 and G21
    bool bareLineNeedsFeed = false; ///< also a G1 that goes nowhere wants a feed
    bool blanksInNumbers = false;   ///< "X1 0" is X10
    bool readsOnBehindEnd = false;  ///< M2 and M30 set modes back, and what follows is carried out
    bool arcModeIsSetting = false;  ///< how I J K are read until G90.1 or G91.1 depends on the machine
    DwellUnit dwellUnit = DwellUnit::seconds;
    ArcRadiusRule arcRadius;
    int lineLength = 255;                ///< characters
    int mostMWords = 0;                  ///< in a block; 0: no limit is known
    bool lengthCountsWordsAlone = false; ///< blanks and comments don't count

    bool readsG(int tenfold) const noexcept;
    bool readsM(int tenfold) const noexcept;
};

/// All controls that Burin reads, LinuxCNC's first.
std::span<const Control> controls() noexcept;
/// One of them; nullptr when there is none of that id.
const Control* findControl(std::string_view id) noexcept;
/// LinuxCNC's, for text that names none.
const Control& defaultControl() noexcept;

} // namespace burin
