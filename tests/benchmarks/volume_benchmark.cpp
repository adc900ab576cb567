// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-bench-volume: the figures of the S-RLE engine and of cutting, beside their peers. `burin bench volume` starts
// it.
#include "core/base/error.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/peers/openvdb.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>

namespace {

using namespace burin::benchmarks;

int measure(const std::string& only, bool json) {
    Session session(only);
    if (!hasOpenVdb()) session.note("Built without OpenVDB: its figures are left out.");
    for (const auto group :
         {peersAgree, axesAreRight, cuttingFigures, loopFigures, contactFigures, smoothnessFigures, snapshotFigures,
          memoryFigures, boundaryFigures, meshFigures, booleanFigures, voxelisationFigures, fieldFigures})
        group(session);
    session.finish();
    std::cout << (json ? jsonOf(session.figures()).dump(2) : tableOf(session.figures())) << std::endl;
    if (json) session.note(summaryOf(session.figures()));
    return session.allChecksHold() ? 0 : static_cast<int>(burin::ErrorClass::checkFailed);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App program("Figures of the S-RLE engine and of cutting, beside their peers", "burin-bench-volume");
    bool json = false;
    std::string only;
    program.add_flag("--json", json, "Print a list of JSON objects on standard output");
    program.add_option("--only", only, "Only figures whose names begin with this");
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return program.exit(wrong, std::cout, std::cerr) == 0 ? 0 : static_cast<int>(burin::ErrorClass::wrongUse);
    }
    try {
        return measure(only, json);
    } catch (const Cancelled&) {
        std::cerr << "\nCancelled.\n";
        return static_cast<int>(burin::ErrorClass::cancelled);
    } catch (const std::bad_alloc&) {
        std::cerr << "\nNot enough memory for the largest volumes; --only chooses.\n";
        return static_cast<int>(burin::ErrorClass::outOfSpaceOrRights);
    } catch (const std::exception& fault) {
        std::cerr << "\n" << fault.what() << "\n";
        return static_cast<int>(burin::ErrorClass::badInput);
    }
}
