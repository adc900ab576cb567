// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/session_loop.h"

#include <utility>

namespace burin {

SessionLoop::SessionLoop(HapticStep& step, RunVolume& workpiece, bool undoable, std::atomic<bool>& stop, bool waits)
    : step_(step), workpiece_(workpiece), undoable_(undoable), waits_(waits), stop_(stop) {
    step_.releaseSpindle(false);
}

void SessionLoop::requestTake(const Recording& recording) noexcept {
    requested_ = recording;
    request(Request::begin);
}

void SessionLoop::fulfil() noexcept {
    switch (request_.load(std::memory_order_acquire)) {
    case Request::none:
        return;
    case Request::begin:
        begin();
        break;
    case Request::finish:
        if (!endStroke()) return; // the owner will take some shortly
        step_.releaseSpindle(false);
        recording_ = {};
        break;
    case Request::stand:
        standing_ = true;
        break;
    case Request::goOn:
        standing_ = false;
        break;
    }
    request_.store(Request::none, std::memory_order_release);
}

void SessionLoop::begin() noexcept {
    recording_ = requested_;
    recorded_ = 0;
    layers_.ticksHeld = {};
    recentCut_.beginTake();
    step_.beginTake();
    step_.releaseSpindle(true);
}

/// Applies the owner's changes before the next tick.
void SessionLoop::takeChanges() noexcept {
    for (StepChange change; changes_.pop({&change, 1}) == 1;) step_.apply(change);
}

AtEdge SessionLoop::edge() noexcept {
    fulfil();
    if (standing_ || (waits_ && strokes_.full())) return AtEdge::stand;
    takeChanges();
    step_.takeTiles();
    giveView();
    if (!recording()) return AtEdge::tick;
    // Milling must not continue if the recording can't be kept.
    if (recording_.recorder->failing()) {
        gaveUp_.store(true, std::memory_order_relaxed);
        stop_.store(true, std::memory_order_relaxed);
    }
    if (undoable_ && !strokeUnderWay() && before_.empty()) {
        step_.settle();
        before_ = workpiece_.snapshot();
    }
    return samples_.size() < samples_.capacity() ? AtEdge::tick : AtEdge::full;
}

void SessionLoop::tick(const Sample& sample, const TickTiming& timing) noexcept {
    std::uint64_t units = 0;
    for (const RemovedMaterial& removed : sample.removed) units += removed.units;
    if (units > 0 && oldestCut_ == 0) oldestCut_ = timing.over;
    const bool cutting = recording() && (sample.flags & sampleSpindleOff) == 0;
    if (recording()) {
        samples_.push(sample); // the edge checked for room, and this thread is the only writer
        follow(sample, cutting);
        ++recorded_;
    }
    const bool hot = (sample.flags & sampleMotorsHot) != 0;
    if (hot && !hot_) heated_.store(true, std::memory_order_relaxed);
    hot_ = hot;
    rate_.add(units, timing.period);
    recentCut_.add(sample, step_.met(), timing.period);
    noteLayers();
    if (figures_.add(timing)) figuresOut_.post(figures_.newest());
    TickNews news;
    news.sample = sample;
    news.timing = timing;
    news.ticks = ++ticks_;
    news.take = recording_.take;
    news.removalRate = rate_.unitsPerSecond();
    news.cut = recentCut_.newest();
    news.heaviestCut = recentCut_.heaviest();
    news.cutting = cutting;
    news.shank = step_.shankContact();
    for (std::size_t i = 0; i < news.guides.size(); ++i) news.guides[i] = step_.guides().news(i);
    news.workspaceScale = step_.workspace().mapping().scale;
    news.clutched = step_.workspace().clutched();
    news.layers = layers_;
    news_.post(news);
}

void SessionLoop::noteLayers() noexcept {
    using State = BoundaryLayers::State;
    layers_.on = layers_.force = 0;
    layers_.held = step_.heldBy();
    for (std::size_t i = 0; i < step_.layers().size(); ++i) {
        const std::uint64_t bit = std::uint64_t{1} << i;
        const State state = step_.layers().state(i);
        if (state != State::off) layers_.on |= bit;
        if (state == State::inForce) layers_.force |= bit;
        if (recording() && LayersNews::has(layers_.held, i)) ++layers_.ticksHeld[i];
    }
}

void SessionLoop::follow(const Sample& sample, bool cutting) noexcept {
    if (!cutting) {
        // If too many strokes wait to be taken, this one is merged with the next.
        static_cast<void>(endStroke());
        traceBegins_ = true;
        return;
    }
    if (!strokeUnderWay()) {
        strokeFirst_ = recorded_;
        traceBegins_ = true;
        strokeOpen_.store(true, std::memory_order_release);
    }
    // A point that finds the ring full leaves a gap.
    traceBegins_ = !trace_.push({glm::vec3(sample.proxy.tip), traceBegins_});
}

bool SessionLoop::endStroke() noexcept {
    if (!strokeUnderWay()) return true;
    step_.settle(); // so that the snapshots of the next stroke and of undo contain all of this one
    if (undoable_) {
        if (strokes_.full()) return false;
        strokes_.put({recording_.take, strokeFirst_, recorded_ - strokeFirst_, std::move(before_)});
    }
    strokeOpen_.store(false, std::memory_order_release);
    return true;
}

void SessionLoop::workpieceChanged(const WorkpieceChange& change) noexcept {
    before_ = {};
    step_.workpieceChanged(change);
}

WorkpieceView SessionLoop::view() {
    WorkpieceView view;
    view.workpiece = workpiece_.snapshot();
    if (const std::int64_t cut = std::exchange(oldestCut_, 0); cut != 0)
        view.oldestCut = std::chrono::steady_clock::time_point(std::chrono::nanoseconds(cut));
    return view;
}

void SessionLoop::giveView() {
    if (!viewRequest_.load(std::memory_order_relaxed) || views_.full()) return;
    viewRequest_.store(false, std::memory_order_relaxed);
    views_.put(view());
}

} // namespace burin
