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

/// Carries a recording from the haptic loop to the disk on a thread of its own: what the loop pushed is flushed to the
/// disk within 50 ms of wall time plus the time of the disk itself, so that a kill costs at most the last 100 ms.
/// Where the disk refuses, the samples wait in the ring and every pass tries again; nothing that was pushed is dropped.
class Recorder {
public:
    static constexpr std::chrono::milliseconds interval{20};

    /// @param source filled by one other thread; lives longer than the recorder
    Recorder(Ring<Sample>& source, Project::TakeWriter writer);
    ~Recorder(); ///< as `finish`, its outcome unheard
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    std::int64_t take() const noexcept { return take_; }
    /// Samples on the disk. Any thread.
    std::uint64_t kept() const noexcept { return kept_.load(std::memory_order_acquire); }
    /// True while the disk refuses, after some tries (a single fault passes); the session should brake and say so
    /// before the ring is full. Any thread.
    bool failing() const noexcept { return failing_.load(std::memory_order_acquire); }

    /// To be called once nothing is pushed any more: drains the ring, marks the take complete and ends the thread.
    /// @return samples kept. Errors: diskFull, fileNotWritable: the take stays, incomplete, with what `kept` says.
    Result<std::uint64_t> finish();

    /// What made `failing` true last, even if the disk took everything later; nothing: it never was. After `finish`.
    const std::optional<Error>& refusal() const noexcept { return refusal_; }

private:
    void work();
    bool wait();
    Result<void> drain();

    Ring<Sample>& source_;
    Project::TakeWriter writer_;
    const std::int64_t take_;
    std::vector<Sample> block_;    // the thread's: storage for one pass
    std::size_t waiting_ = 0;      // the thread's: samples in `block_` that the disk has not
    Result<void> outcome_;         // the thread's until it ended
    std::optional<Error> refusal_; // the thread's until it ended
    std::atomic<std::uint64_t> kept_{0};
    std::atomic<bool> failing_{false};
    std::mutex mutex_;
    std::condition_variable wake_;
    bool finishing_ = false; // under mutex_
    std::thread thread_;     // last: it uses all of the above
};

} // namespace burin
