// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Text of a number with a decimal point, whatever the locale. `decimals` digits behind it, rounded half to even as
/// the C++ library does; "-0.000" becomes "0.000".
std::string formatFixed(double value, int decimals);

/// The same of a limit, which its text never falls short of.
std::string formatLimit(double value, int decimals);

/// Shortest text that reads back as the same double, with a decimal point, whatever the locale.
std::string formatShortest(double value);

/// The number that the whole of `text` writes, or nothing. Never depends on the locale; refuses "nan" and "inf".
std::optional<double> parseNumber(std::string_view text);

/// "270 m/min" as a number and a unit, blanks around either left out.
struct NumberWithUnit {
    std::optional<double> value; ///< none: it does not begin with a number
    std::string unit;            ///< empty: none
};
NumberWithUnit numberWithUnit(std::string_view text);

} // namespace burin
