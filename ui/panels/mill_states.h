// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_reach.h"
#include "core/haptics/loop/tick_sink.h"
#include "core/recording/sample.h"
#include "core/setup/guide.h"

#include <QString>
#include <QStringList>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// What the panels of the milling show. Panels own no model: they get one of these and tell by signals what the user
/// wants.
namespace burin {

enum class DepthChoice { level, part };

enum class RepeatChoice { lower, left, right };

struct TakeRow {
    TakeInfo info;
    QString tool; ///< its name
    std::size_t strokes = 0;
    bool recording = false; ///< it grows
    bool replaying = false; ///< it is being cut again; its strokes are not counted yet
};

struct MillState {
    bool ready = false;  ///< stock embedded and boundary there
    QString missing;     ///< what is to be done first, a sentence
    bool active = false; ///< mill mode
    bool recording = false;
    double recordedSeconds = 0.0;
    bool cutting = false; ///< a stroke is under way: none is taken back or put back
    bool canUndoStroke = false, canRedoStroke = false;
    std::size_t undoableStrokes = 0; ///< that can be taken back one after the other
    DepthChoice depthRule = DepthChoice::level;
    bool raster = false;                                                ///< a drag spans a rectangle
    double depthOfCut = 1.0, press = 2.0, speed = 60.0, stepOver = 2.0; ///< mm, mm, mm/s, mm
    bool canRepeat = false;                                             ///< there is a stroke to repeat
    QString lock;                                                       ///< what strokes keep to; empty: nothing
    QString alarm; ///< what keeps the tool from cutting; empty: nothing
    QString hint;  ///< what the hand may wonder about; empty: nothing
    std::vector<TakeRow> takes;
    bool showing = false; ///< the virtual operator mills
    QStringList styluses; ///< what can be milled with
    int stylus = 0;       ///< of these
};

struct GuideState {
    std::vector<Guide> guides; ///< the upper one stays where not all can hold
    bool on = true;            ///< as a whole
    bool full = false;         ///< no more can be added
    bool edges = false;        ///< the part has edges to follow
    bool live = false;         ///< mill mode: `news` counts
    std::array<GuideNews, GuideSettings::capacity> news{};
    glm::dvec3 zero{0.0}; ///< mm, of the program, in the setup frame
};

struct HandState {
    bool hasDevice = false; ///< a device is in the hand, not the mouse
    double scale = 1.0;     ///< mm of the tool per mm of the hand
    bool clutched = false;
    bool canRate = false; ///< the device may set the tool's speed instead of its place
    bool rate = false;    ///< and does
    int buttons = 0;      ///< of the device
    int clutchButton = 0, levelButton = 0, forceButton = 0; ///< numbers from 1; 0: none
    bool motors = false;                                    ///< forces can be felt
    bool recording = false;
    std::optional<double> battery, heat; ///< 0 … 1, where the device tells them
    bool charging = false;
};

/// A feed proposed for what the flutes stand in.
struct ProposedFeed {
    double feed = 0.0, spindleSpeed = 0.0; ///< mm/min, 1/min
    double arc = 0.0, depth = 0.0;         ///< rad, mm, of the engagement
    QString material;                      ///< that asks for it
    QString bound;                         ///< why it is not higher, a sentence
};

/// What the meters and the status line show.
struct MeterState {
    bool running = false; ///< the haptic loop runs
    double rateHz = 0.0;
    double intervalP999 = 0.0; ///< µs from force to force
    double workP999 = 0.0;     ///< µs of thread CPU time
    std::uint64_t missed = 0;
    std::uint64_t late = 0; ///< ticks whose force was withheld
    SchedulingClass scheduling = SchedulingClass::normal;
    double force = 0.0;       ///< N, unscaled cutting force
    double forceScale = 5.0;  ///< N, full scale so far
    double forceLimit = 0.0;  ///< N that tool and spindle bear; 0: not known
    QString forceLimitOf;     ///< what bears no more
    double removalRate = 0.0; ///< mm³/s
    double removalScale = 100.0;
    std::optional<ProposedFeed> proposed; ///< for the newest cut; none: nothing was cut yet
    glm::dvec3 tip{0.0};                  ///< mm, program coordinates
    QString stylus;                       ///< "Mouse", "Virtual operator 8 ×"
};

} // namespace burin
