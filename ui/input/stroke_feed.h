// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/simulated_stylus.h"
#include "ui/scene/place_chains.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace burin {

/// Passes targets to the simulated stylus in order, as fast as it has room for them: a stroke may have more points than
/// the stylus holds, and may have to wait for its recording. No target is lost. Thread: user interface.
class StrokeFeed final : public QObject {
    Q_OBJECT
public:
    enum class Height : std::uint8_t {
        given, ///< z is given with the target
        later  ///< z is computed when the target is passed on
    };
    /// @param stylus outlives it; @param heightAt z of the tip, mm, from x and y: for targets with Height::later
    explicit StrokeFeed(SimulatedStylus& stylus, std::function<double(const glm::dvec3&)> heightAt,
                        QObject* parent = nullptr);

    /// Adds a target of a stroke, or one that ends the stroke at the end of its trail. Of consecutive targets that
    /// don't cut only the newest is used.
    void add(const StylusTarget& target, Height height = Height::given);
    /// Ends the current motion, here and in the stylus; waiting targets are discarded.
    void giveUp(const StylusTarget& target);

    void hold(); ///< strokes wait from now on
    void goOn();
    bool waits() const noexcept { return !queue_.empty(); } ///< the stylus has not received all targets yet

    bool heightsAreOpen() const; ///< some waiting target has Height::later

    /// The points that the tool has not passed, one chain for each stroke; the chain of the stroke under way begins at
    /// the tool's own position; mm, setup frame. Empty: the tool has nothing to catch up with. Points with
    /// Height::later are included once they are passed on.
    PlaceChains tail();

private:
    struct Entry {
        StylusTarget target;
        Height height = Height::given;
    };
    /// A point of a stroke.
    struct Place {
        glm::dvec3 place{0.0}; // mm
        bool begins = false;   // whether it begins the stroke
    };
    void feed();

    SimulatedStylus& stylus_;
    std::function<double(const glm::dvec3&)> heightAt_;
    QTimer timer_;
    std::deque<Entry> queue_;
    std::vector<Place> handed_; ///< points of the stroke under way, and of those that follow it in the stylus
    bool between_ = true;       ///< between strokes: the newest target passed on doesn't cut
    bool held_ = false;
};

} // namespace burin
