// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/evaluate.h"
#include "core/path/omission.h"
#include "core/path/path.h"
#include "core/path/path_source.h"
#include "core/path/stated_axes.h"
#include "core/path/stated_feeds.h"
#include "core/path/stroke_entry.h"
#include "core/recording/generated_moves.h"
#include "core/recording/sample.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

class HandTrail;

/// A point of a stroke under edit.
struct StrokePoint {
    ToolPose pose;                ///< setup frame
    std::int64_t sample = 0;      ///< Moment::tick in the source; for points that an edit inserted, of the one before
    bool removes = false;         ///< the motion that ends here removed material
    bool onBoundary = false;      ///< the part held the tool here
    std::optional<PathArc> arc{}; ///< of the motion that ends here; empty: straight
};

/// An interval of one source without a gap: the tool goes from point to point in straight lines, until edits fit arcs.
struct PathStroke {
    std::int64_t source = 0; ///< PathSource::id; 0: created by an edit
    double allowance = 0.0;  ///< mm, of the source
    double required = 0.0; ///< mm that later edits keep between tool and part: the allowance, or what HoldOut achieved
    /// s between the points, as long as no edit thinned them; 0: generated moves, which have no timing and are left
    /// unchanged by edits that depend on it.
    double tickPeriod = 0.001;
    std::vector<StrokePoint> points;

    bool inTime() const noexcept { return tickPeriod > 0.0; }
};

/// Whether a point of a stroke was made in an interval of a source.
inline bool contains(const SourceInterval& interval, const PathStroke& stroke, const StrokePoint& point) noexcept {
    return interval.contains({stroke.source, point.sample});
}
/// Whether any of its points was made in the interval.
bool touches(const SourceInterval& interval, const PathStroke& stroke) noexcept;
/// Whether the range of a stroke's moments contains a moment.
bool holds(const PathStroke& stroke, const Moment& moment) noexcept;

/// The stroke in the opposite direction: flags and arc of a motion stay with it, though it then ends at its other end.
PathStroke reversed(const PathStroke& stroke);

/// A path between two edits: strokes until they are linked, points from then on. Until ToolAxis, the last step, all
/// poses have `uprightAxis`, which is checked when the sources are read; a ball that a program tilts stands upright
/// about the same centre, and `axes` keeps its axes.
struct PathUnderEdit {
    std::vector<PathStroke> strokes;
    std::vector<PathPoint> points; ///< created by Link from the strokes
    bool linked = false;
    double spindleSpeed = 0.0; ///< 1/min; 0: not decided yet
    Coolant coolant = Coolant::off;
    double leastFeed = 0.0;                    ///< mm/min, as Path::leastFeed
    std::shared_ptr<const HandTrail> hand;     ///< of its sources; null: not known
    std::shared_ptr<const StatedFeeds> stated; ///< stated by programs among its sources; null: none is known
    std::shared_ptr<const StatedAxes> axes;    ///< stated by programs among its sources; null: none is known
    std::map<std::int64_t, double> allowances; ///< mm, by source
    bool rampsIn = false;                      ///< its links descend by ramps, which have their own feed
    std::vector<StrokeEntry> entries;          ///< into material, by the edit that is applied now
    std::vector<Omission> omissions;           ///< by the edit that is applied now
    std::vector<glm::dvec3> inserted;          ///< mm, setup frame: points that the edit applied now has inserted
    double lengthBefore = 0.0; ///< mm of its strokes including those parts, if the edit may leave out any

    std::size_t count() const noexcept;
};

/// The part of a path that comes from one of its sources.
struct SourceStrokes {
    SourceInfo info;
    std::vector<PathStroke> strokes;
    std::vector<StatedFeed> stated{}; ///< by a program; moments ascend
};

/// The strokes of generated moves or of a program's moves, with their axes: `evaluate` refuses tilted ones unless they
/// are those of a ball.
Result<SourceStrokes> strokesOf(const GeneratedMoves& moves);

/// Makes the strokes of a take while its samples are read in order: the proxy's tip at every tick. Where the loop was
/// late, up to 100 points are interpolated on the straight line that the tool moved along, so that points stay one tick
/// apart in time. Intervals in which shank or holder touched something, in which the spindle stood still, or which were
/// undone, are left out. A new stroke begins there, where more than a few ticks are missing, and where the tip moved
/// faster than a hand can.
class StrokeReader {
public:
    explicit StrokeReader(const TakeOutline& take);
    StrokeReader(const StrokeReader&) = delete;
    StrokeReader& operator=(const StrokeReader&) = delete;

    /// @param next samples, following those of the previous call. Errors: notSupported (an axis that is not +Z).
    Result<void> add(std::span<const Sample> next);
    /// The strokes of all samples that were added; call it once only.
    SourceStrokes finish();

private:
    /// Counts the points missing between two samples, so that points have the spacing in time that filters assume: in a
    /// late loop one tick lasts for several periods.
    class EvenTicks {
    public:
        explicit EvenTicks(double period) : period_(period) {}
        void begin(const Sample& sample) noexcept;
        /// Counted from the first sample and not from the last one, so that fractions of a period don't accumulate.
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
/// The same for a take in memory.
Result<SourceStrokes> recordedStrokes(const Take& take);

/// The points of a state: its linked points, or the strokes one after the other, each reached by a rapid move.
std::vector<PathPoint> pointsOf(const PathUnderEdit& state);

} // namespace burin
