// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Text of a number with a decimal point, independent of the locale. `decimals` digits behind it, rounded half to even
/// as the C++ library does; "-0.000" becomes "0.000".
std::string formatFixed(double value, int decimals);

/// The same for a limit; the text is never less than the value.
std::string formatLimit(double value, int decimals);

/// Shortest text that reads back as the same double, with a decimal point, independent of the locale.
std::string formatShortest(double value);

/// The number if the whole of `text` is one, otherwise empty. Independent of the locale; refuses "nan" and "inf".
std::optional<double> parseNumber(std::string_view text);

/// "270 m/min" as a number and a unit, without the blanks around them.
struct NumberWithUnit {
    std::optional<double> value; ///< empty: it does not begin with a number
    std::string unit;            ///< empty: none
};
NumberWithUnit numberWithUnit(std::string_view text);

} // namespace burin
