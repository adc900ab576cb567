// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/base/ring.h"
#include "core/device/stylus.h"
#include "core/device/trail_follower.h"

#include <atomic>
#include <optional>

namespace burin {

/// The position that the mouse or the keyboard requests for the tool.
struct StylusTarget {
    glm::dvec3 tip{0.0};         ///< mm, setup frame
    double maximumSpeed = 400.0; ///< mm/s of the motion to it, at most SimulatedStylus::maximumSpeed
    bool cutting = false;        ///< the first button is pressed: the spindle turns
    /// mm, z: at this height or above, the motion to a stroke's start is free of obstacles. Read from a stroke's first
    /// target only; the height of the newest target that doesn't cut is taken into account as well.
    double clearHeight = -1.0e9;
    /// For a target that doesn't cut: whether a stroke in progress is followed to its end first. Otherwise the stroke
    /// ends at the tip's current position.
    bool finishStroke = false;
    /// mm: the resolution of the pointer, i.e. the longest diagonal of a pixel at this position; 0: the target is
    /// exact. Steps in a stroke that this resolution explains are smoothed.
    double grain = 0.0;
    /// Tool axis at this point of a stroke, unit, setup frame, within 90° of +z. A target that doesn't cut is upright.
    glm::dvec3 axis = uprightAxis;
};

/// The simulated stylus: mouse or keyboard. Its device frame is the setup frame (mapping 1 : 1). It moves the tip
/// smoothly and with limited speed, so that the haptic loop sees a motion like a hand's and not that of an event queue.
/// The motion depends only on the targets and on the times of the readings.
///
/// While hovering, the tip first rises to within `clearance` of a higher target, moves sideways, and descends last. A
/// stroke begins at the first cutting target: the tip moves above that position at hover height, then the button goes
/// down (the spindle turns), then the tip moves straight down to it, and only then does it follow all of the stroke's
/// targets in order (trail_follower.h), with the delay that the limited speed causes. So no stroke cuts stock before
/// its start, and none cuts across a corner. A target that doesn't cut ends the stroke: at the end of the trail
/// (`finishStroke`), or at once. Then the button goes up and the tip rises before anything else. A stroke that is given
/// up before its start was reached never presses the button. Later targets wait until a trail is finished.
///
/// While a stroke is followed the axis leans as its targets request; otherwise it is upright, since the heights at
/// which the tip hovers are clear of an upright tool. It rotates smoothly, at most at `turnSpeed`.
///
/// `wish`, `tip`, `strokeUnderWay`, `strokesBegun` and `targetsAhead` are called on the user interface's thread, all
/// others on the haptic thread. No lock, no allocation.
class SimulatedStylus final : public Stylus {
public:
    static constexpr double maximumSpeed = 400.0;  ///< mm/s, never exceeded
    static constexpr double acceleration = 6000.0; ///< mm/s², never exceeded except for the last 0.1 mm/s before rest
    static constexpr double lag = 0.025;           ///< s, the delay behind a moving target
    static constexpr double turnSpeed = 3.0;       ///< rad/s of the axis, never exceeded
    static constexpr double turnLag = 0.02;        ///< s, the delay of the axis behind that of the trail
    /// mm of margin that hover heights contain: the tip may already move sideways when it is this far below one.
    static constexpr double clearance = 1.5;

    /// @param start initial position of the tip, mm, setup frame; clear of all obstacles
    explicit SimulatedStylus(const glm::dvec3& start);

    /// Requests a target. While hovering, only the newest target counts; a stroke passes through all of its targets. A
    /// target that gives a stroke up takes effect before all earlier ones, which are dropped.
    /// @return false if the queue is full and the target is lost; room to end a stroke is always reserved
    bool request(const StylusTarget& target) noexcept;
    /// Position of the tip at the newest reading, mm, setup frame.
    glm::dvec3 tip() noexcept;
    /// Whether a stroke was in progress at the newest reading. The trail that is still followed after the button's
    /// release counts as part of the stroke.
    bool strokeUnderWay() noexcept;
    /// Number of strokes that had turned the spindle on by the newest reading, in the order of the requests. A stroke
    /// that is given up before its start was reached is not counted.
    std::uint64_t strokesBegun() noexcept;
    /// Number of requested stroke targets that were not passed yet at the newest reading.
    std::size_t targetsAhead() noexcept;

    StylusDescription description() const override;
    Result<void> open() override;
    /// @param time s; the motion advances by at most 10 ms per reading, however late the reading is
    StylusState read(double time) noexcept override;
    /// A mouse has no motors: the force is only displayed.
    void write(const Wrench& wrench) noexcept override;
    void close() noexcept override;

private:
    enum class Phase : std::uint8_t {
        hover,
        approach, ///< at hover height, to the stroke's start
        plunge,   ///< straight down to the stroke's start, spindle on
        follow    ///< along the stroke's targets, spindle on
    };
    /// State that is published to the user interface.
    struct Shown {
        glm::dvec3 tip{0.0}; // mm
        bool strokeUnderWay = false;
        std::size_t targetsAhead = 0;
        std::uint64_t taken = 0; // cutting requests, since the beginning
        std::uint64_t begun = 0; // strokes, since the beginning
    };
    void takeRequests() noexcept;
    bool apply(const StylusTarget& target) noexcept;
    void hoverOver(const StylusTarget& target) noexcept;
    glm::dvec3 goal() const noexcept;
    glm::dvec3 above(const glm::dvec3& place) const noexcept;
    void step(double seconds) noexcept;
    void lean(double seconds) noexcept;
    void changePhase() noexcept;

    static constexpr std::size_t mostRequests = 4096, roomToEnd = 64;
    static constexpr int mostTaken = 64; // requests per reading, so that a long stroke never delays the loop
    struct Request {
        StylusTarget target;
        std::uint32_t givenUp = 0; // number of strokes given up before this request was made
    };

    Ring<Request> requests_{mostRequests};
    std::atomic<std::uint32_t> givenUp_{0}; ///< written by the user interface
    std::uint32_t givenUpSeen_ = 0;
    std::uint64_t requested_ = 0; ///< cutting requests, counted by the user interface
    std::uint64_t taken_ = 0;     ///< cutting requests taken from the queue, counted by the loop
    std::uint64_t begun_ = 0;     ///< strokes that turned the spindle on, counted by the loop
    Mailbox<Shown> places_;
    Shown shown_; ///< the user interface's copy
    StylusTarget target_;
    std::optional<StylusTarget> waiting_; ///< taken from the queue, but it can't be followed yet
    std::optional<StylusTarget> after_;   ///< follows when the stroke in progress is finished
    TrailFollower trail_;
    glm::dvec3 tip_{0.0}, velocity_{0.0}; ///< mm, mm/s
    glm::dvec3 axis_ = uprightAxis;       ///< unit
    glm::dvec3 strokeStart_{0.0};         ///< mm
    double hoverHeight_ = 0.0;            ///< mm, z at which the motion to the goal is clear
    std::optional<double> lastTime_;
    Phase phase_ = Phase::hover;
};

} // namespace burin
