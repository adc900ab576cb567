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

/// What #n and #<name> of a program hold. One thread.
class Parameters {
public:
    static constexpr int count = 5603;          ///< numbers go from 1 below it
    static constexpr int firstOfControl = 5061; ///< from here on they are the control's: read, never set

    /// @param unsetIsZero parameters that the program did not set are 0, as in LinuxCNC without a parameter file
    /// @param ofControl   value of one of the control's own; nothing where the text does not tell it
    Parameters(bool unsetIsZero, std::function<std::optional<double>(int)> ofControl)
        : unsetIsZero_(unsetIsZero), ofControl_(std::move(ofControl)) {}

    static bool exists(int number) noexcept { return number >= 1 && number < count; }
    std::optional<double> value(int number) const;
    std::optional<double> value(std::string_view name) const;
    /// Assignments of a block take effect together, behind it (NIST IR 6556, 3.3.3).
    void setLater(int number, double value) { numbersLater_.emplace_back(number, value); }
    void setLater(std::string name, double value) { namesLater_.emplace_back(std::move(name), value); }
    void commit();
    /// Forgets the assignments of a block that turned out faulty.
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
