// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <cstddef>
#include <span>

namespace burin {

/// Counts the valid strokes of a recording: intervals with the spindle turning that were not undone.
class StrokeCounter {
public:
    /// @param undone  ranges of the take; must outlive the counter
    explicit StrokeCounter(std::span<const SampleRange> undone) noexcept : undone_(undone) {}

    /// @param next  samples that follow those of the previous call
    void add(std::span<const Sample> next) noexcept {
        for (const Sample& sample : next) {
            const bool cutting = !undone_.holds(index_++) && (sample.flags & sampleSpindleOff) == 0;
            if (cutting && !cutting_) ++strokes_;
            cutting_ = cutting;
        }
    }
    std::size_t strokes() const noexcept { return strokes_; }

private:
    UndoneSamples undone_;
    std::uint64_t index_ = 0;
    std::size_t strokes_ = 0;
    bool cutting_ = false;
};

inline std::size_t strokeCount(const Take& take) {
    StrokeCounter counter(take.undone);
    counter.add(take.samples);
    return counter.strokes();
}

} // namespace burin
