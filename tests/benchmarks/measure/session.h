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

/// What a run of the benchmark has found out so far, which figures it is asked for, and the wish to stop it.
/// Thread: the main thread, but for `cancelled`.
class Session {
public:
    /// @param only figures whose names begin so; empty: all
    explicit Session(std::string only);

    /// Whether any figure whose name begins with `stem` is asked for.
    bool wants(std::string_view stem) const noexcept;
    /// Names what is measured now, on a terminal. Throws Cancelled when the user wants to stop.
    void stage(const std::string& title);
    /// Kept when it is asked for; in the place of one of that name, from an earlier round.
    void add(Figure figure);
    /// All is measured again. Rounds lie apart by minutes, so that a time in which others had the machine spoils one.
    void beginRound() noexcept { ++round_; }
    int round() const noexcept { return round_; } ///< from 1
    /// Of an intrinsic time and what was given under that name in the rounds before, the least; of ticks each by
    /// itself.
    double least(const std::string& name, double time);
    std::vector<double> least(const std::string& name, std::vector<double> times);
    /// A fact that has to hold for the figures to mean anything. One that fails ends the program with status 1.
    void check(bool holds, const std::string& fact);
    /// Says something that the figures can't, on standard error.
    void note(const std::string& text);
    /// What the last ticks' sums and the recount of the volume disagree in, in properties.
    void countMismatches(std::size_t properties) noexcept;
    /// Heap calls and page faults within ticks.
    void countInterruptions(std::size_t allocations, std::size_t pageFaults) noexcept;

    /// Adds recount.mismatches and tick.*, as far as they were counted.
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

/// The value, or an exception with the error's words.
template <class T>
T require(Result<T> result, const char* what) {
    if (!result)
        throw std::runtime_error(std::string(what) + ": " + result.error().subject + " " + result.error().detail);
    return std::move(result).value();
}

} // namespace burin::benchmarks
