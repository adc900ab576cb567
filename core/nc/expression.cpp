// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/expression.h"

#include "core/base/units.h"
#include "core/nc/letter.h"

#include <charconv>
#include <cmath>

namespace burin {
namespace {

constexpr int deepestNesting = 64;
constexpr double largestResult = 1e15;  // limit for parts of an expression
constexpr double wholeTolerance = 1e-4; // as LinuxCNC's for parameter numbers
constexpr double degree = pi / 180.0;

bool isBlank(char c) noexcept {
    return c == ' ' || c == '\t';
}
bool isDigit(char c) noexcept {
    return c >= '0' && c <= '9';
}
using Function = double (*)(double);
struct NamedFunction {
    std::string_view name;
    Function call;
};
// A value outside a function's domain gives a result that is not finite, which the caller reports.
constexpr std::array<NamedFunction, 11> functions{{
    {"ABS", [](double x) { return std::abs(x); }},
    {"ACOS", [](double x) { return std::acos(x) / degree; }},
    {"ASIN", [](double x) { return std::asin(x) / degree; }},
    {"COS", [](double x) { return std::cos(x * degree); }},
    {"EXP", [](double x) { return std::exp(x); }},
    {"FIX", [](double x) { return std::floor(x); }},
    {"FUP", [](double x) { return std::ceil(x); }},
    {"LN", [](double x) { return std::log(x); }},
    {"ROUND", [](double x) { return std::round(x); }},
    {"SIN", [](double x) { return std::sin(x * degree); }},
    {"TAN", [](double x) { return std::tan(x * degree); }},
}};

} // namespace

bool ExpressionReader::fail(ProgramProblem problem, std::size_t from, std::size_t to) noexcept {
    fault_ = {problem, static_cast<std::uint32_t>(from + 1), static_cast<std::uint32_t>(to > from ? to - from : 1)};
    return false;
}

void ExpressionReader::skipBlanks(std::size_t& at) const noexcept {
    while (at < line_.size() && isBlank(line_[at])) ++at;
}

bool ExpressionReader::keyword(std::size_t& at, std::string_view word) const noexcept {
    if (line_.size() - at < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (upperLetter(line_[at + i]) != word[i]) return false;
    at += word.size();
    return true;
}

bool ExpressionReader::finite(double value, std::size_t at) {
    return std::abs(value) <= largestResult || fail(ProgramProblem::expressionUndefined, at);
}

bool ExpressionReader::value(std::size_t word, std::size_t& at, double& value, bool& point) {
    skipBlanks(at);
    if (beginsNumber(at)) return number(word, at, value, point);
    point = true;
    if (!general(word, at, value)) return false;
    return std::abs(value) <= largestNumber || fail(ProgramProblem::numberOutOfRange, word, at);
}

bool ExpressionReader::beginsNumber(std::size_t at) const noexcept {
    if (at < line_.size() && (line_[at] == '-' || line_[at] == '+')) at = behindBlanks(at + 1);
    return at < line_.size() && (isDigit(line_[at]) || line_[at] == '.');
}

/// Skips blanks within a number.
std::size_t ExpressionReader::behindBlanks(std::size_t at) const noexcept {
    if (control_.blanksInNumbers) skipBlanks(at);
    return at;
}

/// Decimal number without exponent. Up to 15 digits are exact in the integer and so is the power of ten, hence their
/// quotient is the nearest double (the common, fast case).
bool ExpressionReader::number(std::size_t word, std::size_t& at, double& value, bool& point) {
    bool negative = false;
    if (at < line_.size() && (line_[at] == '-' || line_[at] == '+')) {
        negative = line_[at] == '-';
        at = behindBlanks(at + 1);
    }
    const std::size_t first = at;
    std::uint64_t digits = 0;
    std::size_t count = 0, decimals = 0;
    point = false;
    const auto goesOn = [&](std::size_t place) {
        return place < line_.size() && (isDigit(line_[place]) || (line_[place] == '.' && !point));
    };
    while (goesOn(at)) {
        if (line_[at] == '.') {
            point = true;
        } else {
            if (count < 15) digits = digits * 10 + static_cast<std::uint64_t>(line_[at] - '0');
            ++count;
            if (point) ++decimals;
        }
        ++at;
        if (const std::size_t next = behindBlanks(at); next != at && goesOn(next)) at = next;
    }
    if (count == 0) return fail(ProgramProblem::numberMissing, word, at);
    if (count <= 15) {
        static constexpr std::array<double, 16> powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
        value = static_cast<double>(digits) / powers[decimals];
    } else {
        std::string written(line_.substr(first, at - first));
        std::erase_if(written, isBlank);
        const auto [end, error] =
            std::from_chars(written.data(), written.data() + written.size(), value, std::chars_format::fixed);
        if (error != std::errc{}) return fail(ProgramProblem::numberOutOfRange, word, at);
    }
    if (value > largestNumber) return fail(ProgramProblem::numberOutOfRange, word, at);
    if (negative) value = -value;
    return true;
}

bool ExpressionReader::general(std::size_t word, std::size_t& at, double& value) {
    skipBlanks(at);
    if (at >= line_.size()) return fail(ProgramProblem::numberMissing, word);
    const char c = line_[at];
    bool point = false;
    if (beginsNumber(at)) return number(word, at, value, point);
    const bool letter = upperLetter(c) >= 'A' && upperLetter(c) <= 'Z';
    if (c != '-' && c != '+' && c != '[' && c != '#' && !letter) return fail(ProgramProblem::numberMissing, word, at);
    if (!control_.expressions) {
        // A letter begins the next word: this one lacks its number.
        const bool lacksNumber = letter || c == '-' || c == '+';
        return fail(lacksNumber ? ProgramProblem::numberMissing : ProgramProblem::expressionNotRead,
                    lacksNumber ? word : at);
    }
    if (++depth_ > deepestNesting) return fail(ProgramProblem::expressionInvalid, at);
    bool done = false;
    if (c == '-' || c == '+') {
        ++at;
        // A sign of a number was read with the number: here something else follows.
        done = at < line_.size() && line_[at] != '-' && line_[at] != '+' ? general(word, at, value)
                                                                         : fail(ProgramProblem::numberMissing, word);
        if (c == '-') value = -value;
    } else if (c == '[') {
        done = bracket(at, value);
    } else if (c == '#') {
        done = parameter(at, value);
    } else {
        const std::size_t start = at;
        done = function(at, value);
        if (!done && fault_.problem == ProgramProblem::expressionInvalid && fault_.column == start + 1)
            done = fail(ProgramProblem::numberMissing, word);
    }
    --depth_;
    return done;
}

bool ExpressionReader::readOperator(std::size_t& at, ExpressionOperator& found) noexcept {
    skipBlanks(at);
    const std::optional<SpelledOperator> spelled = operatorAt(line_.substr(at));
    if (!spelled) return fail(ProgramProblem::expressionInvalid, at);
    at += spelled->length;
    found = spelled->by;
    return true;
}

/// Values wait on a stack until they are followed by an operator that does not bind more tightly.
bool ExpressionReader::bracket(std::size_t& at, double& value) {
    static constexpr std::size_t tightest = 6;
    std::array<double, tightest> values{};
    std::array<ExpressionOperator, tightest> waiting{};
    std::size_t count = 0;
    const std::size_t start = at++;
    for (;;) {
        if (!general(start, at, values[count])) return false;
        ExpressionOperator next = ExpressionOperator::close;
        const std::size_t place = at;
        if (!readOperator(at, next)) return false;
        while (count > 0 && precedenceOf(waiting[count - 1]) >= precedenceOf(next)) {
            const std::optional<double> result = combined(waiting[count - 1], values[count - 1], values[count]);
            if (!result) return fail(ProgramProblem::expressionUndefined, place);
            values[--count] = *result;
            if (!finite(values[count], place)) return false;
        }
        if (next == ExpressionOperator::close) break;
        waiting[count++] = next; // precedences strictly increase: never more than there are of them
    }
    value = values[0];
    return true;
}

bool ExpressionReader::function(std::size_t& at, double& value) {
    const std::size_t start = at;
    if (keyword(at, "ATAN")) return arcTangent(at, value);
    if (keyword(at, "EXISTS")) return exists(at, value);
    Function call = nullptr;
    if (keyword(at, "SQRT")) call = [](double x) { return std::sqrt(x); };
    for (const NamedFunction& one : functions)
        if (call == nullptr && keyword(at, one.name)) call = one.call;
    if (call == nullptr) return fail(ProgramProblem::expressionInvalid, start);
    skipBlanks(at);
    if (at >= line_.size() || line_[at] != '[') return fail(ProgramProblem::expressionInvalid, start);
    if (!bracket(at, value)) return false;
    value = call(value);
    return finite(value, start);
}

bool ExpressionReader::arcTangent(std::size_t& at, double& value) {
    const auto opens = [&](char c) {
        skipBlanks(at);
        return (at < line_.size() && line_[at] == c) || fail(ProgramProblem::expressionInvalid, at);
    };
    double rise = 0.0, run = 0.0;
    if (!opens('[') || !bracket(at, rise) || !opens('/')) return false;
    ++at;
    if (!opens('[') || !bracket(at, run)) return false;
    value = std::atan2(rise, run) / degree;
    return true;
}

bool ExpressionReader::exists(std::size_t& at, double& value) {
    const std::size_t start = at;
    skipBlanks(at);
    if (at >= line_.size() || line_[at] != '[') return fail(ProgramProblem::expressionInvalid, start);
    ++at;
    skipBlanks(at);
    std::string name;
    if (at + 1 >= line_.size() || line_[at] != '#' || line_[at + 1] != '<')
        return fail(ProgramProblem::expressionInvalid, at);
    ++at;
    if (!parameterName(at, name)) return false;
    skipBlanks(at);
    if (at >= line_.size() || line_[at] != ']') return fail(ProgramProblem::expressionInvalid, at);
    ++at;
    value = parameters_.value(name) ? 1.0 : 0.0;
    return true;
}

bool ExpressionReader::parameterNumber(std::size_t& at, int& number) {
    const std::size_t start = at;
    double value = 0.0;
    if (!general(start, at, value)) return false;
    const double whole = std::round(value);
    if (std::abs(value - whole) > wholeTolerance || !(whole >= 1.0 && whole < Parameters::count))
        return fail(ProgramProblem::parameterNotAllowed, start, at);
    number = static_cast<int>(whole);
    return true;
}

/// Names are case-insensitive, and blanks in them are ignored.
bool ExpressionReader::parameterName(std::size_t& at, std::string& name) {
    const std::size_t start = at;
    if (!control_.namedParameters) return fail(ProgramProblem::expressionNotRead, start);
    for (++at; at < line_.size() && line_[at] != '>'; ++at)
        if (!isBlank(line_[at])) name += upperLetter(line_[at]);
    if (at >= line_.size() || name.empty()) return fail(ProgramProblem::expressionInvalid, start);
    ++at;
    return true;
}

bool ExpressionReader::parameter(std::size_t& at, double& value) {
    const std::size_t start = at++;
    skipBlanks(at);
    std::optional<double> held;
    if (at < line_.size() && line_[at] == '<') {
        std::string name;
        if (!parameterName(at, name)) return false;
        held = parameters_.value(name);
    } else {
        int number = 0;
        if (!parameterNumber(at, number)) return false;
        held = parameters_.value(number);
    }
    if (!held) return fail(ProgramProblem::parameterUnknown, start, at);
    value = *held;
    return true;
}

bool ExpressionReader::assignment(std::size_t& at) {
    const std::size_t start = at++;
    if (!control_.expressions) return fail(ProgramProblem::expressionNotRead, start);
    skipBlanks(at);
    std::string name;
    int number = 0;
    const bool named = at < line_.size() && line_[at] == '<';
    if (named ? !parameterName(at, name) : !parameterNumber(at, number)) return false;
    if (!named && number >= Parameters::firstOfControl) return fail(ProgramProblem::parameterNotAllowed, start, at);
    skipBlanks(at);
    if (at >= line_.size() || line_[at] != '=') return fail(ProgramProblem::expressionInvalid, at);
    ++at;
    double value = 0.0;
    if (!general(start, at, value)) return false;
    if (named)
        parameters_.setLater(std::move(name), value);
    else
        parameters_.setLater(number, value);
    return true;
}

} // namespace burin
