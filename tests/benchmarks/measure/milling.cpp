// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/milling.h"

namespace burin::benchmarks {

namespace {

constexpr int ticksPerView = 16; // at 1 kHz: 62 views a second

} // namespace

Milling::Milling(RunVolume& workpiece, const Cutter& cutter)
    : workpiece_(workpiece)
    , removal_(cutter, workpiece.grid(), Writing::deferred)
    , start_(workpiece.snapshot())
    , startAmounts_(start_.amounts()) {}

void Milling::restartInAir(Session& session) {
    if (cutSomething_) finish(session);
    view_ = oldView_ = VolumeSnapshot();
    removal_.reset();
    workpiece_.restore(start_);
    removed_ = {};
    firstContactUnits_ = 0;
    ticksSinceView_ = 0;
    cutSomething_ = false;
}

void Milling::restart(Session& session, const ToolPose& pose) {
    restartInAir(session);
    constexpr int enough = 1000; // ticks for a first contact that is spread
    for (int i = 0; i < enough; ++i) {
        const CutResult cut = removal_.cut(workpiece_, pose, pose);
        count(cut);
        if (!cut.putOff) break;
    }
    count(removal_.settle(workpiece_));
    firstContactUnits_ = removedUnits();
}

CutResult Milling::tick(const ToolPose& from, const ToolPose& to) noexcept {
    const CutResult cut = removal_.cut(workpiece_, from, to);
    count(cut);
    if (++ticksSinceView_ == ticksPerView) {
        ticksSinceView_ = 0;
        oldView_ = std::move(view_);
        view_ = workpiece_.snapshot();
    }
    return cut;
}

void Milling::finish(Session& session) {
    count(removal_.settle(workpiece_));
    session.check(!outOfMemory_, "the reserved memory suffices for the benchmark's cuts");
    const RunAmounts recount = workpiece_.snapshot().amounts();
    std::size_t mismatches = recount == workpiece_.amounts() ? 0U : 1U;
    for (std::size_t i = 1; i < recount.units.size(); ++i)
        mismatches += startAmounts_.units[i] - removed_.units[i] == recount.units[i] ? 0U : 1U;
    session.countMismatches(mismatches);
    session.countInterruptions(watch_.allocations(), watch_.pageFaults());
    watch_.restart();
    cutSomething_ = false;
}

std::vector<double> Milling::leastTicks(Session& session, std::span<const ToolPose> path, const ReplayRule& rule) {
    const std::vector<double> least = leastOfReplays(
        path.size() - 1,
        [&] {
            watch_.end();
            restart(session, path.front());
            watch_.begin();
        },
        [&](std::size_t i) { tick(path[i], path[i + 1]); }, [&] { giveBackView(); }, rule);
    watch_.end();
    finish(session);
    return least;
}

std::uint64_t Milling::removedUnits() const noexcept {
    std::uint64_t units = 0;
    for (const std::uint64_t one : removed_.units) units += one;
    return units - firstContactUnits_;
}

void Milling::count(const CutResult& cut) noexcept {
    cutSomething_ = true;
    outOfMemory_ = outOfMemory_ || cut.outOfMemory;
    for (const MaterialVolume& material : cut.removed) {
        if (material.property == airProperty) break;
        removed_.units[material.property] += material.units;
    }
}

} // namespace burin::benchmarks
