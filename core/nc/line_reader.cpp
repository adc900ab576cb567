// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/line_reader.h"

#include "core/nc/canned_cycles.h"
#include "core/nc/expression.h"
#include "core/nc/letter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

bool isSpaceOrTab(char c) noexcept {
    return c == ' ' || c == '\t';
}

/// Parses one line.
class LineReader {
public:
    LineReader(std::string_view line, const Control& control, Parameters& parameters, Block& block, BlockFault& fault)
        : line_(line), control_(control), values_(line, control, parameters, fault), block_(block), fault_(fault) {}

    bool read() {
        if (!measure() || !skip()) return false;
        if (atEnd()) return true;
        if (line_[at_] == '%') return tapeMark();
        if (line_[at_] == '/') {
            ++at_;
            if (!skip()) return false;
        }
        while (!atEnd()) {
            if (!(line_[at_] == '#' ? values_.assignment(at_) : word()) || !skip()) return false;
        }
        return true;
    }

private:
    bool atEnd() const noexcept { return at_ >= line_.size(); }

    bool fail(ProgramProblem problem, std::size_t from) noexcept {
        fault_ = {problem, static_cast<std::uint32_t>(from + 1),
                  static_cast<std::uint32_t>(at_ > from ? at_ - from : 1)};
        return false;
    }

    /// Checks the length against the control's buffer. What is not counted is only known after a scan, so short lines
    /// are accepted first.
    bool measure() {
        const auto limit = static_cast<std::size_t>(control_.lineLength);
        if (line_.size() <= limit) return true;
        if (control_.lengthCountsWordsAlone) {
            std::size_t count = 0;
            bool comment = false;
            for (const char c : line_) {
                if (c == ';' && !comment) break;
                if (c == '(') comment = true;
                if (!comment && !isSpaceOrTab(c) && c != '/') ++count;
                if (c == ')') comment = false;
            }
            if (count <= limit) return true;
        }
        at_ = line_.size();
        return fail(ProgramProblem::lineTooLong, limit);
    }

    /// Skips blanks and comments.
    bool skip() noexcept {
        while (!atEnd()) {
            const char c = line_[at_];
            if (isSpaceOrTab(c) || (c == '/' && control_.slashIsDropped)) {
                ++at_;
            } else if (c == ';' && control_.semicolonComments) {
                at_ = line_.size();
            } else if (c == '(') {
                const std::size_t close = line_.find_first_of("()", at_ + 1);
                if (close == std::string_view::npos) return fail(ProgramProblem::commentNotClosed, at_);
                if (line_[close] == '(') {
                    at_ = close;
                    return fail(ProgramProblem::commentNested, close);
                }
                at_ = close + 1;
            } else {
                return true;
            }
        }
        return true;
    }

    bool tapeMark() noexcept {
        if (control_.tapeMarks == TapeMarks::none) return fail(ProgramProblem::percentNotRead, at_);
        block_.percent = true;
        ++at_;
        if (control_.tapeMarks == TapeMarks::paired)
            while (!atEnd() && isSpaceOrTab(line_[at_])) ++at_;
        else if (!skip())
            return false;
        return atEnd() || fail(ProgramProblem::percentNotAlone, at_);
    }

    bool word() {
        const std::size_t start = at_;
        const char letter = upperLetter(line_[at_]);
        if (letter < 'A' || letter > 'Z') return fail(ProgramProblem::characterNotAllowed, start);
        ++at_;
        const bool code = letter == 'G' || letter == 'M';
        if (letter == 'O' && !control_.programNumbers) return fail(ProgramProblem::subprogram, start);
        if (!code && letter != 'N' && control_.letters.find(letter) == std::string_view::npos)
            return fail(saysFlow(start) ? ProgramProblem::subprogram : ProgramProblem::wordNotRead, start);
        Word read;
        read.column = static_cast<std::uint32_t>(start + 1);
        if (!values_.value(start, at_, read.value, read.point))
            return saysFlow(start) ? fail(ProgramProblem::subprogram, start) : false;
        const bool first = block_.firstColumn == 0;
        if (first) block_.firstColumn = read.column;
        if (letter == 'N') return first || fail(ProgramProblem::lineNumberNotFirst, start);
        if (code) return this->code(letter, start, read.value);
        Word& place = block_.words[static_cast<std::size_t>(letter - 'A')];
        if (place.given()) return fail(ProgramProblem::wordTwice, start);
        place = read;
        return true;
    }

    /// Keywords of the macro languages, which begin like words of a block.
    bool saysFlow(std::size_t at) const noexcept {
        constexpr std::array<std::string_view, 6> words{"IF", "WHILE", "GOTO", "DO", "END", "THEN"};
        return std::ranges::any_of(words, [&](std::string_view word) {
            return std::ranges::equal(line_.substr(at, word.size()), word, {}, upperLetter);
        });
    }

    bool code(char letter, std::size_t start, double value) noexcept {
        const double tenfold = value * 10.0;
        const int number = std::abs(tenfold) < 1e5 ? static_cast<int>(std::lround(tenfold)) : -1;
        const bool exact = std::abs(tenfold - number) < 1e-6;
        if (!exact || !(letter == 'G' ? control_.readsG(number) : control_.readsM(number)))
            return fail(ProgramProblem::codeNotRead, start);
        const auto index = static_cast<std::size_t>(number);
        Code& place = letter == 'G' ? block_.g[static_cast<std::size_t>(control_.gGroups[index])]
                                    : block_.m[static_cast<std::size_t>(control_.mGroups[index])];
        if (letter == 'M' && ++mWords_ > control_.mostMWords && control_.mostMWords > 0)
            return fail(ProgramProblem::tooManyMWords, start);
        const Code read{number, static_cast<std::uint32_t>(start + 1)};
        if (letter == 'G' && place.given() && &place == &block_.g[static_cast<std::size_t>(GGroup::motion)])
            return secondMotion(place, read);
        if (place.given()) return fail(ProgramProblem::codesOfOneGroup, start);
        place = read;
        return true;
    }

    /// Two words of the motion group, one of which is G80: many programs begin with "G0 … G80 G90".
    bool secondMotion(Code& place, const Code& read) noexcept {
        const Code& motion = read.number == gcode::noMotion ? place : read;
        const bool cancels = read.number == gcode::noMotion || place.number == gcode::noMotion;
        const bool apart =
            control_.cycleCancel == CycleCancel::withMotion ||
            (control_.cycleCancel == CycleCancel::restoresMotion && !CannedCycles::isCycle(motion.number));
        if (!cancels || !apart) return fail(ProgramProblem::codesOfOneGroup, read.column - 1);
        place = motion;
        return true;
    }

    std::string_view line_;
    const Control& control_;
    ExpressionReader values_;
    Block& block_;
    BlockFault& fault_;
    std::size_t at_ = 0;
    int mWords_ = 0;
};

} // namespace

bool readLine(std::string_view line, const Control& control, Parameters& parameters, Block& block, BlockFault& fault) {
    block = Block{};
    if (!LineReader(line, control, parameters, block, fault).read()) {
        parameters.discard();
        return false;
    }
    parameters.commit();
    return true;
}

} // namespace burin
