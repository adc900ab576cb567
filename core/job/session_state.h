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

/// The state of a layer that bounds the tool, for display.
struct LayerNews {
    BoundaryLayers::State state = BoundaryLayers::State::off;
    bool holds = false;          ///< holds the tool back at present
    std::uint64_t ticksHeld = 0; ///< ticks of the take in which it held the tool
};

/// The state of a session for display: its newest tick, and values over the last second.
struct SessionState {
    Sample sample;
    std::chrono::steady_clock::time_point wallTime{}; ///< at the end of the tick
    bool recording = false;
    std::int64_t take = 0;        ///< being recorded; 0: none
    double recordedSeconds = 0.0; ///< of this take
    bool cutting = false;         ///< the spindle turns (mouse: its button is pressed)
    double rateHz = 0.0;          ///< actually reached, over the last second
    double cpuP999 = 0.0;         ///< µs of thread CPU time per tick, over the session
    double workP999 = 0.0;        ///< µs of wall time per tick, over the session
    double intervalP999 = 0.0;    ///< µs from force to force, over the session
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0; ///< edges of the clock that were skipped since the session began
    std::uint64_t late = 0;   ///< ticks whose force was withheld, as it came too late
    SchedulingClass scheduling = SchedulingClass::normal;
    double removalRate = 0.0;     ///< mm³/s, mean of the last 100 ms
    SmoothedCut cut;              ///< at present
    SmoothedCut heaviestCut;      ///< of the take
    std::uint32_t shankPiece = 0; ///< index in pieces(cutter) of the touching piece; valid with sampleShankContact
    PropertyIndex shankTouches = airProperty; ///< what it touches
    std::array<GuideNews, GuideSettings::capacity> guides{};
    std::vector<LayerNews> layers; ///< by their number in ToolBounds::layers
    /// The layer that keeps shank and holder away from the stock; empty if the session has none.
    std::optional<LayerNews> stock{};
    double workspaceScale = 1.0; ///< mm of setup per mm of device
    bool clutched = false;       ///< the hand moves, the tool stays
};

/// The workpiece at one moment, for drawing.
struct WorkpieceView {
    VolumeSnapshot workpiece;
    /// The time of the oldest cut that the previous view did not show; empty if nothing was cut.
    std::optional<std::chrono::steady_clock::time_point> oldestCut;
};

/// A position of the proxy, for drawing the path as it grows.
struct TracePoint {
    glm::vec3 tip{0.0F}; ///< mm, setup frame
    bool strokeBegins = false;
};

} // namespace burin
