// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Runs in the virtual machine: plugs devices into its kernel, and uses the plugins as Burin does. Each line that begins
// with "hid" is a result.
#include "tests/hid/guest.h"

#include <cstdio>

namespace burin::test {

void tellFigure(const std::string& name, double value, const std::string& unit) {
    std::printf("hid figure %s %.3f %s\n", name.c_str(), value, unit.c_str());
}

namespace {

bool run(const GuestCheck& check) {
    std::string fault;
    try {
        check.run();
    } catch (const std::exception& unmet) {
        fault = unmet.what();
    }
    std::printf(fault.empty() ? "hid ok %s\n" : "hid failed %s: %s\n", check.name.c_str(), fault.c_str());
    std::fflush(stdout);
    return fault.empty();
}

} // namespace
} // namespace burin::test

int main(int count, char** arguments) {
    using namespace burin::test;
    if (count > 1) return runAs(arguments[1]);
    bool good = true;
    for (const auto& checks : {spaceMouseChecks(), openStylusChecks()})
        for (const GuestCheck& check : checks) good = run(check) && good;
    return good ? 0 : 1;
}
