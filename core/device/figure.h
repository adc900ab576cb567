// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace burin {

/// The name of a unit as a template argument.
template <std::size_t size>
struct UnitName {
    char text[size]{};
    constexpr UnitName(const char (&name)[size]) { // NOLINT: implicit on purpose, Figure<"N">
        for (std::size_t i = 0; i < size; ++i) text[i] = name[i];
    }
    constexpr std::string_view view() const { return {text, size - 1}; }
};

/// A value stated for a device, with its unit and its source.
template <UnitName name>
struct Figure {
    static constexpr std::string_view unit = name.view();
    double value = 0.0;
    std::string source; ///< English; a data sheet, a table, a measurement. Empty only if the value is not known (0)
};

} // namespace burin
