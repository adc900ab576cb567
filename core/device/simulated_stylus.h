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

/// Where the mouse or the keyboard wants the tool.
struct StylusTarget {
    glm::dvec3 tip{0.0};         ///< mm, setup frame
    double maximumSpeed = 400.0; ///< mm/s on the way there, at most SimulatedStylus::maximumSpeed
    bool cutting = false;        ///< first button: the spindle turns
    /// mm, z: with this height or more the way to a stroke's start is clear. Read from a stroke's first target only;
    /// the height of the newest target that doesn't cut counts as well.
    double clearHeight = -1.0e9;
    /// Of a target that doesn't cut: a stroke that is under way goes on to its end first. Else it ends where it is.
    bool finishStroke = false;
    /// mm: the pointer can't tell places apart that are nearer to each other, a pixel's longest diagonal there; 0: the
    /// target is exact. Steps of a stroke that it explains are smoothed.
    double grain = 0.0;
};

/// The simulated stylus: mouse or keyboard. Its device frame is the setup frame (mapping 1 : 1). It leads the tip along
/// a smooth, speed-limited motion, so that the loop sees a hand and not an event queue: a function of the targets and
/// the times of reading alone.
///
/// Hovering, it first rises to within `clearance` of where the target is higher, and comes down last. A stroke begins
/// at the first cutting target: the tip goes above that place at hover height, then the button goes down (the spindle
/// turns), then the tip goes straight down to it, and only then does it follow all of the stroke's targets in order
/// (trail_follower.h), as late as the speed makes it. So no stroke drags through stock on its way to its start, and
/// none cuts a corner. A target that doesn't cut ends the stroke: where the trail ends (`finishStroke`), or at once.
/// Then the button goes up and the tip rises before anything else. A stroke that is given up before its start was
/// reached never presses the button. What is asked for meanwhile waits until a trail is finished.
///
/// Thread: `wish`, `tip`, `strokeUnderWay`, `strokesBegun` and `targetsAhead` the user interface's, the rest the haptic
/// loop's. No lock, no allocation.
class SimulatedStylus final : public Stylus {
public:
    static constexpr double maximumSpeed = 400.0;  ///< mm/s, never exceeded
    static constexpr double acceleration = 6000.0; ///< mm/s², never exceeded but for the last 0.1 mm/s before rest
    static constexpr double lag = 0.025;           ///< s behind a moving target
    /// mm that hover heights have to spare: so far below one the tip may already move aside.
    static constexpr double clearance = 1.5;

    /// @param start where the tip is first, mm, setup frame; clear of everything
    explicit SimulatedStylus(const glm::dvec3& start);

    /// Hovering, the newest one counts; a stroke goes through all. One that gives a stroke up overtakes all before it.
    /// @return false where so many wait that this one is lost; there is always room to end a stroke
    bool wish(const StylusTarget& target) noexcept;
    /// Where the tip was at the newest reading, mm, setup frame.
    glm::dvec3 tip() noexcept;
    /// Whether a stroke was under way at the newest reading, its trail after the button's release among it.
    bool strokeUnderWay() noexcept;
    /// How many strokes had turned the spindle at the newest reading, in the order in which they were wished. One that
    /// is given up on the way to its start never does.
    std::uint64_t strokesBegun() noexcept;
    /// How many targets of strokes, of all that were wished, were not passed at the newest reading.
    std::size_t targetsAhead() noexcept;

    StylusDescription description() const override;
    Result<void> open() override;
    /// @param time s; goes on in steps of at most 10 ms, however late the reading is
    StylusState read(double time) noexcept override;
    /// A mouse has no motors: the force is for the eye alone.
    void write(const Wrench& wrench) noexcept override;
    void close() noexcept override;

private:
    enum class Phase : std::uint8_t {
        hover,
        approach, ///< at hover height to the stroke's start
        plunge,   ///< straight down to it, spindle on
        follow    ///< the stroke's targets, spindle on
    };
    /// What the user interface is shown.
    struct Shown {
        glm::dvec3 tip{0.0}; // mm
        bool strokeUnderWay = false;
        std::size_t targetsAhead = 0;
        std::uint64_t taken = 0; // cutting wishes, since the beginning
        std::uint64_t begun = 0; // strokes, since the beginning
    };
    void takeWishes() noexcept;
    bool apply(const StylusTarget& target) noexcept;
    void hoverOver(const StylusTarget& target) noexcept;
    glm::dvec3 goal() const noexcept;
    glm::dvec3 above(const glm::dvec3& place) const noexcept;
    void step(double seconds) noexcept;
    void changePhase() noexcept;

    static constexpr std::size_t mostWishes = 4096, roomToEnd = 64;
    static constexpr int mostTaken = 64; // wishes at a reading: a long stroke never holds the loop up
    struct Wish {
        StylusTarget target;
        std::uint32_t givenUp = 0; // how often a stroke had been given up when it was made
    };

    Ring<Wish> wishes_{mostWishes};
    std::atomic<std::uint32_t> givenUp_{0}; ///< by the user interface
    std::uint32_t givenUpSeen_ = 0;
    std::uint64_t wished_ = 0; ///< cutting, by the user interface
    std::uint64_t taken_ = 0;  ///< of these, by the loop
    std::uint64_t begun_ = 0;  ///< strokes that turned the spindle, by the loop
    Mailbox<Shown> places_;
    Shown shown_; ///< the user interface's copy
    StylusTarget target_;
    std::optional<StylusTarget> waiting_; ///< taken from the wishes; not to be followed yet
    std::optional<StylusTarget> after_;   ///< the stroke that is under way is being finished; then this
    TrailFollower trail_;
    glm::dvec3 tip_{0.0}, velocity_{0.0}; ///< mm, mm/s
    glm::dvec3 strokeStart_{0.0};         ///< mm
    double hoverHeight_ = 0.0;            ///< mm, z at which the way to the goal is clear
    std::optional<double> lastTime_;
    Phase phase_ = Phase::hover;
};

} // namespace burin
