// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin {

/// Constructs in programs of others that one control accepts and another refuses.
struct TextOfOthers {
    std::string_view name;
    std::string_view text;          ///< between `textBegin` and `textEnd`, unless it is `whole`
    bool whole = false;             ///< the program is complete as it is
    std::string_view cautious = {}; ///< reason for which Burin refuses a text that the reference accepts
};

inline constexpr std::string_view textBegin = "G17 G21 G90 G94 G54\nS3000 M3\nG0 X0 Y0 Z60\n", textEnd = "\nM2\n";

inline std::string programOf(const TextOfOthers& of) {
    if (of.whole) return std::string(of.text);
    return std::string(textBegin) + std::string(of.text) + std::string(textEnd);
}

inline constexpr std::string_view unitOfFeed = "controls differ in the unit of a feed in the block that changes units";

inline constexpr TextOfOthers textsOfOthers[] = {
    // modal groups
    {"G0 beside G80", "G0 G80 X5\nX6"},
    {"G80 beside G0", "G80 G0 X5\nX6"},
    {"G1 beside G80", "G1 G80 X5 F100\nX6"},
    {"the usual first line", "G00 G17 G40 G49 G80 G90"},
    {"G81 beside G80", "G81 G80 X5 Y5 Z50 R58 F100\nG80"},
    {"G80 beside G81", "G80 G81 X5 Y5 Z50 R58 F100\nX9\nG80"},
    {"G80 twice", "G80 G80"},
    {"G80 and an axis", "G80 X5"},
    {"an axis behind G80", "G81 X5 Y5 Z50 R58 F100\nG80\nX20 Y20"},
    {"an axis behind G80 and G0", "G81 X5 Y5 Z50 R58 F100\nG80\nG0 X20 Y20"},
    {"G0 beside G1", "G0 G1 X5 F100"},
    {"G0 twice", "G0 G0 X5"},
    {"G80 beside two motions", "G0 G80 G1 X5 F100"},
    {"G0 beside G81", "G0 G81 X5 Y5 Z50 R58 F100"},
    {"G17 beside G18", "G17 G18"},
    {"G90 beside G91.1", "G90 G91.1"},
    {"G54 beside G55", "G54 G55"},
    {"G94 beside G93", "G94 G93"},
    {"M3 beside M5", "M3 M5"},
    {"M7 beside M8", "M7\nM8"},
    {"mist", "M7"},
    {"four M words", "M3 M8 M48 M0"},
    {"four M words of GRBL", "M3 M8 M0"},
    {"five M words", "M5 M9 M48 M1 M6 T1"},
    // feeds
    {"bare G1 without a feed", "G1"},
    {"bare G1 with a feed", "G1 F100"},
    {"a feed for what follows", "G1 F100\nX5"},
    {"bare G0", "G0"},
    {"G1 without a feed", "G1 X5"},
    {"G1 with a feed of 0", "G1 X5 F0"},
    {"bare G1 in inverse time", "F100 G93\nG1"},
    {"feed beside other units", "G1 X5 F100\nG20 X1 F5", false, unitOfFeed},
    {"feed before other units", "G1 X5 F100\nF5 G20", false, unitOfFeed},
    {"feed beside the first units, inch", "G20 F10\nS100 M3\nG0 X0 Y0 Z3\nG1 X1\nM2\n", true, unitOfFeed},
    {"feed beside the same units", "G1 X5 F100\nG21 X1 F50"},
    // arcs
    {"half turn by R", "G2 X20 Y0 R10 F500"},
    {"R too short by 0.00005 mm", "G2 X20 Y0 R9.99995 F500", false},
    {"R too short by 0.0002 mm", "G2 X20 Y0 R9.9998 F500"},
    {"R too short by 0.0012 mm", "G2 X20 Y0 R9.9988 F500"},
    {"R too short by 0.0014 mm", "G2 X20 Y0 R9.9986 F500"},
    {"R too short by 0.004 mm", "G2 X20 Y0 R9.996 F500"},
    {"R too short by 0.02 mm", "G2 X20 Y0 R9.98 F500"},
    {"R too short by 0.00004 in", "G20\nG2 X2 Y0 R0.99996 F50"},
    {"R too short by 0.00006 in", "G20\nG2 X2 Y0 R0.99994 F50"},
    {"R of 0", "G2 X20 Y0 R0 F500"},
    {"R of 0 in a short arc", "G2 X0.0002 Y0 R0 F500", false, "a radius that no control can mean"},
    {"R below 0.001 mm", "G2 X0.001 Y0 R0.0005 F500", false, "a radius that no control can mean"},
    {"R of 0.002 mm", "G2 X0.004 Y0 R0.002 F500"},
    {"R of a full circle", "G2 X0 Y0 R5 F500"},
    {"centre at the start", "G2 X1 Y0 I0 F500", false},
    {"centre 0.0011 mm away", "G2 X0.0022 Y0 I0.0011 F500"},
    {"centre 0.0014 mm away", "G2 X0.0028 Y0 I0.0014 F500"},
    {"radii apart by 0.004 mm", "G2 X20.004 Y0 I10 F500"},
    {"radii apart by 0.02 mm", "G2 X20.02 Y0 I10 F500"},
    {"radii apart by 0.03 mm", "G2 X20.03 Y0 I10 F500"},
    {"radii apart by 0.1 % of the larger", "G2 X200.10005 Y0 I100 F500"},
    {"radii apart by 0.1 % of the start's", "G2 X199.9 Y0 I100 F500"},
    {"radii apart by 0.6 mm of 1000", "G2 X2000.6 Y0 I1000 F500"},
    {"arc without a centre", "G2 X20 Y0 F500"},
    {"bare G2", "F100 G2"},
    {"full circle without an axis", "G2 I10 F500"},
    {"R beside I", "G2 X20 Y0 I10 R10 F500", false, "one of the two is wrong, and a control picks one"},
    // the text
    {"%", "%\nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% behind blank lines", "\n \n%\nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% behind a comment", "(exported)\n%\nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% within", "G0 X5\n%\nG0 X6"},
    {"% behind blanks", " % \nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% and a comment", "%(job)\nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% and words", "% O12\nG17 G21 G90 G94 G54\nG0 X5\nM2\n%\n", true},
    {"% at the end alone", "G17 G21 G90 G94 G54\nG0 X5\n%\n", true},
    {"% at the begin, no end by it", "%\nG17 G21 G90 G94 G54\nG0 X5\nM2\n", true},
    {"any text behind %", "%\nG17 G21 G90 G94 G54\nG0 X5\n%\nsee you\n", true},
    {"any text behind M2", "M2\nsee you"},
    {"any text behind M30", "M30\nO1000 (UNUSED)\nG91 X5.\nM99"},
    {"a move behind M2", "M2\nG0 X99"},
    {"a move beside M2", "M2 G0 X10"},
    {"blanks in numbers", "G 0 1 X1 0 . 5 Y-  2. 0 2 F1 00"},
    {"tabs in numbers", "G1 X1\t0 F100"},
    {"blanks behind a sign", "G1 X- 2 F100"},
    {"a plus sign", "G1 X+2 F100"},
    {"a comment in a number", "G1 X1(c)0 F100", false, "blanks alone are taken out of numbers"},
    {"blanks in a parameter", "# 1 = 2 0\nG1 X# 1 F100"},
    {"a line number with blanks", "N 1 0 G1 X1 F100"},
    {"CR CR LF", "G1 X5 F100\r\r\nG1 X6\r\r"},
    {"CR LF", "G1 X5 F100\r\nG1 X6\r"},
    // constructs that are not read, or only by some controls
    {"subprogram call", "M98 P1000", false, "subprograms are not read"},
    {"O word", "o100 sub\no100 endsub", false, "subprograms are not read"},
    {"a condition", "IF [#1 EQ 1] GOTO 5"},
    {"a loop", "WHILE [#1 LT 1] DO1\nEND1"},
    {"cutter compensation", "G41 D1 X5 F100", false, "it is not read"},
    {"probing", "G38.2 Z0 F100", false, "it is not read"},
    {"a rotary axis", "G0 A90", false, "it is not read"},
    {"polar coordinates", "G16"},
    {"scaling", "G51 X0 Y0 P2"},
    {"rotation", "G68 X0 Y0 R45"},
    {"a macro call", "G65 P1000"},
    {"constant surface speed off", "G97 S1000", false, "it is not read"},
    {"tool table", "G10 L1 P1 Z5", false, "it is not read"},
};

} // namespace burin
