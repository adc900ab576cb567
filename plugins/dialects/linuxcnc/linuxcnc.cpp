// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// LinuxCNC's dialect of RS274/NGC. Source of every word: linuxcnc.org/docs/html/gcode (G-Codes, M-Codes, Overview).
#include "core/nc/dialect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace burin {
namespace {

constexpr double spindleStartTime = 3.0;  // s; a hobby spindle is at speed by then
constexpr double largestCoordinate = 1e6; // mm; keeps the rounded integers far from overflow
constexpr int feedDecimals = 1;
constexpr int largestLineLength = 255; // LINELEN of the interpreter, without its end

/// `steps` units of the last digit as text: 12345 with three decimals is "12.345".
std::string fixedText(long long steps, int decimals) {
    std::string digits = std::to_string(std::llabs(steps));
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, 1, '.');
    return steps < 0 ? "-" + digits : digits;
}

long long roundedSteps(double value, int decimals) {
    return std::llround(value * std::pow(10.0, decimals));
}

/// Without the zeros at its end: "1200", "0.005".
std::string trimmedText(double value, int decimals) {
    std::string text = fixedText(roundedSteps(value, decimals), decimals);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// What may stand between ( and ): printable ASCII without brackets, one ? for every other character. A first word
/// with a comma, as in (MSG, …) or (DEBUG, …), would be an order to the control: its comma becomes a colon.
std::string commentText(std::string_view text) {
    std::string clean;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 && byte < 0xC0) continue; // the rest of a UTF-8 character
        clean += c == '(' ? '[' : c == ')' ? ']' : byte < 0x20 || byte > 0x7E ? '?' : c;
    }
    const std::size_t comma = clean.find(',');
    const bool isOrder = comma != std::string::npos &&
                         std::all_of(clean.begin(), clean.begin() + static_cast<std::ptrdiff_t>(comma), [](char c) {
                             return c == ' ' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
                         });
    if (isOrder) clean[comma] = ':';
    return clean;
}

/// Words a program and keeps what is in force while it does.
class Writer {
public:
    Writer(const NcProgram& program, const MachineProfile& machine, LineSink& sink)
        : program_(program)
        , sink_(sink)
        , decimals_(machine.coordinateDecimals)
        , lineLength_(std::clamp(machine.maximumLineLength, 3, largestLineLength))
        , clearHeight_(std::max(program.safeHeight, machine.toolChangeHeight)) {}

    Result<void> write(Progress& progress) {
        if (decimals_ < 1 || decimals_ > 6)
            return Error{ErrorCode::notSupported, std::to_string(decimals_) + " decimals", "1 to 6 decimals", ""};
        if (Result<void> done = preamble(); !done) return done;
        for (std::size_t i = 0; i < program_.moves.size(); ++i) {
            if (i % 1024 == 0) {
                if (progress.cancelled()) return Error{ErrorCode::cancelled, program_.name, "", ""};
                progress.report(static_cast<double>(i) / static_cast<double>(program_.moves.size()));
            }
            if (Result<void> done = i == 0 ? firstMove(program_.moves[i]) : move(program_.moves[i]); !done) return done;
        }
        return ending();
    }

private:
    /// Where a block goes, mm; nothing: the axis stays.
    using Target = std::array<std::optional<double>, 3>;
    static Target height(double z) { return Target{std::nullopt, std::nullopt, z}; }

    Result<void> lines(std::initializer_list<std::string> texts) {
        for (const std::string& text : texts) {
            if (Result<void> done = sink_.line(text); !done) return done;
        }
        return {};
    }

    /// One comment, on as many lines as it needs.
    Result<void> comment(std::string_view text) {
        std::string clean = commentText(text);
        const auto width = static_cast<std::size_t>(lineLength_ - 2);
        do {
            if (Result<void> done = sink_.line("(" + clean.substr(0, width) + ")"); !done) return done;
            clean.erase(0, width);
        } while (!clean.empty());
        return {};
    }

