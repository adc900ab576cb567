// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/job/recent_cut.h"
#include "core/recording/sample.h"
#include "core/setup/guide.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// What became of a layer that bounds the tool, for whoever shows it.
struct LayerNews {
    BoundaryLayers::State state = BoundaryLayers::State::off;
    bool holds = false;          ///< it holds the tool back just now
    std::uint64_t ticksHeld = 0; ///< ticks of the take in which it held the tool
};

/// What there is to see of a session: its newest tick, and values over the last second.
struct SessionState {
    Sample sample;
    std::chrono::steady_clock::time_point wallTime{}; ///< when the tick was over
    bool recording = false;
    std::int64_t take = 0;        ///< that is recorded; 0: none
    double recordedSeconds = 0.0; ///< of this take
    bool cutting = false;         ///< the spindle turns (mouse: its button is down)
    double rateHz = 0.0;          ///< that was really reached, over the last second
    double cpuP999 = 0.0;         ///< µs of thread CPU time a tick, over the session
    double workP999 = 0.0;        ///< µs of wall time a tick, over the session
    double intervalP999 = 0.0;    ///< µs from force to force, over the session
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0; ///< edges of the clock that were skipped since the session began
    std::uint64_t late = 0;   ///< ticks whose force was withheld, as it came too late
    SchedulingClass scheduling = SchedulingClass::normal;
    double removalRate = 0.0;     ///< mm³/s, mean of the last 100 ms
    SmoothedCut cut;              ///< as it is now
    SmoothedCut heaviestCut;      ///< of the take
    std::uint32_t shankPiece = 0; ///< place in pieces(cutter) of what touches; meaningful with sampleShankContact
    PropertyIndex shankTouches = airProperty; ///< what it touches
    std::array<GuideNews, GuideSettings::capacity> guides{};
    std::vector<LayerNews> layers; ///< by the number that ToolBounds::layers gives
    double workspaceScale = 1.0;   ///< mm of setup per mm of device
    bool clutched = false;         ///< the hand moves, the tool stays
};

/// A workpiece at a moment, for drawing.
struct WorkpieceView {
    VolumeSnapshot workpiece;
    /// When the oldest cut that the view before did not show was made; nothing when nothing was cut.
    std::optional<std::chrono::steady_clock::time_point> oldestCut;
};

/// A place of the proxy, for drawing the path as it grows.
struct TracePoint {
    glm::vec3 tip{0.0F}; ///< mm, setup frame
    bool strokeBegins = false;
};

} // namespace burin
