// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_session.h"
#include "tests/core/job/session_milling.h"

#include <functional>
#include <thread>

namespace burin::test {

using Lines = std::vector<std::vector<Segment>>;

/// A project, a rig and a hand, and operations with them.
struct Stage {
    explicit Stage(const std::filesystem::path& file, int finishAfter = 0)
        : project(*Project::create(file)), hand(finishAfter) {
        Progress progress;
        field = *clearanceField(milling, 0.5, progress);
        if (!project.setModel(Model{}) || !project.setSetup(blockSetup())) std::abort();
    }
    std::unique_ptr<MillingSession> begin(const SessionRequest& request) {
        Result<std::unique_ptr<MillingSession>> session =
            MillingSession::begin(project, milling, ToolBounds::borrowing(*field), hand, strokes, request);
        return session ? *std::move(session) : nullptr;
    }
    Lines workpiece() const { return linesOf(milling.embedded.workpiece); }
    std::uint64_t units() const { return milling.embedded.workpiece.amounts().units[milling.embedded.stockProperty]; }

    Project project;
    MillingContext milling = blockMilling();
    std::unique_ptr<const ClearanceField> field;
    StrokeHand hand;
    StrokeHistory strokes;
};

inline SessionRequest handRequest(Pace pace = Pace::realtime) {
    SessionRequest request;
    request.pace = pace;
    request.cutsOnButton = true;
    return request;
}

/// Waits until a condition holds, while the loop runs. False if it never held.
inline bool await(const std::function<bool()>& holds) {
    for (int i = 0; i < 5000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

/// Mills this many strokes and waits until the session has received them all.
inline bool millStrokes(Stage& stage, MillingSession& session, int strokes) {
    const int wanted = stage.hand.done() + strokes;
    stage.hand.mill(strokes);
    SessionState state;
    return await([&] { return session.newest(state), stage.hand.done() >= wanted; });
}

inline std::uint64_t removedUnits(const Take& take) {
    std::uint64_t units = 0;
    UndoneSamples undone(take);
    for (std::size_t i = 0; i < take.samples.size(); ++i)
        if (!undone.holds(i))
            for (const RemovedMaterial& removed : take.samples[i].removed) units += removed.units;
    return units;
}

inline bool contiguous(const Take& take) {
    for (std::size_t i = 0; i < take.samples.size(); ++i)
        if (take.samples[i].tick != i) return false;
    return !take.samples.empty() && take.samples.front().time == 0.0;
}

} // namespace burin::test
