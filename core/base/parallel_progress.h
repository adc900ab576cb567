// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace burin {

/// Counts the work that several threads have done in one stage. `Progress` has one writer: progress is reported by the
/// thread that created this object, which has to be the one of the work, and takes part in the stage.
class ParallelProgress {
public:
    /// @param pieces of the stage, in total @param low, high range of the reports, 0 … 1
    ParallelProgress(Progress& progress, std::size_t pieces, double low = 0.0, double high = 1.0) noexcept
        : progress_(progress), pieces_(pieces), low_(low), high_(high) {}
    /// Reports what other threads did last. The work's thread.
    ~ParallelProgress() { report(done_.load(std::memory_order_relaxed)); }
    ParallelProgress(const ParallelProgress&) = delete;
    ParallelProgress& operator=(const ParallelProgress&) = delete;

    /// Thread-safe; never blocks.
    /// @param pieces that are newly done; work that is repeated, as when memory did not suffice, adds nothing beyond
    /// the total
    void add(std::size_t pieces = 1) noexcept {
        const std::size_t done = done_.fetch_add(pieces, std::memory_order_relaxed) + pieces;
        if (std::this_thread::get_id() == owner_) report(done);
    }

private:
    void report(std::size_t done) noexcept {
        if (pieces_ == 0) return;
        const double share = static_cast<double>(std::min(done, pieces_)) / static_cast<double>(pieces_);
        progress_.report(low_ + (high_ - low_) * share);
    }

    Progress& progress_;
    std::size_t pieces_;
    double low_, high_;
    std::atomic<std::size_t> done_{0};
    const std::thread::id owner_ = std::this_thread::get_id();
};

} // namespace burin
