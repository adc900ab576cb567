// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/stall_watch.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace burin::testing {

/// The figures of the benchmark: as readable text on standard error when they arrive, as JSON on standard output at the
/// end.
class Report {
public:
    void add(const std::string& name, double value, const char* unit, std::optional<double> limit = std::nullopt);
    /// Adds the longest stall of the phase with its limit, and how much of it rendered the view; the readable text also
    /// states what each of the longest stalls was spent on.
    void addStalls(const std::string& name, const StallWatch& watch);
    void print();

private:
    std::size_t long_ = 0; ///< stalls beyond the limit, in all phases
    nlohmann::json figures_ = nlohmann::json::array();
};

} // namespace burin::testing
