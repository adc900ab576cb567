// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/measure/tick_watch.h"

#include <span>

namespace burin::benchmarks {

/// Mills a workpiece as the haptic loop does: one cut per tick, whose runs are written later (deferred), and a snapshot
/// every 16 ticks for a view at 60 Hz, which then releases the previous one. All cuts are counted and compared with a
/// recount of the whole volume.
class Milling {
public:
    /// Every replay starts from the current state of the workpiece.
    Milling(RunVolume& workpiece, const Cutter& cutter);

    /// Restores the start state with the tool at a pose: first contact made, runs written. Counts the cuts before it.
    void restart(Session& session, const ToolPose& pose);
    /// The same, but the tool is in the air and nothing has been cut.
    void restartInAir(Session& session);
    /// One tick of the loop.
    CutResult tick(const ToolPose& from, const ToolPose& to) noexcept;
    /// Called between ticks: releases the view's old snapshot, as the view does in its own thread.
    void giveBackView() noexcept { oldView_ = VolumeSnapshot(); }
    /// Writes pending runs and compares the counts with a recount: the number of properties that differ is reported to
    /// the session.
    void finish(Session& session);

    /// Intrinsic times of all moves of a path, µs, without start and first contact. Counts what must not happen in a
    /// tick, and recounts the volume after every replay.
    std::vector<double> leastTicks(Session& session, std::span<const ToolPose> path, const ReplayRule& rule = {});

    std::uint64_t removedUnits() const noexcept; ///< since the last restart, without its first contact
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
