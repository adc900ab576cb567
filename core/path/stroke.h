// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/evaluate.h"
#include "core/path/omission.h"
#include "core/path/path.h"
#include "core/path/path_source.h"
#include "core/path/stated_feeds.h"
#include "core/path/stroke_entry.h"
#include "core/recording/generated_moves.h"
#include "core/recording/sample.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

class HandTrail;

/// A place of a stretch under edit.
struct StrokePoint {
    ToolPose pose; ///< setup frame
    std::int64_t sample =
        0; ///< Moment::tick within the source; of the moment before, for points that an edit put between two
    bool removes = false;         ///< the motion that ends here took material away
    bool onBoundary = false;      ///< the part held the tool here
    std::optional<PathArc> arc{}; ///< of the motion that ends here; nothing: straight
};

/// A stretch of one source without a gap: the tool goes from point to point in straight lines, until edits fit arcs.
struct PathStroke {
    std::int64_t source = 0; ///< PathSource::id; 0: an edit made it of nothing
    double allowance = 0.0;  ///< mm, of the source
    double required =
        0.0; ///< mm that later edits keep the tool from the part by: the allowance, or what HoldOut reached
    /// s between the points, as long as no edit thinned them; 0: they are a planner's, which have no time of their own,
    /// and edits that go by the hand's time leave them as they are.
    double tickPeriod = 0.001;
    std::vector<StrokePoint> points;

    bool inTime() const noexcept { return tickPeriod > 0.0; }
};

/// Whether a point of a stroke was made in a stretch of the hand.
inline bool contains(const SourceStretch& stretch, const PathStroke& stroke, const StrokePoint& point) noexcept {
    return stretch.contains({stroke.source, point.sample});
}
/// Whether any of its points was.
bool touches(const SourceStretch& stretch, const PathStroke& stroke) noexcept;
/// Whether a stroke goes through a moment.
bool holds(const PathStroke& stroke, const Moment& moment) noexcept;

/// The stroke gone the other way: what a motion did, and its arc, stay with it, though it ends at its other end then.
PathStroke reversed(const PathStroke& stroke);

/// A path between two edits: strokes until they are linked, points from then on. Edits are for upright tools: all its
/// poses have `uprightAxis`, which its sources are held to before it is made.
struct PathUnderEdit {
    std::vector<PathStroke> strokes;
    std::vector<PathPoint> points; ///< what Link made of the strokes
    bool linked = false;
    double spindleSpeed = 0.0; ///< 1/min; 0: not decided yet
    Coolant coolant = Coolant::off;
    double leastFeed = 0.0;                    ///< mm/min, as Path::leastFeed
    std::shared_ptr<const HandTrail> hand;     ///< that it was made of; nothing: not known
    std::shared_ptr<const StatedFeeds> stated; ///< by programs that it was made of; nothing: none is known
    bool rampsIn = false;                      ///< its links go down ramps, which have a feed of their own
    std::vector<StrokeEntry> entries;          ///< into material, by the edit that is applied now
    std::vector<Omission> omissions;           ///< by the edit that is applied now
    double lengthBefore = 0.0; ///< mm of its strokes, those parts among them, where it may leave out any

    std::size_t count() const noexcept;
};

/// What a path is made of out of one of its sources.
struct SourceStrokes {
    SourceInfo info;
    std::vector<PathStroke> strokes;
    std::vector<StatedFeed> stated{}; ///< of a program; moments rise
};

/// The strokes of a planner's, or a program's, moves. Errors: notSupported (an axis that is not +Z).
Result<SourceStrokes> strokesOf(const GeneratedMoves& moves);

/// Makes the strokes of a take while its samples are read in their order: the proxy's tip at every tick. Where the loop
/// came late, points on the straight way that the tool went are put between, up to 100, so that points stay a tick
/// apart in time. A stretch in which shank or holder touched something, in which the spindle stood, or which was taken
/// back, is left out. A new stroke begins there, where more than a few ticks are missing, and where the tip went faster
/// than a hand can.
class StrokeReader {
public:
    explicit StrokeReader(const TakeOutline& take);
    StrokeReader(const StrokeReader&) = delete;
    StrokeReader& operator=(const StrokeReader&) = delete;

    /// @param next samples, behind those of the call before. Errors: notSupported (an axis that is not +Z).
    Result<void> add(std::span<const Sample> next);
    /// Of all that was added; once.
    SourceStrokes finish();

private:
    /// Tells how many points are missing between two samples, for them to be as far apart in time as filters take them
    /// to be: a loop that comes late has one tick for several periods.
    class EvenTicks {
    public:
        explicit EvenTicks(double period) : period_(period) {}
        void begin(const Sample& sample) noexcept;
        /// Counted from the first sample and not from the last one, so that odds of a period don't add up.
        std::int64_t missingBefore(const Sample& sample) noexcept;

    private:
        double period_;
        std::uint64_t tick_ = 0;
        double time_ = 0.0;
        std::int64_t last_ = 0; ///< periods from the first sample
    };
    void add(const Sample& sample);

    SourceStrokes made_;
    std::vector<SampleRange> ranges_;
    UndoneSamples undone_; ///< of `ranges_`
    EvenTicks ticks_;
    bool begins_ = true;
    std::uint64_t lastTick_ = 0, index_ = 0;
    double lastTime_ = 0.0;
};
/// The same of a take in memory.
Result<SourceStrokes> recordedStrokes(const Take& take);

/// The points of a state: its linked points, or the strokes one behind the other, each reached by a rapid move.
std::vector<PathPoint> pointsOf(const PathUnderEdit& state);

} // namespace burin
