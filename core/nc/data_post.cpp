// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/data_post.h"

#include "core/base/units.h"
#include "core/nc/arc_steps.h"
#include "core/nc/block_writer.h"
#include "core/nc/control.h"
#include "core/nc/rounded_line.h"
#include "core/nc/work_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double largestCoordinate = 1e6; // mm; keeps the rounded integers far from overflow
constexpr std::array<char, 3> offsetLetters{'I', 'J', 'K'};
constexpr int rotaryDecimals = 4;        // of degrees: 0.1 µm at 60 mm from the axis
constexpr int firstFurtherOffset = 1000; // NcProgram::workOffset

template <class Text>
std::size_t indexOf(Text kind) noexcept {
    return static_cast<std::size_t>(kind);
}

/// The arcs that both the dialect and the machine's own control accept.
DialectArcs limitsOf(const DialectArcs& dialect, const ArcRules& machine) {
    DialectArcs limits = dialect;
    limits.largestSweep = std::min(dialect.largestSweep, machine.largestSweep * 180.0 / pi);
    limits.smallestRadius = std::max(dialect.smallestRadius, machine.smallestRadius);
    limits.largestRadius = std::min(dialect.largestRadius, machine.largestRadius);
    limits.largestMismatch = std::min(dialect.largestMismatch, machine.radiusMismatch);
    return limits;
}

/// Writes a program in a dialect and tracks the modes in force.
class ProgramWriter {
public:
    ProgramWriter(const DialectData& dialect, const NcProgram& program, const MachineProfile& machine, LineSink& sink)
        : dialect_(dialect)
        , program_(program)
        , numbers_(dialect, program.units, machine.coordinateDecimals)
        , writer_(dialect, std::max(3, std::min(dialect.lineLength, machine.maximumLineLength)), sink)
        , arcs_(limitsOf(dialect.arcs, machine.arcs))
        , clearHeight_(std::max(program.safeHeight, machine.toolChangeHeight))
        , home_(machine.home)
        , rotary_(rotaryAxesOf(dialect, machine))
        , coolantFirst_(switchesCoolantFirst(dialect)) {}

    Result<void> write(Progress& progress) {
        if (Result<void> fits = check(); !fits) return fits;
        section_ = &program_.sections.front();
        if (Result<void> done = blocks(dialect_.begin); !done) return done;
        for (const NcSection& section : program_.sections) {
            section_ = &section;
            if (Result<void> done = writeSection(progress); !done) return done;
        }
        return blocks(dialect_.end);
    }

private:
    /// Where a block goes, mm; empty: the axis does not move.
    using Target = std::array<std::optional<double>, 3>;
    static Target targetOf(const glm::dvec3& place) { return Target{place.x, place.y, place.z}; }
    static Target height(double z) { return Target{std::nullopt, std::nullopt, z}; }

    Result<void> check() const {
        if (program_.sections.empty()) return Error{ErrorCode::pathEmpty, program_.name, "", ""};
        if (program_.sections.size() > 1 && !dialect_.changesTools) {
            const int first = program_.sections.front().toolNumber;
            if (std::ranges::any_of(program_.sections, [&](const NcSection& one) { return one.toolNumber != first; }))
                return Error{ErrorCode::notSupported, "a tool change for " + dialect_.name, "one program a tool", ""};
        }
        for (const NcSection& section : program_.sections) {
            if (section.moves.empty() || section.moves.front().kind != NcMoveKind::rapid)
                return Error{ErrorCode::argumentInvalid, "program", program_.name, "has to begin with a rapid move"};
            if (!hasCoolants(section))
                return Error{ErrorCode::notSupported, "this coolant for " + dialect_.name, "", ""};
            if (!std::ranges::all_of(section.moves, [this](const NcMove& move) { return hasWordsFor(move.target); }))
                return Error{ErrorCode::notSupported, "axes other than X, Y and Z", "", ""};
        }
        return {};
    }

    /// The rotary axes of the machine, if the control reads words for them.
    static AxisSet rotaryAxesOf(const DialectData& dialect, const MachineProfile& machine) {
        AxisSet rotary;
        const Control* const control = findControl(dialect.control);
        if (control == nullptr || !control->rotaryWords) return rotary;
        for (const Axis axis : machine.axes()) rotary.set(axis, isRotary(axis));
        return rotary;
    }
    bool hasWordsFor(const AxisValues& values) const {
        return std::ranges::all_of(axisLetters, [&](char letter) {
            const Axis axis = *axisOfLetter(letter);
            return linearAxes.has(axis) || rotary_.has(axis) || values[axis] == 0.0;
        });
    }

