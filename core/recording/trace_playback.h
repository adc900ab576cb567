// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/trace_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace burin {

/// What is known of a trace before it is played.
struct TraceExtent {
    std::uint64_t readings = 0;
    bool ticks = false;                ///< some reading has a period
    std::uint64_t firstOutOfOrder = 0; ///< first reading, from 1, that is no later than the one before; 0: none

    void include(const StylusState& reading) noexcept;

private:
    double lastTime_ = 0.0; ///< s
};

/// Gives the readings of a trace one after the other. Thread: one at a time.
class TracePlayback {
public:
    virtual ~TracePlayback() = default;
    const TraceExtent& extent() const noexcept { return extent_; }
    /// The next reading is the first one. Errors: those of reading a file.
    virtual Result<void> rewind() = 0;
    /// False: there is none any more. May wait for the disk; allocates nothing.
    virtual bool next(StylusState& reading) noexcept = 0;
    /// What kept `next` from getting to the end; nothing is played any more until `rewind`.
    virtual Result<void> outcome() { return {}; }

protected:
    explicit TracePlayback(const TraceExtent& extent) noexcept : extent_(extent) {}

private:
    TraceExtent extent_;
};

/// Of readings in memory.
std::unique_ptr<TracePlayback> playbackOf(std::vector<StylusState> readings);

/// A trace whose readings stay in their file: hours of them would not fit into memory.
struct OpenedTrace {
    std::unique_ptr<TracePlayback> readings; ///< never null
    std::vector<TraceChange> changes;        ///< in their order
};

/// Reads all of a trace once, so that nothing is played of one that is wrong; the playback reads it again, ahead of who
/// plays it. What can be read only once (a pipe) is kept in memory. The file must not be changed meanwhile.
/// Errors: those of readTrace.
Result<OpenedTrace> openTrace(const std::filesystem::path& file);

} // namespace burin
