// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Runs in the virtual machine: plugs devices into its kernel, and uses the plugins as Burin does. Each line that begins
// with "hid" is a result.
//   program                every check
//   program figures COUNT  round trips, and COUNT hostile reports
//   program ROLE           the work of a second process: guest.h
#include "tests/hid/guest.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace burin::test {
namespace {

std::uint64_t reports = 40'000; // takes some seconds of the test; the benchmark sends a million

} // namespace

std::uint64_t hostileReports() {
    return reports;
}

void tellFigure(const std::string& name, double value, const std::string& unit) {
    std::printf("hid figure %s %.3f %s\n", name.c_str(), value, unit.c_str());
}

namespace {

bool run(const GuestCheck& check) {
    std::string fault;
    const auto begun = std::chrono::steady_clock::now();
    try {
        check.run();
    } catch (const std::exception& unmet) {
        fault = unmet.what();
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    std::printf("hid seconds %.2f %s\n", taken.count(), check.name.c_str());
    std::printf(fault.empty() ? "hid ok %s\n" : "hid failed %s: %s\n", check.name.c_str(), fault.c_str());
    std::fflush(stdout);
    return fault.empty();
}

bool run(std::initializer_list<std::vector<GuestCheck>> groups) {
    bool good = true;
    for (const auto& checks : groups)
        for (const GuestCheck& check : checks) good = run(check) && good;
    return good;
}

} // namespace
} // namespace burin::test

int main(int count, char** arguments) {
    using namespace burin::test;
    if (count == 3 && std::strcmp(arguments[1], "figures") == 0) {
        reports = std::strtoull(arguments[2], nullptr, 10);
        return run({roundTripChecks(), reports > 0 ? hostileChecks() : std::vector<GuestCheck>()}) ? 0 : 1;
    }
    if (count > 1 && std::strcmp(arguments[1], "push") == 0) return pushForEver();
    if (count > 1) return runAs(arguments[1]);
    return run({spaceMouseChecks(), inputEventChecks(), forceFeedbackChecks(), openStylusChecks(), millingChecks(),
                hostileChecks()})
               ? 0
               : 1;
}