    bool hasCoolants(const NcSection& section) const {
        const auto has = [&](Coolant coolant) { return dialect_.coolant[indexOf(coolant)].has_value(); };
        return has(section.coolant) && std::ranges::all_of(section.moves, [&](const NcMove& move) {
                   return has(move.coolant.value_or(Coolant::off));
               });
    }

    Result<void> writeSection(Progress& progress) {
        speed_ = section_->spindleSpeed;
        coolant_ = section_->coolant;
        coolantOn_ = false;
        if (Result<void> done = blocks(dialect_.toolChange); !done) return done;
        const std::vector<NcMove> moves = withoutRoundedBackSteps(section_->moves, numbers_);
        place_ = {};
        turned_ = {};
        feed_ = 0; // each tool states its own feed
        if (Result<void> done = firstMove(moves.front()); !done) return done;
        for (std::size_t i = 1; i < moves.size(); ++i) {
            if (i % 1024 == 0) {
                if (progress.cancelled()) return Error{ErrorCode::cancelled, program_.name, "", ""};
                progress.report(static_cast<double>(i) / static_cast<double>(moves.size()));
            }
            if (Result<void> done = move(moves[i]); !done) return done;
        }
        if (Result<void> done = straight(NcMoveKind::rapid, height(clearHeight_), 0.0); !done) return done;
        if (Result<void> done = plane(2); !done) return done;
        if (Result<void> done = blocks(dialect_.toolEnd); !done || !home_) return done;
        return blocks(dialect_.home);
    }

    /// The position of the tool after its change is not known here: moves along Z first, unless the change leaves it at
    /// the top.
    Result<void> firstMove(const NcMove& move) {
        waiting_ = move.comment;
        const Target across{move.target[Axis::x], move.target[Axis::y], std::nullopt};
        motion_.reset();
        if (dialect_.planeBeforeHeight) {
            if (Result<void> done = straight(NcMoveKind::rapid, across, 0.0, &move.target); !done) return done;
        }
        if (Result<void> done = firstHeight(); !done) return done;
        for (const Target& step : {across, height(move.target[Axis::z])})
            if (Result<void> done = straight(NcMoveKind::rapid, step, 0.0, &move.target); !done) return done;
        return {};
    }

    Result<void> firstHeight() {
        if (Result<void> done = writeWaiting(); !done) return done;
        const long long steps = numbers_.stepsOf(clearHeight_);
        const Result<std::string> text =
            BlockWriter::filled(dialect_.firstHeight, [&](std::string_view word) -> Result<std::string> {
                if (word == "rapid") return motion_ == dialect_.rapid ? std::string() : dialect_.rapid;
                if (word == "clear") return "Z" + numbers_.coordinate(steps);
                return valueOf(word);
            });
        if (!text) return text.error();
        motion_ = dialect_.rapid;
        place_[2] = steps;
        return writer_.block(*text);
    }

    Result<void> move(const NcMove& move) {
        if (Result<void> done = changeState(move); !done) return done;
        if (!move.comment.empty()) waiting_ = move.comment;
        if (move.kind == NcMoveKind::dwell) return dwell(move.seconds);
        if (move.kind == NcMoveKind::arc) return arc(move);
        return straight(move.kind, targetOf(move.target.linear()), move.feed, &move.target);
    }

    /// Changes spindle speed and coolant, in the order of the tool change.
    Result<void> changeState(const NcMove& before) {
        if (coolantFirst_)
            if (Result<void> done = changeCoolant(before); !done) return done;
        if (Result<void> done = changeSpeed(before); !done) return done;
        return coolantFirst_ ? Result<void>() : changeCoolant(before);
    }

    /// Whether the dialect's tool change switches the coolant on before it starts the spindle.
    static bool switchesCoolantFirst(const DialectData& dialect) {
        for (const std::string& block : dialect.toolChange) {
            const std::size_t spindle = block.find("{spindle}"), coolant = block.find("{coolant}");
            if (spindle != coolant) return coolant < spindle;
        }
        return false;
    }

