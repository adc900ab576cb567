// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorder.h"

#include "core/document/sample_chunk.h"
#include "core/haptics/loop/realtime_kit.h"

#include <span>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace burin {

namespace {

/// Raises the priority of this thread. On a busy machine, recorded samples would otherwise wait in memory, where they
/// are lost if the process is killed. Never fails: without the permission, the thread keeps its normal priority.
void goBeforeOthers() noexcept {
    constexpr int nice = -11; // RealtimeKit usually grants -15
    const pid_t thread = ::gettid();
    if (::setpriority(PRIO_PROCESS, static_cast<id_t>(thread), nice) == 0) return;
    static_cast<void>(realtimekit::makeHighPriority(static_cast<std::uint64_t>(thread), nice));
}

} // namespace

Recorder::Recorder(Ring<Sample>& source, Project::TakeWriter writer)
    : source_(source)
    , writer_(std::move(writer))
    , take_(writer_.id())
    , block_(samplesPerChunk)
    , thread_(&Recorder::work, this) {}

Recorder::~Recorder() {
    static_cast<void>(finish());
}

Result<std::uint64_t> Recorder::finish() {
    {
        const std::lock_guard guard(mutex_);
        finishing_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
    if (!outcome_) return outcome_.error();
    return kept();
}

void Recorder::work() {
    goBeforeOthers();
    for (bool last = false; !last;) {
        last = wait(); // samples pushed before `finish` are seen by the pass after it
        outcome_ = drain();
        // A single error is tolerated and does not end the recording.
        for (int again = 0; !outcome_ && again < 2; ++again) {
            std::this_thread::sleep_for(interval);
            outcome_ = drain();
        }
        if (!outcome_) refusal_ = outcome_.error();
        failing_.store(!outcome_, std::memory_order_release);
    }
    if (outcome_) outcome_ = writer_.finish();
}

bool Recorder::wait() {
    std::unique_lock lock(mutex_);
    return wake_.wait_for(lock, interval, [this] { return finishing_; });
}

Result<void> Recorder::drain() {
    for (;;) {
        if (waiting_ == 0) waiting_ = source_.pop(block_);
        if (waiting_ == 0) return {};
        if (Result<void> done = writer_.append(std::span(block_).first(waiting_)); !done) return done;
        kept_.fetch_add(waiting_, std::memory_order_acq_rel);
        waiting_ = 0;
    }
}

} // namespace burin
