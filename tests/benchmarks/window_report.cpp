// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/window_report.h"

#include <cmath>
#include <iostream>

namespace burin::testing {

namespace {

constexpr double longestStall = 100.0; // ms

} // namespace

void Report::add(const std::string& name, double value, const char* unit, std::optional<double> limit) {
    nlohmann::json figure{{"name", name}, {"value", std::round(value * 1000.0) / 1000.0}, {"unit", unit}};
    if (limit) figure["limit"] = *limit;
    figures_.push_back(std::move(figure));
    std::cerr << name << ": " << value << ' ' << unit;
    if (limit) std::cerr << (value > *limit ? ", BEYOND its limit of " : ", limit ") << *limit << ' ' << unit;
    std::cerr << '\n';
}

void Report::addStalls(const std::string& name, const StallWatch& watch) {
    add(name, watch.longest().milliseconds, "ms", longestStall);
    long_ += watch.longerThan(longestStall);
    add(name + ".rendering", watch.longest().rendering, "ms");
    for (const StallWatch::Stall& stall : watch.worst())
        std::cerr << "    " << stall.milliseconds << " ms (rendering " << stall.rendering << ", processor time "
                  << stall.processor << ") after " << stall.after << " s: " << qPrintable(stall.what) << '\n';
}

void Report::print() {
    add("gui_stalls_beyond_100", static_cast<double>(long_), "", 0.0);
    std::cout << figures_.dump(2) << std::endl;
}

} // namespace burin::testing