    Result<void> changeCoolant(const NcMove& before) {
        if (!before.coolant || *before.coolant == coolant_) return {};
        if (Result<void> done = writeWaiting(); !done) return done;
        coolantOn_ = coolant_ != Coolant::off;
        coolant_ = *before.coolant;
        return blocks(dialect_.coolantChange);
    }

    Result<void> changeSpeed(const NcMove& before) {
        if (!(before.spindleSpeed > 0.0) || before.spindleSpeed == speed_) return {};
        speed_ = before.spindleSpeed;
        if (Result<void> done = writeWaiting(); !done) return done;
        if (Result<void> done = blocks(dialect_.speedChange); !done) return done;
        return before.kind == NcMoveKind::rapid ? blocks({"{start_dwell}"}) : Result<void>();
    }

    Result<void> dwell(double seconds) {
        if (!(seconds >= 0.0 && seconds <= 1e5)) return Error{ErrorCode::programLimit, "dwell", "not a time", ""};
        if (Result<void> done = writeWaiting(); !done) return done;
        return writer_.block(dwellWords(seconds));
    }

    std::string dwellWords(double seconds) const {
        const auto valueOf = [&](std::string_view word) -> Result<std::string> {
            return word == "seconds" ? NumberWords::plain(seconds, 3) : NumberWords::plain(seconds * 1000.0, 0);
        };
        return *BlockWriter::filled(dialect_.dwell, valueOf);
    }

    Result<StepPlace> stepsOf(const Target& target) const {
        StepPlace steps{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (target[axis] && !(std::abs(*target[axis]) <= largestCoordinate))
                return Error{ErrorCode::programLimit, std::string(1, axisLetters[axis]),
                             "coordinate is not a valid position", ""};
            steps[axis] = target[axis] ? numbers_.stepsOf(*target[axis]) : place_[axis].value_or(0);
        }
        return steps;
    }

    /// @param rotary values of the rotary axes at the end; null: they stay
    Result<void> straight(NcMoveKind kind, const Target& target, double feed, const AxisValues* rotary = nullptr) {
        const Result<StepPlace> steps = stepsOf(target);
        if (!steps) return steps.error();
        std::array<bool, 3> named{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            named[axis] = target[axis].has_value();
            if (target[axis]) reached_[static_cast<int>(axis)] = *target[axis];
        }
        return line(kind, *steps, named, feed, rotary);
    }

    /// The words of the rotary axes that turn.
    Result<std::string> rotaryWords(const AxisValues& values) {
        std::string words;
        for (const Axis axis : rotary_) {
            if (!(std::abs(values[axis]) <= largestCoordinate))
                return Error{ErrorCode::programLimit, std::string(1, letterOf(axis)),
                             "coordinate is not a valid position", ""};
            const long long steps = std::llround(values[axis] * std::pow(10.0, rotaryDecimals));
            if (turned_[axis] == steps) continue;
            turned_[axis] = steps;
            words += " " + std::string(1, letterOf(axis)) + NumberWords::plain(values[axis], rotaryDecimals);
        }
        return words;
    }

