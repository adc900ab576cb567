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

/// States of the milling panels. Panels own no model: they are given one of these states and report the user's requests
/// by signals.
namespace burin {

enum class DepthChoice { level, part };

enum class PenChoice { depth, sink }; ///< what the pressure of a pen does

enum class RepeatChoice { lower, left, right };

struct TakeRow {
    TakeInfo info;
    QString tool; ///< name of the tool
    std::size_t strokes = 0;
    bool recording = false; ///< whether the take is being recorded
    bool replaying = false; ///< whether the take is being cut again; its strokes are not counted yet
};

struct MillState {
    bool ready = false;  ///< whether the stock is embedded and the boundary computed
    QString missing;     ///< what must be done first, as a sentence
    bool active = false; ///< mill mode
    bool recording = false;
    double recordedSeconds = 0.0;
    bool cutting = false; ///< whether a stroke is in progress: no stroke can be undone or redone
    bool canUndoStroke = false, canRedoStroke = false;
    std::size_t undoableStrokes = 0; ///< number of strokes that can be undone one after the other
    DepthChoice depthRule = DepthChoice::level;
    bool raster = false;                                                ///< whether a drag spans a rectangle
    double depthOfCut = 1.0, press = 2.0, speed = 60.0, stepOver = 2.0; ///< mm, mm, mm/s, mm
    bool pen = false;                                                   ///< whether there is a pen tablet
    PenChoice penRule = PenChoice::depth;
    double sinkSpeed = 2.0; ///< mm/s at full pressure
    bool canRepeat = false; ///< whether there is a stroke to repeat
    QString lock;           ///< the constraint on strokes; empty: none
    QString alarm;          ///< what prevents the tool from cutting; empty: nothing
    QString hint;           ///< explanation of what the user may notice at the device; empty: none
    std::vector<TakeRow> takes;
    bool showing = false; ///< whether the virtual operator is milling
    QStringList styluses; ///< the available input devices
    int stylus = 0;       ///< index in `styluses`
};

struct GuideState {
    std::vector<Guide> guides; ///< in order of priority: where not all can be met, the upper one is kept
    bool on = true;            ///< whether the guides as a whole are on
    bool full = false;         ///< whether no more can be added
    bool edges = false;        ///< whether the part has edges to follow
    bool live = false;         ///< whether mill mode is active and `news` is valid
    std::array<GuideNews, GuideSettings::capacity> news{};
    glm::dvec3 zero{0.0}; ///< program zero, mm, setup frame
};

struct HandState {
    bool hasDevice = false; ///< whether a haptic device is in use instead of the mouse
    double scale = 1.0;     ///< mm of the tool per mm of the hand
    bool clutched = false;
    bool canRate = false; ///< whether the device can control the tool's speed instead of its position
    bool rate = false;    ///< whether it controls the speed now
    int buttons = 0;      ///< number of buttons of the device
    int clutchButton = 0, levelButton = 0, forceButton = 0; ///< numbers from 1; 0: none
    bool motors = false;                                    ///< whether the device can render forces
    bool pushesOnButton = false; ///< its force always requires a button: the first one, unless another is chosen
    bool recording = false;
    std::optional<double> battery, heat; ///< 0 … 1, if the device reports them
    bool charging = false;
};

/// A feed proposed for the current engagement of the flutes.
struct ProposedFeed {
    double feed = 0.0, spindleSpeed = 0.0; ///< mm/min, 1/min
    double arc = 0.0, depth = 0.0;         ///< rad, mm, of the engagement
    QString material;                      ///< the material that determines it
    QString bound;                         ///< why it is not higher, as a sentence
};

/// The state shown by the meters and the status line.
struct MeterState {
    bool running = false; ///< whether the haptic loop is running
    double rateHz = 0.0;
    double intervalP999 = 0.0; ///< µs from force to force
    double workP999 = 0.0;     ///< µs of thread CPU time
    std::uint64_t missed = 0;
    std::uint64_t late = 0; ///< ticks whose force was withheld
    SchedulingClass scheduling = SchedulingClass::normal;
    double force = 0.0;       ///< N, unscaled cutting force
    double forceScale = 5.0;  ///< N, full scale so far
    double forceLimit = 0.0;  ///< N, the limit of tool and spindle; 0: not known
    QString forceLimitOf;     ///< the component that sets the limit
    double removalRate = 0.0; ///< mm³/s
    double removalScale = 100.0;
    std::optional<ProposedFeed> proposed; ///< for the newest cut; empty: nothing has been cut yet
    glm::dvec3 tip{0.0};                  ///< mm, program coordinates
    QString stylus;                       ///< "Mouse", "Virtual operator 8 ×"
};

} // namespace burin
