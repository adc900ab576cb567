// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/measure/tick_watch.h"

#include <span>

namespace burin::benchmarks {

/// Mills a workpiece as the haptic loop does: a cut a tick, its runs written later (deferred), and a snapshot every 16
/// ticks for a view at 60 Hz, which then gives the one before it back. Whatever it cuts is counted and compared with a
/// recount of the whole volume.
class Milling {
public:
    /// The workpiece as it is now is where every replay begins.
    Milling(RunVolume& workpiece, const Cutter& cutter);

    /// Back to the start state with the tool at a pose: first contact made, runs written. Counts the cuts before it.
    void restart(Session& session, const ToolPose& pose);
    /// The same, but the tool hangs in the air and nothing is cut yet.
    void restartInAir(Session& session);
    /// One tick of the loop.
    CutResult tick(const ToolPose& from, const ToolPose& to) noexcept;
    /// Between ticks: lets the view's old snapshot go, as the view does on its own thread.
    void giveBackView() noexcept { oldView_ = VolumeSnapshot(); }
    /// Writes what is pending and compares the counts with a recount: properties that differ go to the run.
    void finish(Session& session);

    /// Intrinsic time of every move of a path, µs, start and first contact left out. Counts what must not happen in a
    /// tick, and recounts the volume after every replay.
    std::vector<double> leastTicks(Session& session, std::span<const ToolPose> path, const ReplayRule& rule = {});

    std::uint64_t removedUnits() const noexcept; ///< since the last restart, its first contact left out
    RunVolume& workpiece() noexcept { return workpiece_; }
    MaterialRemoval& removal() noexcept { return removal_; }

private:
    void count(const CutResult& cut) noexcept;

    RunVolume& workpiece_;
    MaterialRemoval removal_;
    VolumeSnapshot start_, view_, oldView_;
    RunAmounts startAmounts_, removed_;
    TickWatch watch_;
    std::uint64_t firstContactUnits_ = 0;
    int ticksSinceView_ = 0;
    bool cutSomething_ = false;
    bool outOfMemory_ = false;
};

} // namespace burin::benchmarks
