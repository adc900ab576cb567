// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/block.h"
#include "core/nc/control.h"
#include "core/nc/expression_operator.h"
#include "core/nc/parameters.h"

#include <string>
#include <string_view>

namespace burin {

inline constexpr double largestNumber = 1e7; ///< beyond any machine; keeps sums and counts of chords finite

/// Reads numbers, parameters and expressions of NIST RS274/NGC (IR 6556, 3.3.2) from a line: [ ], # and #<>, signs, **
/// * / MOD + - AND OR XOR, comparisons EQ NE GT GE LT LE (LinuxCNC), and the functions ABS ACOS ASIN ATAN[]/[] COS
/// EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN, angles in degrees. Precedence is that of LinuxCNC: **, then * / MOD, then
/// + -, then comparisons, then AND OR XOR; in the report AND OR XOR have the same precedence as + and -. Operators of
/// equal precedence are evaluated from left to right. Blanks may occur anywhere except inside names, and inside numbers
/// where the control allows it. Numbers are never infinite.
class ExpressionReader {
public:
    ExpressionReader(std::string_view line, const Control& control, Parameters& parameters, BlockFault& fault) noexcept
        : line_(line), control_(control), parameters_(parameters), fault_(fault) {}

    /// Reads a number, parameter, expression or function at `at`, and moves `at` past it.
    /// @param word position of the word that it belongs to, for messages
    /// @param point set to true unless it was written as a number without a decimal point
    bool value(std::size_t word, std::size_t& at, double& value, bool& point);
    /// Reads an assignment #n=… or #<name>=… at `at`.
    bool assignment(std::size_t& at);

private:
    bool fail(ProgramProblem problem, std::size_t from, std::size_t to = 0) noexcept;
    void skipBlanks(std::size_t& at) const noexcept;
    bool beginsNumber(std::size_t at) const noexcept;
    std::size_t behindBlanks(std::size_t at) const noexcept;
    bool number(std::size_t word, std::size_t& at, double& value, bool& point);
    bool general(std::size_t word, std::size_t& at, double& value);
    bool bracket(std::size_t& at, double& value);
    bool function(std::size_t& at, double& value);
    bool arcTangent(std::size_t& at, double& value);
    bool exists(std::size_t& at, double& value);
    bool parameter(std::size_t& at, double& value);
    bool parameterNumber(std::size_t& at, int& number);
    bool parameterName(std::size_t& at, std::string& name);
    bool readOperator(std::size_t& at, ExpressionOperator& found) noexcept;
    bool keyword(std::size_t& at, std::string_view word) const noexcept;
    bool finite(double value, std::size_t at);

    std::string_view line_;
    const Control& control_;
    Parameters& parameters_;
    BlockFault& fault_;
    int depth_ = 0;
};

} // namespace burin
