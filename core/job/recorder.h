// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ring.h"
#include "core/document/project.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace burin {

/// Writes a recording from the haptic loop to the disk on a separate thread: what the loop pushed is flushed to the
/// disk within 50 ms of wall time plus the time of the disk itself, so that a killed process loses at most the last 100
/// ms. If writing fails, the samples wait in the ring and every pass tries again; nothing that was pushed is dropped.
class Recorder {
public:
    static constexpr std::chrono::milliseconds interval{20};

    /// @param source filled by one other thread; must outlive the recorder
    Recorder(Ring<Sample>& source, Project::TakeWriter writer);
    ~Recorder(); ///< as `finish`; its result is discarded
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    std::int64_t take() const noexcept { return take_; }
    /// Returns the number of samples on the disk. Thread-safe.
    std::uint64_t kept() const noexcept { return kept_.load(std::memory_order_acquire); }
    /// Whether writing to the disk is failing after several tries (a single error is tolerated); the session should
    /// brake and report it before the ring is full. Thread-safe.
    bool failing() const noexcept { return failing_.load(std::memory_order_acquire); }

    /// Call after the last sample was pushed: drains the ring, marks the take complete and ends the thread.
    /// @return number of samples kept. Errors: diskFull, fileNotWritable: the take stays incomplete, with `kept`
    /// samples.
    Result<std::uint64_t> finish();

    /// Returns the last error that made `failing` true, even if everything was written later; empty if there was none.
    /// Call after `finish`.
    const std::optional<Error>& refusal() const noexcept { return refusal_; }

private:
    void work();
    bool wait();
    Result<void> drain();

    Ring<Sample>& source_;
    Project::TakeWriter writer_;
    const std::int64_t take_;
    std::vector<Sample> block_;    // owned by the thread: storage for one pass
    std::size_t waiting_ = 0;      // owned by the thread: samples in `block_` not yet on the disk
    Result<void> outcome_;         // owned by the thread until it has ended
    std::optional<Error> refusal_; // owned by the thread until it has ended
    std::atomic<std::uint64_t> kept_{0};
    std::atomic<bool> failing_{false};
    std::mutex mutex_;
    std::condition_variable wake_;
    bool finishing_ = false; // under mutex_
    std::thread thread_;     // last: it uses all of the above
};

} // namespace burin