    Result<void> preamble() {
        if (Result<void> done = comment(program_.name); !done) return done;
        for (const std::string& text : program_.header) {
            if (Result<void> done = comment(text); !done) return done;
        }
        const std::string tool = std::to_string(program_.toolNumber);
        const std::string tolerance = trimmedText(program_.blendTolerance, 4);
        if (Result<void> done =
                lines({"G17 G21 G40 G49", "G" + std::to_string(program_.workOffset) + " G80 G90 G91.1 G94",
                       tolerance == "0" ? "G61" : "G64 P" + tolerance + " Q" + tolerance});
            !done)
            return done;
        if (Result<void> done = comment(program_.toolName); !done) return done;
        if (Result<void> done =
                lines({"T" + tool + " M6", "G43 H" + tool, "S" + trimmedText(program_.spindleSpeed, 0) + " M3",
                       "G4 P" + trimmedText(spindleStartTime, 1)});
            !done)
            return done;
        if (program_.coolant) return lines({"M8"});
        return {};
    }

    /// Up, across, and only then down: where the tool stands after its change is not known here.
    Result<void> firstMove(const NcMove& move) {
        if (move.kind != NcMoveKind::rapid)
            return Error{ErrorCode::argumentInvalid, "program", program_.name, "has to begin with a rapid move"};
        const glm::dvec3& target = move.target;
        if (Result<void> done = comment(move); !done) return done;
        for (const Target& step : {height(clearHeight_), Target{target.x, target.y, std::nullopt}, height(target.z)}) {
            if (Result<void> done = block(NcMoveKind::rapid, step, 0.0, nullptr); !done) return done;
        }
        return {};
    }

    Result<void> move(const NcMove& move) {
        return block(move.kind, Target{move.target.x, move.target.y, move.target.z}, move.feed, &move);
    }

    Result<void> comment(const NcMove& move) {
        return move.comment.empty() ? Result<void>{} : comment(std::string_view(move.comment));
    }

    /// Writes the words that change something. A block that rounding makes equal to the place before is left out; its
    /// comment waits for the next one.
    Result<void> block(NcMoveKind kind, const Target& target, double feed, const NcMove* source) {
        if (source != nullptr && !source->comment.empty()) waiting_ = source->comment;
        static constexpr std::array<char, 3> letters{'X', 'Y', 'Z'};
        std::string words;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!target[axis]) continue;
            if (!(std::abs(*target[axis]) <= largestCoordinate))
                return Error{ErrorCode::programLimit, std::string(1, letters[axis]), "coordinate is not a place", ""};
            const long long steps = roundedSteps(*target[axis], decimals_);
            if (place_[axis] == steps) continue;
            place_[axis] = steps;
            words += (words.empty() ? "" : " ") + std::string(1, letters[axis]) + fixedText(steps, decimals_);
        }
        if (words.empty()) return {};
        if (motion_ != kind) words.insert(0, kind == NcMoveKind::rapid ? "G0 " : "G1 ");
        motion_ = kind;
        const long long feedSteps = roundedSteps(feed, feedDecimals);
        if (kind == NcMoveKind::line && feed_ != feedSteps) {
            if (feedSteps <= 0) return Error{ErrorCode::programLimit, "feed", "missing", ""};
            words += " F" + trimmedText(feed, feedDecimals);
            feed_ = feedSteps;
        }
        if (!waiting_.empty()) {
            if (Result<void> done = comment(std::string_view(waiting_)); !done) return done;
            waiting_.clear();
        }
        return sink_.line(words);
    }

    Result<void> ending() {
        if (Result<void> done = block(NcMoveKind::rapid, height(clearHeight_), 0.0, nullptr); !done) return done;
        return lines({"M5", "M9", "M2"});
    }

    const NcProgram& program_;
    LineSink& sink_;
    int decimals_;
    int lineLength_;
    double clearHeight_;                            // mm
    std::array<std::optional<long long>, 3> place_; // in steps of the last digit; nothing: not known
    std::optional<NcMoveKind> motion_;
    long long feed_ = 0;  // in steps of the feed's last digit
    std::string waiting_; // comment of a block that was left out
};

class LinuxCnc final : public PostProcessor {
public:
    Result<void> write(const NcProgram& program, const MachineProfile& machine, LineSink& sink,
                       Progress& progress) const override {
        return Writer(program, machine, sink).write(progress);
    }
};

} // namespace
} // namespace burin

extern "C" [[gnu::visibility("default")]] burin::PostProcessor* burinCreatePostProcessor() {
    return new burin::LinuxCnc();
}
