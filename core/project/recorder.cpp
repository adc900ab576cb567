// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/recorder.h"

#include "core/project/sample_chunk.h"

#include <span>
#include <utility>

namespace burin {

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
    for (bool last = false; !last;) {
        last = wait(); // what was pushed before `finish` is seen by the pass after it
        outcome_ = drain();
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
