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

/// Hands the simulated stylus its targets in their order, as fast as it has room for them: a stroke may have more
/// places than the stylus holds, and may have to wait for its recording. Nothing is lost. Thread: user interface.
class StrokeFeed final : public QObject {
    Q_OBJECT
public:
    enum class Height : std::uint8_t {
        given, ///< the target has its z
        later  ///< it gets its z when its turn comes
    };
    /// @param stylus outlives it; @param heightAt z of the tip, mm, from x and y: of targets with Height::later
    explicit StrokeFeed(SimulatedStylus& stylus, std::function<double(const glm::dvec3&)> heightAt,
                        QObject* parent = nullptr);

    /// A target of a stroke, or one that ends it where its trail ends. Of targets that don't cut the newest counts.
    void add(const StylusTarget& target, Height height = Height::given);
    /// Ends what is under way, here and in the stylus: what waits is forgotten.
    void giveUp(const StylusTarget& target);

    void hold(); ///< strokes wait from now on
    void goOn();
    bool waits() const noexcept { return !queue_.empty(); } ///< the stylus doesn't have all yet

    bool heightsAreOpen() const; ///< some target that waits has its height still to come

    /// The places that the tool has not passed, stroke by stroke, before those of the one under way its own; mm, setup
    /// frame. Empty: it has nothing to catch up with. Those whose height comes later are known once they are handed
    /// over.
    PlaceChains tail();

private:
    struct Entry {
        StylusTarget target;
        Height height = Height::given;
    };
    /// A place of a stroke.
    struct Place {
        glm::dvec3 place{0.0}; // mm
        bool begins = false;   // the stroke
    };
    void feed();

    SimulatedStylus& stylus_;
    std::function<double(const glm::dvec3&)> heightAt_;
    QTimer timer_;
    std::deque<Entry> queue_;
    std::vector<Place> handed_; ///< of the stroke that is under way, and those that the stylus has behind it
    bool between_ = true;       ///< strokes: the newest target that was handed over doesn't cut
    bool held_ = false;
};

} // namespace burin
