// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The values of #n and #<name> in a program. Not thread-safe.
class Parameters {
public:
    static constexpr int count = 5603;          ///< numbers are 1 up to, but not including, this one
    static constexpr int firstOfControl = 5061; ///< this and higher numbers belong to the control: read, never set

    /// @param unsetIsZero whether parameters that the program did not set are 0, as in LinuxCNC without a parameter
    /// file
    /// @param ofControl value of one of the control's own parameters; empty if the text does not determine it
    Parameters(bool unsetIsZero, std::function<std::optional<double>(int)> ofControl)
        : unsetIsZero_(unsetIsZero), ofControl_(std::move(ofControl)) {}

    static bool exists(int number) noexcept { return number >= 1 && number < count; }
    std::optional<double> value(int number) const;
    std::optional<double> value(std::string_view name) const;
    /// Assignments of a block take effect together, after it (NIST IR 6556, 3.3.3).
    void setLater(int number, double value) { numbersLater_.emplace_back(number, value); }
    void setLater(std::string name, double value) { namesLater_.emplace_back(std::move(name), value); }
    void commit();
    /// Discards the assignments of a block that turned out to be faulty.
    void discard();

private:
    bool unsetIsZero_;
    std::function<std::optional<double>(int)> ofControl_;
    std::map<int, double> numbers_;
    std::map<std::string, double, std::less<>> names_;
    std::vector<std::pair<int, double>> numbersLater_;
    std::vector<std::pair<std::string, double>> namesLater_;
};

} // namespace burin