    /// Writes the words that change something. A block whose rounded position equals the previous one is left out; its
    /// comment is kept for the next block.
    Result<void> line(NcMoveKind kind, const StepPlace& to, const std::array<bool, 3>& named, double feed,
                      const AxisValues* rotary = nullptr) {
        std::string words;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!named[axis] || place_[axis] == to[axis]) continue;
            place_[axis] = to[axis];
            words += (words.empty() ? "" : " ") + std::string(1, axisLetters[axis]) + numbers_.coordinate(to[axis]);
        }
        if (rotary != nullptr) {
            Result<std::string> turns = rotaryWords(*rotary);
            if (!turns) return std::move(turns).error();
            if (words.empty()) {
                turns->erase(0, std::min<std::size_t>(1, turns->size())); // the blank
                feed *= numbers_.unit();                                  // degrees/min, whatever the unit of lengths
            }
            words += *turns;
        }
        if (words.empty()) return {};
        return finish(kind == NcMoveKind::rapid ? dialect_.rapid : dialect_.line, std::move(words),
                      kind == NcMoveKind::rapid ? std::nullopt : std::optional<double>(feed));
    }

    Result<void> arc(const NcMove& move) {
        const Arc arc{reached_, move.target.linear(), move.arc.centre, move.arc.axis, move.arc.clockwise};
        StepPlace from{};
        for (std::size_t axis = 0; axis < 3; ++axis) from[axis] = place_[axis].value_or(0);
        if (const Result<StepPlace> sound = stepsOf(targetOf(arc.to)); !sound) return sound.error();
        const double reach = glm::length(arc.centre - arc.from);
        if (!(reach <= largestCoordinate))
            return Error{ErrorCode::programLimit, "arc", "centre is not a valid position", ""};
        for (const StepMove& step : arcSteps(arc, from, numbers_, arcs_)) {
            Result<void> done = step.arc ? arcBlock(step, arc, move.feed)
                                         : line(NcMoveKind::line, step.to, {true, true, true}, move.feed);
            if (!done) return done;
        }
        reached_ = arc.to;
        return {};
    }

    /// Writes both coordinates of the plane and both offsets, whether they change or not: every control accepts that.
    Result<void> arcBlock(const StepMove& step, const Arc& arc, double feed) {
        if (Result<void> done = writeWaiting(); !done) return done;
        if (Result<void> done = plane(arc.axis); !done) return done;
        std::string words;
        const auto across = static_cast<std::size_t>(arc.axis);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis == across && place_[axis] == step.to[axis]) continue;
            words +=
                (words.empty() ? "" : " ") + std::string(1, axisLetters[axis]) + numbers_.coordinate(step.to[axis]);
            place_[axis] = step.to[axis];
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis == across) continue;
            words += " " + std::string(1, offsetLetters[axis]) + numbers_.coordinate(step.offset[axis]);
        }
        return finish(arc.clockwise ? dialect_.clockwise : dialect_.anticlockwise, std::move(words), feed);
    }

    Result<void> finish(const std::string& motion, std::string words, std::optional<double> feed) {
        if (motion_ != motion) words.insert(0, motion + " ");
        motion_ = motion;
        if (feed) {
            const long long steps = numbers_.feedStepsOf(*feed);
            if (feed_ != steps) {
                if (steps <= 0 || !std::isfinite(*feed)) return Error{ErrorCode::programLimit, "feed", "missing", ""};
                words += " F" + numbers_.feed(steps);
                feed_ = steps;
            }
        }
        if (Result<void> done = writeWaiting(); !done) return done;
        return writer_.block(words);
    }

    Result<void> plane(int axis) {
        if (plane_ == axis) return {};
        plane_ = axis;
        return writer_.block(dialect_.planes[static_cast<std::size_t>(axis)]);
    }

    Result<void> writeWaiting() {
        if (waiting_.empty()) return {};
        const std::string text = std::move(waiting_);
        waiting_.clear();
        return writer_.comment(text);
    }

    Result<void> blocks(const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            if (text == "{comments}") {
                if (Result<void> done = writer_.comment(program_.name); !done) return done;
                for (const std::string& line : program_.header)
                    if (Result<void> done = writer_.comment(line); !done) return done;
                continue;
            }
            if (text == "{tool_comment}") {
                if (Result<void> done = writer_.comment(section_->toolName); !done) return done;
                continue;
            }
            const auto words = BlockWriter::filled(text, [this](std::string_view word) { return valueOf(word); });
            if (!words) return words.error();
            if (Result<void> done = writer_.block(*words); !done) return done;
        }
        return {};
    }

    Result<std::string> valueOf(std::string_view word) const {
        if (word == "units") return dialect_.units[indexOf(program_.units)];
        if (word == "work_offset") return workOffset();
        if (word == "blend") return blend();
        if (word == "blend_end") return blends() ? dialect_.blendEnd.value_or("") : std::string();
        if (word == "tool") return std::to_string(section_->toolNumber);
        if (word == "tool_2") return (section_->toolNumber < 10 ? "0" : "") + std::to_string(section_->toolNumber);
        if (word == "speed") return NumberWords::plain(speed_, 0);
        if (word == "spindle") return dialect_.spindle[indexOf(section_->direction)];
        if (word == "coolant") return *dialect_.coolant[indexOf(coolant_)];
        if (word == "coolant_off") return coolantOn_ ? dialect_.coolantOff : std::string();
        if (word == "start_dwell")
            return program_.spindleStart > 0.0 ? dwellWords(program_.spindleStart) : std::string();
        if (word == "program_number") return programNumber();
        if (word == "rapid") return dialect_.rapid;
        if (word.starts_with("home_")) return homeWord(static_cast<std::size_t>(word.back() - 'x'));
        return Error{ErrorCode::internalFault, "dialect " + dialect_.id, std::string(word), "no such word"};
    }

    /// An axis letter with its parking position, in the machine's frame.
    Result<std::string> homeWord(std::size_t axis) const {
        Target home{};
        home[axis] = (*home_)[static_cast<int>(axis)];
        const Result<StepPlace> steps = stepsOf(home);
        if (!steps) return steps.error();
        return std::string(1, axisLetters[axis]) + numbers_.coordinate((*steps)[axis]);
    }

    Result<std::string> workOffset() const {
        const int number = program_.workOffset;
        int offset = number;
        std::optional<std::string> words;
        if (number >= 54 && number <= 59) {
            words = dialect_.workOffset;
        } else if (number >= 591 && number <= 593) {
            words = dialect_.workOffset59;
            offset = number - 590;
        } else if (number > firstFurtherOffset && number <= firstFurtherOffset + dialect_.furtherWorkOffsets) {
            words = dialect_.furtherWorkOffset;
            offset = number - firstFurtherOffset;
        }
        if (!words)
            return Error{ErrorCode::notSupported, "work offset " + workOffsetName(number) + " for " + dialect_.name,
                         workOffsets(), ""};
        return BlockWriter::filled(*words,
                                   [&](std::string_view) -> Result<std::string> { return std::to_string(offset); });
    }

    /// The work offsets that the control has.
    std::string workOffsets() const {
        std::string names = workOffsetName(54) + " to " + workOffsetName(59);
        if (dialect_.workOffset59) names += ", " + workOffsetName(591) + " to " + workOffsetName(593);
        if (dialect_.furtherWorkOffset)
            names += ", " + workOffsetName(firstFurtherOffset + 1) + " to " +
                     workOffsetName(firstFurtherOffset + dialect_.furtherWorkOffsets);
        return names;
    }

    bool blends() const { return numbers_.tolerance(program_.blendTolerance) != numbers_.tolerance(0.0); }

    Result<std::string> blend() const {
        if (!blends()) return dialect_.exactStop.value_or("");
        const std::string tolerance = numbers_.tolerance(program_.blendTolerance);
        return BlockWriter::filled(dialect_.blend.value_or(""),
                                   [&](std::string_view) -> Result<std::string> { return tolerance; });
    }

    /// The program's name if it is a number that fits, otherwise 1.
    std::string programNumber() const {
        const auto digits = static_cast<std::size_t>(dialect_.programNumberDigits);
        std::string number = program_.name;
        const bool fits = !number.empty() && number.size() <= digits &&
                          std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }) &&
                          number.find_first_not_of('0') != std::string::npos;
        if (!fits) number = "1";
        number.insert(0, digits - number.size(), '0');
        return number;
    }

    const DialectData& dialect_;
    const NcProgram& program_;
    const NcSection* section_ = nullptr;
    NumberWords numbers_;
    BlockWriter writer_;
    DialectArcs arcs_;
    double clearHeight_;                            // mm
    std::optional<glm::dvec3> home_;                // mm, machine frame
    AxisSet rotary_;                                // that have words
    bool coolantFirst_;                             // whether coolant changes come before speed changes
    double speed_ = 0.0;                            // 1/min, of the spindle
    Coolant coolant_ = Coolant::off;                // in force
    bool coolantOn_ = false;                        // whether coolant was on before the last change
    std::array<std::optional<long long>, 3> place_; // in steps of the last digit; empty: not known
    ByAxis<std::optional<long long>> turned_;       // the same of rotary axes
    glm::dvec3 reached_{0.0};                       // mm, as place_, before rounding
    std::optional<std::string> motion_;
    int plane_ = 2;
    long long feed_ = 0;  // in steps of the feed's last digit
    std::string waiting_; // comment of a block that was left out
};

} // namespace

Result<void> DataPost::write(const NcProgram& program, const MachineProfile& machine, LineSink& sink,
                             Progress& progress) const {
    return ProgramWriter(dialect_, program, machine, sink).write(progress);
}

} // namespace burin
