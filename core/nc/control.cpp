// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/control.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>

namespace burin {
namespace {

using Numbers = std::initializer_list<int>;

constexpr std::int8_t groupOfG(int tenfold) noexcept {
    const auto group = [](GGroup value) { return static_cast<std::int8_t>(value); };
    switch (tenfold) {
    case 40:
    case 100:
    case 280:
    case 281:
    case 300:
    case 301:
    case 520:
    case 530:
    case 920:
    case 921:
    case 922:
    case 923:
        return group(GGroup::once);
    case 0:
    case 10:
    case 20:
    case 30:
    case 730:
    case 800:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 870:
    case 880:
    case 890:
        return group(GGroup::motion);
    case 170:
    case 180:
    case 190:
        return group(GGroup::plane);
    case 200:
    case 210:
    case 700:
    case 710:
        return group(GGroup::units);
    case 400:
    case 410:
    case 420:
        return group(GGroup::compensation);
    case 430:
    case 431:
    case 490:
        return group(GGroup::lengthOffset);
    case 540:
    case 541:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593:
    case 1540:
        return group(GGroup::workOffset);
    case 610:
    case 611:
    case 640:
        return group(GGroup::control);
    case 900:
    case 910:
        return group(GGroup::distance);
    case 901:
    case 911:
        return group(GGroup::arcDistance);
    case 930:
    case 940:
    case 950:
        return group(GGroup::feedMode);
    case 980:
    case 990:
        return group(GGroup::retract);
    case 500:
    case 690:
        return group(GGroup::harmless);
    case 51:
    case 1870:
        return group(GGroup::smoothing);
    default:
        return tenfold >= 1100 && tenfold <= 1290 && tenfold % 10 == 0 ? group(GGroup::workOffset) : std::int8_t{-1};
    }
}

constexpr std::int8_t groupOfM(int number) noexcept {
    const auto group = [](MGroup value) { return static_cast<std::int8_t>(value); };
    switch (number) {
    case 0:
    case 1:
    case 2:
    case 30:
    case 60:
        return group(MGroup::stop);
    case 6:
    case 61:
        return group(MGroup::toolChange);
    case 3:
    case 4:
    case 5:
        return group(MGroup::spindle);
    case 7:
    case 8:
    case 9:
        return group(MGroup::coolant);
    case 48:
    case 49:
        return group(MGroup::overrides);
    case 98:
    case 99:
        return group(MGroup::subprogram);
    default:
        return -1;
    }
}

/// Read by every control of the family: motions, planes, units, offsets, distance and feed per minute.
constexpr Numbers commonG{0,   10,  20,  30,  40,  170, 180, 190, 200, 210, 280, 300, 400, 490,
                          530, 540, 550, 560, 570, 580, 590, 610, 800, 900, 910, 920, 940};
constexpr Numbers commonM{0, 1, 2, 3, 4, 5, 8, 9, 30};
constexpr Numbers drilling{730, 810, 820, 830, 840, 850, 860, 890, 980, 990};

Control controlOf(std::string_view id, std::string_view letters, std::initializer_list<Numbers> g,
                  std::initializer_list<Numbers> m) {
    Control control;
    control.id = id;
    control.letters = letters;
    for (const Axis axis : allAxes) control.axes.set(axis, letters.find(letterOf(axis)) != std::string_view::npos);
    control.gGroups.fill(-1);
    control.mGroups.fill(-1);
    for (const Numbers& numbers : g)
        for (const int tenfold : numbers) control.gGroups[static_cast<std::size_t>(tenfold)] = groupOfG(tenfold);
    for (const Numbers& numbers : m)
        for (const int number : numbers) control.mGroups[static_cast<std::size_t>(number * 10)] = groupOfM(number);
    return control;
}

/// linuxcnc.org/docs/html/gcode; radii: interp_arc.cc (2.9).
Control linuxCnc() {
    Control control = controlOf("linuxcnc", "DFHIJKLPQRSTXYZ",
                                {commonG, drilling, {100, 281, 301, 410, 420, 430, 431, 520, 591, 592, 593,
                                                     611, 640, 870, 880, 901, 911, 921, 922, 923, 930, 950}},
                                {commonM, {6, 7, 48, 49, 60, 61, 98, 99}});
    control.expressions = control.namedParameters = true;
    control.arcTurns = true;
    control.blendWords = true;
    control.retractsToHeight = true;
    control.rotaryWords = true;
    control.tapeMarks = TapeMarks::paired;
    control.cycleCancel = CycleCancel::withMotion;
    control.bareLineNeedsFeed = true;
    control.blanksInNumbers = true;
    control.mostMWords = 4;
    control.arcRadius = {.absolute = 0.0282842712474619,
                         .relative = 0.001,
                         .ceiling = 2.82842712474619,
                         .inchFactor = 2.54,
                         .shortBy = 0.00127,
                         .zero = 0.00127};
    return control;
}

constexpr ArcRadiusRule grblArcs{
    .absolute = 0.005, .relative = 0.001, .ceiling = 0.5, .ofStart = true, .shortBy = 1e-6};

/// GRBL 1.1: doc/markdown/commands.md, gcode.c. Blanks, comments and / are removed before the line is measured. M7
/// exists only where it was compiled in.
Control grbl() {
    Control control = controlOf("grbl", "FIJKLPRSTXYZ", {commonG, {100, 281, 301, 431, 911, 921, 930}}, {commonM});
    control.tapeMarks = TapeMarks::none;
    control.slashIsDropped = true;
    control.arcNeedsAxis = true;
    control.bareLineNeedsFeed = true;
    control.blanksInNumbers = true;
    control.readsOnBehindEnd = true;
    control.arcRadius = grblArcs;
    control.lineLength = 79;
    control.lengthCountsWordsAlone = true;
    return control;
}

/// grblHAL: a superset of GRBL; codes that depend on its build options (tool change, G43 H, G95) are read.
Control grblHal() {
    Control control = controlOf("grblhal", "DFHIJKLPQRSTXYZ",
                                {commonG, drilling, {100, 281, 301, 430, 431, 500, 591, 592, 593, 911, 921, 930, 950}},
                                {commonM, {6, 7, 61}});
    control.arcNeedsAxis = true;
    control.bareLineNeedsFeed = true;
    control.blanksInNumbers = true;
    control.readsOnBehindEnd = true;
    control.arcRadius = grblArcs;
    control.lineLength = 256;
    return control;
}

/// For controls without published values: Fanuc's parameter 3410 sets how far radii may differ.
constexpr ArcRadiusRule cautiousArcs{.absolute = 0.01, .ceiling = 0.01, .shortBy = 0.002};

/// Fanuc 0i and 30i with custom macros.
Control fanuc() {
    Control control =
        controlOf("fanuc", "DFHIJKLOPQRSTXYZ",
                  {commonG, drilling, {51, 410, 420, 430, 500, 520, 541, 640, 690, 870, 880, 921, 930, 950}},
                  {commonM, {6, 7, 98, 99}});
    control.semicolonComments = false;
    control.programNumbers = true;
    control.expressions = true;
    control.pointNeeded = true;
    control.repeatsByK = true;
    control.dwellByX = true;
    control.dwellUnit = DwellUnit::milliseconds;
    control.cycleCancel = CycleCancel::restoresMotion;
    control.arcRadius = cautiousArcs;
    return control;
}

/// Haas mill; 80 characters is the limit that the maker of its best-known post observes. Radii as for Fanuc.
Control haas() {
    Control control = controlOf("haas", "DEFHIJKLOPQRSTXYZ",
                                {commonG, drilling, {410,  420,  430,  500,  520,  640,  690,  880,  930,  950,  1540,
                                                     1870, 1100, 1110, 1120, 1130, 1140, 1150, 1160, 1170, 1180, 1190,
                                                     1200, 1210, 1220, 1230, 1240, 1250, 1260, 1270, 1280, 1290}},
                                {commonM, {6, 7, 98, 99}});
    control.semicolonComments = false;
    control.programNumbers = true;
    control.expressions = true;
    control.pointNeeded = true;
    control.dwellUnit = DwellUnit::pointDecides;
    control.cycleCancel = CycleCancel::restoresMotion;
    control.arcRadius = cautiousArcs;
    control.lineLength = 80;
    return control;
}

/// Mach3 and Mach4.
Control mach() {
    Control control = controlOf("mach", "DFHIJKLOPQRSTXYZ",
                                {commonG, drilling, {100, 281, 301, 410, 420, 430, 500, 520, 640, 690, 700,
                                                     710, 870, 880, 901, 911, 921, 922, 923, 930, 950}},
                                {commonM, {6, 7, 48, 49, 98, 99}});
    control.programNumbers = true;
    control.expressions = true;
    control.unitsByG70 = true;
    control.arcModeIsSetting = true;
    control.cycleCancel = CycleCancel::withMotion;
    control.blanksInNumbers = true;
    control.arcRadius = {.absolute = 0.002, .ceiling = 0.002, .shortBy = 0.002};
    return control;
}

const std::array<Control, 6>& all() {
    static const std::array<Control, 6> table{linuxCnc(), grbl(), grblHal(), fanuc(), haas(), mach()};
    return table;
}

} // namespace

bool ArcRadiusRule::acceptsRadii(double start, double end, bool inch) const noexcept {
    const double factor = inch ? inchFactor : 1.0, difference = std::abs(start - end);
    if (difference <= absolute * factor) return true;
    return difference <= ceiling * factor && difference <= relative * (ofStart ? start : std::max(start, end));
}

bool Control::readsG(int tenfold) const noexcept {
    return tenfold >= 0 && tenfold < static_cast<int>(gGroups.size()) &&
           gGroups[static_cast<std::size_t>(tenfold)] >= 0;
}

bool Control::readsM(int tenfold) const noexcept {
    return tenfold >= 0 && tenfold < static_cast<int>(mGroups.size()) &&
           mGroups[static_cast<std::size_t>(tenfold)] >= 0;
}

std::span<const Control> controls() noexcept {
    return all();
}

const Control* findControl(std::string_view id) noexcept {
    for (const Control& control : all())
        if (control.id == id) return &control;
    return nullptr;
}

const Control& withRotaryAxes(const Control& control, AxisSet axes) noexcept {
    constexpr std::size_t sets = 8; // of A, B and C
    struct Variants {
        std::array<std::string, sets> letters;
        std::array<Control, sets> controls;
    };
    static const std::map<std::string_view, Variants> table = [] {
        std::map<std::string_view, Variants> made;
        for (const Control& each : all()) {
            if (!each.rotaryWords) continue;
            Variants& variants = made[each.id];
            for (std::size_t set = 0; set < sets; ++set) {
                Control& variant = variants.controls[set] = each;
                variants.letters[set] = each.letters;
                for (const Axis axis : {Axis::a, Axis::b, Axis::c}) {
                    if ((set >> (static_cast<std::size_t>(axis) - 3) & 1U) == 0) continue;
                    variants.letters[set] += letterOf(axis);
                    variant.axes.set(axis);
                }
                variant.letters = variants.letters[set];
            }
        }
        return made;
    }();
    const auto found = table.find(control.id);
    if (found == table.end()) return control;
    std::size_t set = 0;
    for (const Axis axis : {Axis::a, Axis::b, Axis::c})
        if (axes.has(axis)) set |= std::size_t{1} << (static_cast<std::size_t>(axis) - 3);
    return set == 0 ? control : found->second.controls[set];
}

const Control& defaultControl() noexcept {
    return all().front();
}

} // namespace burin
