// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/lint.h"

#include "core/base/numbers.h"
#include "core/nc/interpreter.h"
#include "core/nc/line_reader.h"
#include "core/nc/line_walker.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

class Linter {
public:
    explicit Linter(const LintSubject& subject)
        : subject_(subject)
        , control_(subject.control != nullptr ? *subject.control : defaultControl())
        , interpreter_(control_, start())
        , parameters_(false, [this](int number) { return interpreter_.parameter(number); }) {}

    std::vector<LintMark> run(std::string_view text) {
        LineWalker lines(text);
        bool ended = false;
        while (const std::optional<std::string_view> line = lines.next()) {
            line_ = lines.number();
            content_ = *line;
            if (marks_.size() >= mostMarks) return std::move(marks_);
            BlockFault fault;
            if (!readLine(content_, control_, parameters_, block_, fault)) {
                add(fault);
                continue;
            }
            const LineWalker::Mark mark = lines.mark(block_, control_.tapeMarks);
            if (mark == LineWalker::Mark::misplaced) add({ProgramProblem::percentMisplaced, 1, 1});
            ended = mark == LineWalker::Mark::closes;
            if (ended) break;
            if (!block_.empty()) judge();
            if (interpreter_.atEnd()) break;
        }
        if (!ended && !interpreter_.program.ended && !faultyEnd_)
            add({ProgramProblem::endMissing, 1, 1}, LintSeverity::error);
        return std::move(marks_);
    }

private:
    /// A tool that the operator has loaded and measured; nothing else is known.
    static MachineState start() { return {}; }

    void add(const BlockFault& fault, LintSeverity severity = LintSeverity::error, std::string_view more = {}) {
        LintMark mark;
        mark.line = std::max(line_, 1u);
        mark.column = fault.column;
        mark.length = fault.length > 1 ? fault.length : wordLength(fault.column);
        mark.severity = severity;
        mark.problem = fault.problem;
        mark.text = std::string(wordingOf(fault.problem));
        mark.words = more.empty() ? written(mark) : std::string(more);
        if (!mark.words.empty()) mark.text += ": " + mark.words;
        marks_.push_back(std::move(mark));
    }

    /// The text at the mark; empty if something is missing.
    std::string written(const LintMark& mark) const {
        if (mark.problem == ProgramProblem::endMissing) return {};
        return shownWords(content_, mark.column - 1, mark.length);
    }

    /// Length of the word that begins in a column: its letter and what belongs to its number.
    std::uint32_t wordLength(std::uint32_t column) const {
        std::size_t at = column;
        const auto goesOn = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; };
        while (at < content_.size() && goesOn(content_[at])) ++at;
        return static_cast<std::uint32_t>(std::max<std::size_t>(at - column + 1, 1));
    }

    void judge() {
        beforeRun();
        BlockFault fault;
        const std::size_t marks = marks_.size();
        if (!interpreter_.run(block_, line_, fault)) {
            add(fault);
            // A stop in a faulty block still counts as the end that its author meant.
            const int stop = block_.code(MGroup::stop).number;
            faultyEnd_ = faultyEnd_ || stop == 20 || stop == 300;
        }
        afterRun(marks);
        interpreter_.program.motions.clear();
        interpreter_.program.settings.clear();
    }

    void beforeRun() {
        const Word &feed = block_.word('F'), &speed = block_.word('S');
        if (control_.pointNeeded && feed.given() && !feed.point)
            add({ProgramProblem::feedPointMissing, feed.column, 1}, LintSeverity::warning);
        if (block_.code(GGroup::units).given()) unitsStated_ = true;
        if (block_.code(GGroup::arcDistance).given()) arcModeStated_ = true;
        if (block_.code(GGroup::workOffset).given()) workOffsetStated_ = true;
        if (block_.code(GGroup::lengthOffset).given()) lengthStated_ = true;
        if (block_.code(MGroup::toolChange).given()) lengthStated_ = !control_.readsG(gcode::lengthOffset);
        const MachineProfile* machine = subject_.machine;
        if (machine != nullptr && speed.given() && speed.value > 0.0 &&
            (speed.value > machine->maximumSpindleSpeed || speed.value < machine->minimumSpindleSpeed))
            add({ProgramProblem::spindleBeyondMachine, speed.column, 1}, LintSeverity::error,
                formatFixed(machine->minimumSpindleSpeed, 0) + " to " + formatFixed(machine->maximumSpindleSpeed, 0) +
                    " 1/min");
    }

    /// Reports a problem once for the whole program.
    void once(bool& said, ProgramProblem problem, std::uint32_t column, LintSeverity severity) {
        if (!said) add({problem, column, 1}, severity);
        said = true;
    }

    void afterRun(std::size_t marksBefore) {
        for (const NcMotion& motion : interpreter_.program.motions) {
            if (motion.kind == NcMotionKind::dwell) continue;
            const auto column = motion.column;
            once(unitsStated_, ProgramProblem::unitsMissing, column, LintSeverity::warning);
            if (motion.takesAny())
                once(workOffsetStated_, ProgramProblem::workOffsetMissing, column, LintSeverity::warning);
            if (motion.kind == NcMotionKind::arc && control_.arcModeIsSetting)
                once(arcModeStated_, ProgramProblem::arcModeMissing, column, LintSeverity::warning);
            if (motion.takes(Axis::z))
                once(lengthStated_, ProgramProblem::lengthOffsetMissing, column, LintSeverity::warning);
            if (motion.rapid() || marks_.size() > marksBefore) continue; // one mark per block is enough
            judgeFeed(motion);
        }
    }

    void judgeFeed(const NcMotion& motion) {
        const MachineProfile* machine = subject_.machine;
        if (machine != nullptr && motion.feed > machine->maximumFeed)
            add({ProgramProblem::feedAboveMachine, motion.column, 1}, LintSeverity::error,
                formatFixed(machine->maximumFeed, 0) + " mm/min");
    }

    const LintSubject& subject_;
    const Control& control_;
    Interpreter interpreter_;
    Parameters parameters_;
    Block block_;
    std::string_view content_;
    std::uint32_t line_ = 0;
    std::vector<LintMark> marks_;
    bool unitsStated_ = false, arcModeStated_ = false, workOffsetStated_ = false;
    bool lengthStated_ = true; // until a tool change requires it
    bool faultyEnd_ = false;
};

} // namespace

std::vector<LintMark> lint(std::string_view text, const LintSubject& subject) {
    return Linter(subject).run(text);
}

} // namespace burin
