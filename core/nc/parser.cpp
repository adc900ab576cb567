// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parser.h"

#include "core/base/units.h"
#include "core/geometry/arc.h"
#include "core/nc/block.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr std::array<char, 3> axisLetters{'X', 'Y', 'Z'};
constexpr std::array<char, 3> offsetLetters{'I', 'J', 'K'};

constexpr double radiusTolerance = 0.0282842712474619; // mm: 4 sqrt(2) times half a step of two decimals
constexpr double radiusTolerancePart = 0.001;          // of the radius

/// Why the end points and the centre give no arc; nullptr when they do. The rule of LinuxCNC's interp_arc.cc (2.9):
/// radii at both ends may differ by 0.0283 mm, or by 0.1 % where that is more, up to 2.83 mm.
const char* faultOf(const Arc& arc) noexcept {
    const ArcTurn turn = turnOf(arc);
    if (turn.startRadius < 1e-9 || turn.endRadius < 1e-9) return "arc of radius zero";
    const double difference = std::abs(turn.startRadius - turn.endRadius);
    if (difference > 100.0 * radiusTolerance ||
        (difference > radiusTolerance && difference > radiusTolerancePart * std::max(turn.startRadius, turn.endRadius)))
        return "radius at the end of the arc differs from the radius at its start";
    return nullptr;
}

/// Carries blocks out, in the order of RS274/NGC (NIST 6556, table 8), whatever the order of the words.
class Interpreter {
public:
    ParsedProgram program;
    BlockFault fault;

    bool run(const Block& block, std::uint32_t line) {
        line_ = line;
        if (program.ended) return fail(block.firstColumn, "words behind the program's end");
        ++program.blocks;
        return checkWords(block) && feedAndSpeed(block) && toolChange(block) && spindle(block) && dwell(block) &&
               planeAndUnits(block) && offsets(block) && control(block) && motion(block) && stop(block);
    }

private:
    bool fail(std::uint32_t column, std::string_view reason) {
        fault = {std::max(column, 1u), reason, {}};
        return false;
    }
    bool fail(const Word& word, std::string_view reason) { return fail(word.column, reason); }
    bool fail(const Code& code, std::string_view reason) { return fail(code.column, reason); }

    /// Words that have no meaning without another one.
    bool checkWords(const Block& block) {
        const Code& length = block.code(GGroup::lengthOffset);
        const bool dwells = block.code(GGroup::dwell).given();
        const bool blends = block.code(GGroup::control).number == 640;
        if (block.word('H').given() && length.number != 430) return fail(block.word('H'), "H without G43");
        if (block.word('P').given() && !dwells && !blends) return fail(block.word('P'), "P without G4 or G64");
        if (block.word('P').given() && dwells && blends) return fail(block.word('P'), "P for both G4 and G64");
        if (block.word('Q').given() && !blends) return fail(block.word('Q'), "Q without G64");
        if (dwells && (block.hasAxis() || block.hasOffset() || block.code(GGroup::motion).given()))
            return fail(block.code(GGroup::dwell), "dwell and motion in one block");
        for (const char letter : {'F', 'S', 'T', 'H', 'P', 'Q'}) {
            if (block.word(letter).given() && block.word(letter).value < 0.0)
                return fail(block.word(letter), "negative number");
        }
        for (const char letter : {'T', 'H'}) {
            const Word& word = block.word(letter);
            if (word.given() && word.value != std::floor(word.value)) return fail(word, "number is not whole");
        }
        return true;
    }

    /// A feed beside a change of units is refused: controls differ in which units it has.
    bool feedAndSpeed(const Block& block) {
        const Code& units = block.code(GGroup::units);
        const Word& feed = block.word('F');
        double length = length_;
        if (units.given()) {
            length = units.number == 200 ? millimetresPerInch : 1.0;
            if (feed.given() && unitsStated_ && length != length_) return fail(feed, "feed beside a change of units");
        }
        if (feed.given()) feed_ = feed.value * length;
        if (const Word& speed = block.word('S'); speed.given()) {
            speed_ = speed.value;
            program.maximumSpindleSpeed = std::max(program.maximumSpindleSpeed, speed_);
        }
        if (block.word('T').given()) selectedTool_ = static_cast<int>(block.word('T').value);
        return true;
    }

