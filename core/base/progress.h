// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <algorithm>
#include <atomic>

namespace burin {

/// What a long work is doing, for display.
struct ProgressStep {
    TextId text;                    ///< empty: the work does not say
    double done = 0.0, total = 0.0; ///< %1 and %2 of the text
};

/// Progress of a long work, and a request to stop it. One writer (the work), any number of readers and cancellers;
/// never blocks.
class Progress {
public:
    /// @param fraction of this stage that is done, 0 … 1; values outside are clamped.
    void report(double fraction) noexcept {
        const double clamped = std::clamp(fraction, 0.0, 1.0);
        fraction_.store(low_ + (high_ - low_) * clamped, std::memory_order_relaxed);
    }
    /// Maps later reports to this part of the total, 0 … 1. Called by the work, between its stages.
    void stage(double low, double high) noexcept {
        low_ = low;
        high_ = high;
        describe(noText_);
        report(0.0);
    }
    double fraction() const noexcept { return fraction_.load(std::memory_order_relaxed); }
    /// Fraction of this stage that is done, 0 … 1. The work's thread.
    double fractionOfStage() const noexcept { return high_ > low_ ? (fraction() - low_) / (high_ - low_) : 0.0; }

    /// States what the work is doing within its stage, until the next call or the next stage. @param text static
    void describe(const TextId& text, double done = 0.0, double total = 0.0) noexcept {
        done_.store(done, std::memory_order_relaxed);
        total_.store(total, std::memory_order_relaxed);
        text_.store(&text, std::memory_order_relaxed);
    }
    ProgressStep step() const noexcept {
        return {*text_.load(std::memory_order_relaxed), done_.load(std::memory_order_relaxed),
                total_.load(std::memory_order_relaxed)};
    }

    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    /// For loops that need a plain flag.
    const std::atomic<bool>& cancelFlag() const noexcept { return cancelled_; }
    bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

private:
    friend class ProgressPart;
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> cancelled_{false};
    static constexpr TextId noText_{};
    std::atomic<const TextId*> text_{&noText_};
    std::atomic<double> done_{0.0}, total_{0.0};
    double low_ = 0.0, high_ = 1.0; // the work's thread only
};

/// During its lifetime, reports cover a part of the current stage: for work that is composed of other work. The work's
/// thread.
class ProgressPart {
public:
    /// @param low, high part of the stage, 0 … 1
    ProgressPart(Progress& progress, double low, double high) noexcept
        : progress_(progress), low_(progress.low_), high_(progress.high_) {
        progress.stage(low_ + (high_ - low_) * low, low_ + (high_ - low_) * high);
    }
    ~ProgressPart() {
        progress_.low_ = low_;
        progress_.high_ = high_;
    }
    ProgressPart(const ProgressPart&) = delete;
    ProgressPart& operator=(const ProgressPart&) = delete;

private:
    Progress& progress_;
    double low_, high_;
};

} // namespace burin
