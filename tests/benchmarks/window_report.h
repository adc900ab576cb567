// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/stall_watch.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace burin::testing {

/// The figures of the benchmark: in plain words on standard error as they come, as JSON on standard output at the end.
class Report {
public:
    void add(const std::string& name, double value, const char* unit, std::optional<double> limit = std::nullopt);
    /// The longest stall of the phase against its limit, and how much of it rendered the view; in plain words also what
    /// each of the longest was spent on.
    void addStalls(const std::string& name, const StallWatch& watch);
    void print() const;

private:
    nlohmann::json figures_ = nlohmann::json::array();
};

} // namespace burin::testing