    /// Where a tool change leaves the machine is the machine's own affair.
    bool toolChange(const Block& block) {
        if (!block.code(MGroup::toolChange).given()) return true;
        tool_ = selectedTool_;
        spindle_ = SpindleState::off;
        mist_ = flood_ = false;
        known_ = {false, false, false};
        return true;
    }

    bool spindle(const Block& block) {
        if (const Code& code = block.code(MGroup::spindle); code.given())
            spindle_ = code.number == 30   ? SpindleState::clockwise
                       : code.number == 40 ? SpindleState::anticlockwise
                                           : SpindleState::off;
        if (const Code& code = block.code(MGroup::coolant); code.given()) {
            mist_ = code.number == 70 || (mist_ && code.number == 80);
            flood_ = code.number == 80 || (flood_ && code.number == 70);
        }
        return true;
    }

    bool dwell(const Block& block) {
        const Code& code = block.code(GGroup::dwell);
        return !code.given() || block.word('P').given() || fail(code, "G4 without P");
    }

    bool planeAndUnits(const Block& block) {
        if (const Code& plane = block.code(GGroup::plane); plane.given())
            planeAxis_ = plane.number == 170 ? 2 : plane.number == 180 ? 1 : 0;
        if (const Code& units = block.code(GGroup::units); units.given()) {
            length_ = units.number == 200 ? millimetresPerInch : 1.0;
            unitsStated_ = true;
        }
        return true;
    }

    /// Another offset gives the place where the tool stands other coordinates, which the text does not tell.
    bool offsets(const Block& block) {
        if (const Code& code = block.code(GGroup::lengthOffset); code.given()) {
            known_[2] = false;
            lengthOffset_ = code.number == 490        ? 0
                            : block.word('H').given() ? static_cast<int>(block.word('H').value)
                                                      : tool_;
        }
        if (const Code& code = block.code(GGroup::workOffset); code.given()) {
            const int offset = code.number / 10;
            if (offset != program.workOffset) known_ = {false, false, false};
            program.workOffset = offset;
        }
        return true;
    }

    bool control(const Block& block) {
        if (const Code& code = block.code(GGroup::distance); code.given()) incremental_ = code.number == 910;
        return true;
    }

