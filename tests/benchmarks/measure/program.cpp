// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/program.h"

#include "core/base/error.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>

namespace burin::benchmarks {

namespace {

int measure(const Program& program, const std::string& only, int rounds, bool json) {
    Session session(only);
    for (int round = 0; round < rounds; ++round) {
        session.beginRound();
        for (const auto& group : program.groups) group(session);
    }
    session.finish();
    std::cout << (json ? jsonOf(session.figures()).dump(2) : tableOf(session.figures())) << std::endl;
    if (json) session.note(summaryOf(session.figures()));
    return session.allChecksHold() ? 0 : static_cast<int>(ErrorClass::checkFailed);
}

} // namespace

int run(const Program& program, int argc, char** argv) {
    CLI::App commandLine(program.shows, program.name);
    bool json = false;
    std::string only;
    int rounds = 1;
    commandLine.add_flag("--json", json, "Print a list of JSON objects on standard output");
    commandLine.add_option("--only", only, "Only figures whose names begin with this");
    commandLine.add_option("--rounds", rounds, "Number of rounds in which everything is measured")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    try {
        commandLine.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return commandLine.exit(wrong, std::cout, std::cerr) == 0 ? 0 : static_cast<int>(ErrorClass::wrongUse);
    }
    try {
        return measure(program, only, rounds, json);
    } catch (const Cancelled&) {
        std::cerr << "\nCancelled.\n";
        return static_cast<int>(ErrorClass::cancelled);
    } catch (const std::bad_alloc&) {
        std::cerr << "\nNot enough memory for the largest volumes; --only chooses.\n";
        return static_cast<int>(ErrorClass::outOfSpaceOrRights);
    } catch (const std::exception& fault) {
        std::cerr << "\n" << fault.what() << "\n";
        return static_cast<int>(ErrorClass::badInput);
    }
}

} // namespace burin::benchmarks
