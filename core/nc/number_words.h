// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect_data.h"
#include "core/nc/program.h"

#include <string>

namespace burin {

/// Formats the numbers of a program as a dialect requires. Coordinates are rounded once, to whole steps of the last
/// digit, and everything else is computed from these steps: what is compared, repeated or omitted is what the control
/// reads.
class NumberWords {
public:
    /// @param mostDecimals of the machine, in millimetres; one more in inches
    NumberWords(const DialectData& dialect, NcUnits units, int mostDecimals);

    double unit() const noexcept { return unit_; } ///< mm
    double step() const noexcept { return step_; } ///< mm
    long long stepsOf(double millimetres) const noexcept;
    double millimetresOf(long long steps) const noexcept { return static_cast<double>(steps) * step_; }
    std::string coordinate(long long steps) const;
    long long feedStepsOf(double millimetresPerMinute) const noexcept;
    std::string feed(long long steps) const; ///< without trailing zeros
    /// A length, without trailing zeros; up to one decimal more than coordinates have.
    std::string tolerance(double millimetres) const;
    /// A number without unit, without trailing zeros.
    static std::string plain(double value, int decimals);

private:
    std::string text(long long steps, int decimals, bool keepZeros) const;

    const DialectData& dialect_;
    double unit_; ///< mm
    int decimals_, feedDecimals_;
    double step_;
};

} // namespace burin
