// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/trace_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace burin {

/// Properties of a trace that are known before playback.
struct TraceExtent {
    std::uint64_t readings = 0;
    bool ticks = false;                ///< some reading has a period
    std::uint64_t firstOutOfOrder = 0; ///< first reading, from 1, that is not later than the one before; 0: none

    void include(const StylusState& reading) noexcept;

private:
    double lastTime_ = 0.0; ///< s
};

/// Returns the readings of a trace one after the other. Thread: one at a time.
class TracePlayback {
public:
    virtual ~TracePlayback() = default;
    const TraceExtent& extent() const noexcept { return extent_; }
    /// Restarts the playback at the first reading. Errors: those of reading a file.
    virtual Result<void> rewind() = 0;
    /// False if there are no more readings. May wait for the disk; allocates nothing.
    virtual bool next(StylusState& reading) noexcept = 0;
    /// The error that stopped `next` before the end, if any; nothing more is played until `rewind`.
    virtual Result<void> outcome() { return {}; }

protected:
    explicit TracePlayback(const TraceExtent& extent) noexcept : extent_(extent) {}

private:
    TraceExtent extent_;
};

/// Playback of readings in memory.
std::unique_ptr<TracePlayback> playbackOf(std::vector<StylusState> readings);

/// A trace whose readings remain in their file: hours of them would not fit into memory.
struct OpenedTrace {
    std::unique_ptr<TracePlayback> readings; ///< never null
    std::vector<TraceChange> changes;        ///< in their order
};

/// Reads a whole trace once, so that nothing of an invalid one is played; the playback reads it again, ahead of its
/// consumer. A source that can be read only once (a pipe) is kept in memory. The file must not be changed meanwhile.
/// Errors: those of readTrace.
Result<OpenedTrace> openTrace(const std::filesystem::path& file);

} // namespace burin
