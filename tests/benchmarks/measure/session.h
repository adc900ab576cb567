// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "tests/benchmarks/measure/figures.h"

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace burin::benchmarks {

/// The user stopped the run; unwinds to main.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

/// The results of a benchmark run so far, the figures that are requested, and the request to cancel it. To be used on
/// the main thread only, except `cancelled`.
class Session {
public:
    /// @param only  prefix of the names of requested figures; empty: all figures
    explicit Session(std::string only);

    /// Whether any figure whose name begins with `stem` is requested.
    bool wants(std::string_view stem) const noexcept;
    /// Shows on a terminal what is being measured. Throws Cancelled if the user cancelled the run.
    void stage(const std::string& title);
    /// Keeps the figure if it is requested; replaces one of that name from an earlier round.
    void add(Figure figure);
    /// Everything is measured again. Rounds are minutes apart, so that a period in which the machine was busy spoils
    /// only one.
    void beginRound() noexcept { ++round_; }
    int round() const noexcept { return round_; } ///< from 1
    /// The least of an intrinsic time and the times given under that name in earlier rounds; for ticks, of each tick
    /// separately.
    double least(const std::string& name, double time);
    std::vector<double> least(const std::string& name, std::vector<double> times);
    /// Records a fact without which the figures would be meaningless. If one does not hold, the program ends with
    /// status 1.
    void check(bool holds, const std::string& fact);
    /// Prints on standard error what the figures cannot express.
    void note(const std::string& text);
    /// The number of properties for which the sums over the last ticks differ from the recount of the volume.
    void countMismatches(std::size_t properties) noexcept;
    /// Heap calls and page faults during ticks.
    void countInterruptions(std::size_t allocations, std::size_t pageFaults) noexcept;

    /// Adds recount.mismatches and tick.*, if they were counted.
    void finish();
    const std::vector<Figure>& figures() const noexcept { return figures_; }
    bool allChecksHold() const noexcept { return failed_ == 0; }

    static bool cancelled() noexcept;
    static void throwIfCancelled();

private:
    void clearLine() const;

    std::string only_;
    bool terminal_;
    std::vector<Figure> figures_;
    std::map<std::string, std::vector<double>> least_;
    int round_ = 0;
    std::size_t failed_ = 0, mismatches_ = 0, allocations_ = 0, pageFaults_ = 0;
    bool recounted_ = false, watched_ = false;
};

/// The value, or an exception with the text of the error.
template <class T>
T require(Result<T> result, const char* what) {
    if (!result)
        throw std::runtime_error(std::string(what) + ": " + result.error().subject + " " + result.error().detail);
    return std::move(result).value();
}

} // namespace burin::benchmarks
