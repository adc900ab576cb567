// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/stall_watch.h"

#include "ui/scene/viewport.h"

#include <QAbstractEventDispatcher>
#include <QMetaEnum>

#include <algorithm>
#include <ctime>

namespace burin::testing {

namespace {

double millisecondsSince(StallWatch::Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(StallWatch::Clock::now() - begin).count();
}

/// The processor time that this thread has used, ms.
double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The view's canvas draws the whole scene in its paint event.
bool rendersView(const QObject& receiver, int event) {
    return event == QEvent::Paint && qobject_cast<const Viewport*>(receiver.parent()) != nullptr;
}

constexpr double worthTelling = 1.0; // ms

} // namespace

StallWatch::StallWatch(int& argc, char** argv) : QApplication(argc, argv), phase_(Clock::now()) {
    // One dispatcher emits that it is about to block, another that it is awake again: both mean that it looks for new
    // input.
    QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
    connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] { cameBack(); });
    connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] { cameBack(); });
}

void StallWatch::beginPhase() {
    phase_ = Clock::now();
    renderingProcessor_ = 0.0;
    renderings_ = 0;
    all_.clear();
    worst_.clear();
}

std::size_t StallWatch::longerThan(double milliseconds) const {
    return static_cast<std::size_t>(std::ranges::count_if(all_, [=](double stall) { return stall > milliseconds; }));
}

bool StallWatch::notify(QObject* receiver, QEvent* event) {
    const Clock::time_point begin = Clock::now();
    if (!away_) {
        away_ = true;
        left_ = begin;
        processorLeft_ = processorTime();
        rendering_ = 0.0;
    }
    const char* name = receiver->metaObject()->className(); // the receiver may be deleted afterwards
    const int type = event->type();
    const bool renders = rendersView(*receiver, type);
    const double processorBefore = renders ? processorTime() : 0.0;
    ++depth_;
    const bool answer = QApplication::notify(receiver, event);
    --depth_;
    const double took = millisecondsSince(begin);
    if (renders) {
        rendering_ += took;
        renderingProcessor_ += processorTime() - processorBefore;
        ++renderings_;
    }
    // An event of a dialog was handled while the dialog's own loop looked for new ones: that is no stall.
    if (took >= worthTelling && begin >= left_) handled_.push_back({depth_, name, type, took});
    return answer;
}

void StallWatch::cameBack() {
    if (!away_) return;
    away_ = false;
    const double away = millisecondsSince(left_);
    all_.push_back(away);
    if (worst_.size() < kept || away > worst_.back().milliseconds) {
        const double after = std::chrono::duration<double>(left_ - phase_).count();
        worst_.push_back({away, rendering_, processorTime() - processorLeft_, after, longestChain()});
        std::ranges::sort(worst_, std::ranges::greater(), &Stall::milliseconds);
        worst_.resize(std::min(worst_.size(), kept));
    }
    handled_.clear();
}

QString StallWatch::longestChain() const {
    const QMetaEnum types = QMetaEnum::fromType<QEvent::Type>();
    QStringList chain;
    auto from = handled_.begin(), to = handled_.end();
    const auto outermost = std::ranges::min_element(handled_, {}, &Handled::depth);
    for (int depth = outermost == to ? 0 : outermost->depth;; ++depth) {
        auto longest = to;
        for (auto one = from; one != to; ++one)
            if (one->depth == depth && (longest == to || one->milliseconds > longest->milliseconds)) longest = one;
        if (longest == to) break;
        const char* type = types.valueToKey(longest->type);
        chain.append(QStringLiteral("%1 %2 %3 ms")
                         .arg(QLatin1String(longest->receiver), QLatin1String(type != nullptr ? type : "event"))
                         .arg(longest->milliseconds, 0, 'f', 0));
        while (from != longest && std::any_of(from, longest, [=](const Handled& one) { return one.depth == depth; }))
            ++from; // after the preceding event
        to = longest;
    }
    return chain.join(QStringLiteral(" > "));
}

} // namespace burin::testing
