// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace burin::test {

/// One fact that the program in the virtual machine checks.
struct GuestCheck {
    std::string name;
    void (*run)(); ///< throws Unmet
};

class Unmet : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Writes a line "hid figure NAME VALUE UNIT".
void tellFigure(const std::string& name, double value, const std::string& unit);

/// The work of a second process of this program, started as "program ROLE". @return its exit status
int runAs(const std::string& role);
/// The work of another one: a stick that pushes until the process is killed. Returns only if it can't.
int pushForEver();

std::vector<GuestCheck> openStylusChecks();
std::vector<GuestCheck> spaceMouseChecks();
std::vector<GuestCheck> inputEventChecks();
std::vector<GuestCheck> forceFeedbackChecks();
std::vector<GuestCheck> millingChecks();
std::vector<GuestCheck> hostileChecks();

/// Checks of the round trip only, for a benchmark.
std::vector<GuestCheck> roundTripChecks();

/// Number of hostile reports that was requested on the command line.
std::uint64_t hostileReports();

} // namespace burin::test

#define BURIN_EXPECT(condition)                                                                                        \
    if (!(condition))                                                                                                  \
    throw ::burin::test::Unmet(std::string(__func__) + ":" + std::to_string(__LINE__) + ": " #condition)
