// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect_data.h"
#include "core/nc/program.h"

#include <string>

namespace burin {

/// Writes a program's numbers as a dialect wants them. Coordinates are rounded once, to whole steps of the last digit,
/// and everything else is worked out from these steps: what is compared, repeated or left out is what the control
/// reads.
class NumberWords {
public:
    /// @param mostDecimals in millimetres, of the machine; one more in inches
    NumberWords(const DialectData& dialect, NcUnits units, int mostDecimals);

    double step() const noexcept { return step_; } ///< mm
    long long stepsOf(double millimetres) const noexcept;
    double millimetresOf(long long steps) const noexcept { return static_cast<double>(steps) * step_; }
    std::string coordinate(long long steps) const;
    long long feedStepsOf(double millimetresPerMinute) const noexcept;
    std::string feed(long long steps) const; ///< without the zeros at its end
    /// A length, without the zeros at its end; up to one decimal more than coordinates have.
    std::string tolerance(double millimetres) const;
    /// A number without unit, without the zeros at its end.
    static std::string plain(double value, int decimals);

private:
    std::string text(long long steps, int decimals, bool keepZeros) const;

    const DialectData& dialect_;
    double unit_; ///< mm
    int decimals_, feedDecimals_;
    double step_;
};

} // namespace burin