    bool motion(const Block& block) {
        if (const Code& code = block.code(GGroup::motion); code.given()) motion_ = code.number;
        if (!block.hasAxis() && !block.hasOffset()) return true;
        if (motion_ == noMotion) return fail(firstAxis(block), "axis word without a motion in force");
        std::array<bool, 3> known = known_;
        glm::dvec3 target = place_;
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            const Word& word = block.word(axisLetters[at]);
            if (!word.given()) continue;
            if (incremental_ && !known_[at]) return fail(word, "incremental move from a place that is not known");
            target[axis] = word.value * length_ + (incremental_ ? place_[axis] : 0.0);
            known[at] = true;
        }
        if (motion_ == 0 || motion_ == 10) {
            if (block.hasOffset()) return fail(firstOffset(block), "arc offset without an arc");
            if (motion_ == 10 && feed_ <= 0.0) return fail(firstAxis(block), "feed is missing");
            move(target, known, firstAxis(block));
        } else if (!arc(block, target, known)) {
            return false;
        }
        known_ = known;
        return true;
    }

    bool arc(const Block& block, const glm::dvec3& target, const std::array<bool, 3>& known) {
        const auto column = block.hasAxis() ? firstAxis(block) : firstOffset(block);
        if (feed_ <= 0.0) return fail(column, "feed is missing");
        Arc arc{place_, target, place_, planeAxis_, motion_ == 20};
        bool given = false;
        for (int axis = 0; axis < 3; ++axis) {
            const Word& word = block.word(offsetLetters[static_cast<std::size_t>(axis)]);
            if (axis == planeAxis_) {
                if (word.given()) return fail(word, "arc offset across the arc's plane");
                continue;
            }
            if (!known_[static_cast<std::size_t>(axis)]) return fail(column, "arc from a place that is not known");
            if (word.given()) arc.centre[axis] += word.value * length_;
            given = given || word.given();
        }
        if (!given) return fail(column, "arc without I, J or K");
        if (const char* reason = faultOf(arc)) return fail(column, reason);
        // A helix needs its start along the axis too, unless it goes nowhere there.
        if (!known_[static_cast<std::size_t>(planeAxis_)] && target[planeAxis_] != place_[planeAxis_])
            return fail(column, "arc from a place that is not known");
        move(target, known, column);
        NcMotion& motion = program.motions.back();
        motion.centre = arc.centre;
        motion.arcAxis = static_cast<std::uint8_t>(planeAxis_);
        motion.clockwise = arc.clockwise;
        return true;
    }

    void move(const glm::dvec3& target, const std::array<bool, 3>& known, std::uint32_t column) {
        NcMotion& motion = program.motions.emplace_back();
        motion.kind = motion_ == 0 ? NcMotionKind::rapid : motion_ == 10 ? NcMotionKind::line : NcMotionKind::arc;
        motion.from = place_;
        motion.to = target;
        motion.fromKnown = known_;
        motion.toKnown = known;
        motion.feed = motion.rapid() ? 0.0 : feed_;
        motion.spindle = spindle_;
        motion.spindleSpeed = speed_;
        motion.mist = mist_;
        motion.flood = flood_;
        motion.lengthOffset = lengthOffset_;
        motion.workOffset = program.workOffset;
        motion.tool = tool_;
        motion.line = line_;
        motion.column = column;
        place_ = target;
    }

    bool stop(const Block& block) {
        const Code& code = block.code(MGroup::stop);
        if (code.number == 20 || code.number == 300) program.ended = true;
        return true;
    }

    static std::uint32_t firstOf(const Block& block, const std::array<char, 3>& letters) {
        std::uint32_t column = 0;
        for (const char letter : letters) {
            const Word& word = block.word(letter);
            if (word.given() && (column == 0 || word.column < column)) column = word.column;
        }
        return column;
    }
    static std::uint32_t firstOffset(const Block& block) { return firstOf(block, offsetLetters); }
    static std::uint32_t firstAxis(const Block& block) {
        return block.hasAxis() ? firstOf(block, axisLetters) : firstOffset(block);
    }

    static constexpr int noMotion = 800; // G80
    std::uint32_t line_ = 0;
    glm::dvec3 place_{0.0};
    std::array<bool, 3> known_{false, false, false};
    int motion_ = noMotion;
    int planeAxis_ = 2;
    bool incremental_ = false;
    double length_ = 1.0; // mm per unit in force
    bool unitsStated_ = false;
    double feed_ = 0.0;  // mm/min
    double speed_ = 0.0; // 1/min
    SpindleState spindle_ = SpindleState::off;
    bool mist_ = false, flood_ = false;
    int lengthOffset_ = 0;
    int selectedTool_ = 0, tool_ = 0;
};

Error syntaxError(const std::string& origin, std::uint32_t line, const BlockFault& fault) {
    std::string detail(fault.reason);
    if (!fault.text.empty()) detail += ": " + std::string(fault.text.substr(0, 40));
    return Error{ErrorCode::programSyntax, origin,
                 "line " + std::to_string(line) + ", column " + std::to_string(fault.column), std::move(detail)};
}

} // namespace

Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin) {
    Interpreter interpreter;
    Block block;
    std::uint32_t line = 0;
    bool seenTapeMark = false, seenWords = false;
    while (!text.empty()) {
        ++line;
        const std::size_t end = text.find('\n');
        std::string_view content = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (!content.empty() && content.back() == '\r') content.remove_suffix(1);
        if (!readBlock(content, block, interpreter.fault)) return syntaxError(origin, line, interpreter.fault);
        if (block.percent) {
            // The first line's % opens the tape, the next one ends the program and all that is read of it.
            if (seenTapeMark || seenWords) {
                interpreter.program.ended = true;
                break;
            }
            seenTapeMark = true;
        } else if (!block.empty()) {
            seenWords = true;
            if (!interpreter.run(block, line)) return syntaxError(origin, line, interpreter.fault);
        }
    }
    return std::move(interpreter.program);
}

} // namespace burin
