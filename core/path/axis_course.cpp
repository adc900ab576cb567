// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/axis_course.h"

#include "core/base/parallel.h"
#include "core/geometry/upright.h"
#include "core/path/hand_interval.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double axisChord = 0.001;        // mm: chords of arcs
constexpr double largestTurn = pi / 180.0; // rad between two points
constexpr double widestStep = 0.5;         // mm between the points at which axes are computed
constexpr int mostHalvings = 6;            // of that distance, where the axis turns faster
constexpr double nearPart = 2.0;           // mm: a part farther away has no normal for the tool
constexpr double least = 1e-6;             // mm between the points at which axes are computed
constexpr double leastDirection = 0.05;    // of the length of a motion: a steeper one has no direction in plan
constexpr double keptTip = 1e-4,
                 keptAxis = 1e-5;           // mm, rad: points are left out that differ by less from a straight move
constexpr std::size_t longestLeftOut = 256; // points

/// A point at which the axis is computed.
struct Station {
    PathPoint point; ///< straight; its pose is that before the edit
    bool inserted = false;
    bool stated = true; ///< at a moment for which a program states the axis
    double way = 0.0;   ///< mm from the first station
    glm::dvec3 forward{0.0};
    std::optional<glm::dvec3> normal{}; ///< of the part, unit length
    double weight = 0.0;                ///< of this normal, 0 … 1
};

class Course {
public:
    Course(std::span<const PathPoint> points, const AxisRules& rules, double step)
        : rules_(rules), flutes_(flutePieces(rules.context.tool.cutter)) {
        Station first{points.front()};
        first.point.arc.reset();
        stations_.push_back(first);
        for (std::size_t i = 1; i < points.size(); ++i) addMove(points[i - 1], points[i], step);
        for (std::size_t i = 1; i < stations_.size(); ++i)
            stations_[i].way =
                stations_[i - 1].way + glm::distance(stations_[i - 1].point.pose.tip, stations_[i].point.pose.tip);
        blend_ = std::max(least, std::min(rules.edit.blend, 0.5 * length()));
        addStation(blend_);
        addStation(length() - blend_);
    }

    Result<void> findDirections(const Progress& progress) {
        setForwards();
        const bool ball = isBall();
        if (rules_.edit.from != ToolAxis::From::normal && (ball || rules_.edit.keep == ToolAxis::Keep::tip)) return {};
        askNormals(progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "tool axis", "", ""};
        if (rules_.edit.from != ToolAxis::From::normal) return {};
        if (std::ranges::none_of(stations_, [](const Station& s) { return s.normal.has_value(); }))
            return Error{ErrorCode::argumentInvalid, "tool axis", "the part's normal",
                         "a part of the path that is no farther than 2 mm from the part"};
        return {};
    }

    std::vector<TiltedPoint> tilted(bool blendsIn, bool blendsOut) const {
        const std::vector<glm::dvec3> targets = targetAxes();
        std::vector<TiltedPoint> made;
        made.reserve(stations_.size());
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            const Station& station = stations_[i];
            double share = 1.0;
            if (blendsIn) share = std::min(share, station.way / blend_);
            if (blendsOut) share = std::min(share, (length() - station.way) / blend_);
            const ToolPose& before = station.point.pose;
            TiltedPoint point{station.point, before, station.inserted};
            if (share > 0.0) {
                point.point.pose.axis = directionBetween(before.axis, targets[i], share);
                if (rules_.edit.keep == ToolAxis::Keep::contact)
                    point.point.pose.tip = touching(i, before, point.point.pose.axis);
            }
            made.push_back(point);
        }
        return made;
    }

private:
    double length() const noexcept { return stations_.back().way; }

    /// Where the axis begins or ends to turn, unless there is one.
    void addStation(double way) {
        const auto after = std::ranges::lower_bound(stations_, way, {}, &Station::way);
        if (after == stations_.begin() || after == stations_.end()) return;
        const Station &from = *(after - 1), &to = *after;
        if (way - from.way < least || to.way - way < least) return;
        const double share = (way - from.way) / (to.way - from.way);
        const ToolPose &start = from.point.pose, &end = to.point.pose;
        Station station = between(from.point, to.point,
                                  {glm::mix(start.tip, end.tip, share), directionBetween(start.axis, end.axis, share)});
        station.way = way;
        stations_.insert(after, station);
    }

    bool isBall() const noexcept { return rules_.context.tool.cutter.type == CutterType::ball; }

    void addMove(const PathPoint& from, const PathPoint& to, double step) {
        std::vector<glm::dvec3> ends{to.pose.tip};
        if (to.arc)
            flatten({from.pose.tip, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise}, axisChord, ends);
        const bool chords = ends.size() > 1;
        const ToolPose start = from.pose;
        ToolPose at = start;
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const double share = static_cast<double>(k + 1) / static_cast<double>(ends.size());
            const ToolPose end{ends[k], directionBetween(start.axis, to.pose.axis, share)};
            if (rules_.edit.from == ToolAxis::From::program && !chords)
                addStated(from, to);
            else
                addDivided(from, to, at, end, step);
            at = end;
        }
        Station& last = stations_.back();
        last.point.sample = to.sample;
        last.point.source = to.source;
        last.inserted = false;
        last.stated = true;
    }
    /// The station at a pose on the move from one point to another.
    Station between(const PathPoint& from, const PathPoint& to, const ToolPose& pose) const {
        Station station{to};
        station.point.arc.reset();
        station.point.pose = pose;
        if (hasMoment(from)) {
            station.point.source = from.source;
            station.point.sample = from.sample;
        }
        station.inserted = true;
        station.stated = false;
        return station;
    }
    void addDivided(const PathPoint& from, const PathPoint& to, const ToolPose& at, const ToolPose& end, double step) {
        const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(glm::distance(at.tip, end.tip) / step)));
        for (std::size_t i = 1; i <= parts; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(parts);
            const glm::dvec3 tip = i == parts ? end.tip : glm::mix(at.tip, end.tip, share);
            stations_.push_back(between(from, to, {tip, directionBetween(at.axis, end.axis, share)}));
        }
    }
    /// A line that an edit made of several moves of a program is divided again, evenly, as it states an axis for each.
    void addStated(const PathPoint& from, const PathPoint& to) {
        if (rules_.stated != nullptr && from.source == to.source && hasMoment(from) && hasMoment(to)) {
            const std::vector<std::int64_t> ticks = rules_.stated->between(from.source, from.sample, to.sample);
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                const double share = static_cast<double>(i + 1) / static_cast<double>(ticks.size() + 1);
                Station station = between(from, to, {glm::mix(from.pose.tip, to.pose.tip, share), from.pose.axis});
                station.point.sample = ticks[i];
                station.stated = true;
                stations_.push_back(station);
            }
        }
        stations_.push_back(between(from, to, to.pose));
    }

    glm::dvec3 placeAt(double way) const {
        const auto after = std::ranges::lower_bound(stations_, way, {}, &Station::way);
        if (after == stations_.begin()) return stations_.front().point.pose.tip;
        if (after == stations_.end()) return stations_.back().point.pose.tip;
        const Station& before = *(after - 1);
        const double length = after->way - before.way;
        return glm::mix(before.point.pose.tip, after->point.pose.tip, length > 0.0 ? (way - before.way) / length : 1.0);
    }

    /// The direction of motion, averaged over the blend, in plan unless the axis is counted from the part's normal;
    /// where the tool goes straight up or down, or to a stroke and from it, that nearest to it along the path.
    void setForwards() {
        const double half = 0.5 * rules_.edit.blend, end = stations_.back().way;
        std::optional<glm::dvec3> last;
        std::vector<bool> known(stations_.size(), false);
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            Station& station = stations_[i];
            const double from = std::max(0.0, station.way - half), to = std::min(end, station.way + half);
            const glm::dvec3 way = placeAt(to) - placeAt(from);
            const bool inPlan = rules_.edit.from != ToolAxis::From::normal;
            const glm::dvec3 direction(way.x, way.y, inPlan ? 0.0 : way.z);
            const double length = glm::length(direction);
            const bool ofStroke = station.point.kind == MoveKind::cut && hasMoment(station.point);
            if ((inPlan || ofStroke) && length > leastDirection * (to - from) && length > 0.0) {
                last = direction / length;
                known[i] = true;
            }
            station.forward = last.value_or(glm::dvec3(0.0));
        }
        last.reset();
        for (std::size_t i = stations_.size(); i-- > 0;) {
            if (known[i]) last = stations_[i].forward;
            if (stations_[i].forward == glm::dvec3(0.0))
                stations_[i].forward = last.value_or(glm::dvec3(1.0, 0.0, 0.0));
        }
    }

    void askNormals(const Progress& progress) {
        parallelFor(std::size_t{0}, stations_.size(), [&](std::size_t i) {
            if (progress.cancelled()) return;
            Station& station = stations_[i];
            const ToolClearance found = rules_.guard.clearance(station.point.pose, nearPart);
            if (!(found.clearance < nearPart)) return;
            station.normal = found.away;
            station.weight = 1.0 - std::max(0.0, found.clearance) / nearPart;
        });
    }

    /// The normal at a station, averaged over the blend. @param elsewhere what counts as one where the part is far
    glm::dvec3 normalAt(std::size_t i, const std::optional<glm::dvec3>& elsewhere) const {
        const double half = 0.5 * rules_.edit.blend;
        glm::dvec3 sum(0.0);
        const auto take = [&](std::size_t k) {
            const Station& station = stations_[k];
            if (std::abs(station.way - stations_[i].way) > half) return false;
            if (station.normal) sum += station.weight * *station.normal;
            if (elsewhere) sum += (1.0 - station.weight) * *elsewhere;
            return true;
        };
        for (std::size_t k = i; k < stations_.size() && take(k); ++k) {
        }
        for (std::size_t k = i; k-- > 0 && take(k);) {
        }
        return glm::length(sum) > 1e-9 ? glm::normalize(sum) : glm::dvec3(0.0);
    }

    std::vector<glm::dvec3> targetAxes() const {
        const ToolAxis& edit = rules_.edit;
        std::vector<glm::dvec3> axes(stations_.size(), uprightAxis);
        if (edit.from == ToolAxis::From::program) return statedAxes();
        if (edit.from == ToolAxis::From::fixed) {
            const double level = std::sin(edit.inclination);
            std::ranges::fill(axes, glm::dvec3(level * std::cos(edit.azimuth), level * std::sin(edit.azimuth),
                                               std::cos(edit.inclination)));
            return axes;
        }
        glm::dvec3 last = uprightAxis;
        std::vector<glm::dvec3> origins(stations_.size(), uprightAxis);
        if (edit.from == ToolAxis::From::normal) {
            for (std::size_t i = 0; i < stations_.size(); ++i) origins[i] = normalAt(i, std::nullopt);
            const auto first = std::ranges::find_if(origins, [](const glm::dvec3& n) { return n != glm::dvec3(0.0); });
            if (first != origins.end()) last = *first;
        }
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            if (origins[i] != glm::dvec3(0.0)) last = origins[i]; // else the part is far: as at the point before
            axes[i] = leaning(last, stations_[i].forward);
        }
        return axes;
    }
    glm::dvec3 leaning(const glm::dvec3& normal, const glm::dvec3& motion) const {
        const ToolAxis& edit = rules_.edit;
        glm::dvec3 forward = motion - glm::dot(motion, normal) * normal;
        forward = glm::length(forward) > 1e-6 ? glm::normalize(forward) : glm::dvec3(0.0);
        const glm::dvec3 left = glm::cross(normal, forward);
        const glm::dvec3 axis = std::cos(edit.tilt) * (std::cos(edit.lead) * normal + std::sin(edit.lead) * forward) +
                                std::sin(edit.tilt) * left;
        return glm::length(axis) > 1e-9 ? glm::normalize(axis) : normal;
    }
    /// Between stated moments the axis turns evenly.
    std::vector<glm::dvec3> statedAxes() const {
        std::vector<glm::dvec3> axes(stations_.size(), uprightAxis);
        std::vector<std::size_t> known;
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            const PathPoint& point = stations_[i].point;
            if (!stations_[i].stated || !hasMoment(point) || rules_.stated == nullptr) continue;
            axes[i] = rules_.stated->at(momentOf(point));
            known.push_back(i);
        }
        if (known.empty()) return axes;
        std::fill(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(known.front()), axes[known.front()]);
        std::fill(axes.begin() + static_cast<std::ptrdiff_t>(known.back()), axes.end(), axes[known.back()]);
        for (std::size_t k = 1; k < known.size(); ++k)
            for (std::size_t i = known[k - 1] + 1; i < known[k]; ++i) {
                const double way = stations_[known[k]].way - stations_[known[k - 1]].way;
                const double share = way > 0.0 ? (stations_[i].way - stations_[known[k - 1]].way) / way : 1.0;
                axes[i] = directionBetween(axes[known[k - 1]], axes[known[k]], share);
            }
        return axes;
    }

    /// The tip at which a tool with another axis touches what it touched before.
    glm::dvec3 touching(std::size_t i, const ToolPose& before, const glm::dvec3& axis) const {
        const Tool& tool = rules_.context.tool;
        if (isBall()) return before.tip + tool.cutter.radius() * (before.axis - axis);
        const glm::dvec3& forward = stations_[i].forward;
        const glm::dvec3 upward = before.axis - glm::dot(before.axis, forward) * forward;
        const glm::dvec3 normal = normalAt(i, glm::length(upward) > 1e-6 ? glm::normalize(upward) : before.axis);
        if (normal == glm::dvec3(0.0)) return before.tip;
        return before.tip + (fluteReach(flutes_, axis, -normal) - fluteReach(flutes_, before.axis, -normal)) * normal;
    }

    const AxisRules& rules_;
    std::vector<RevolvedPiece> flutes_;
    std::vector<Station> stations_;
    double blend_ = 0.0; ///< mm, over which the axis turns at the borders
};

double turnBetween(const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool turnsLittle(const std::vector<TiltedPoint>& points) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].inserted || points[i - 1].inserted)
            if (turnBetween(points[i - 1].point.pose.axis, points[i].point.pose.axis) > largestTurn) return false;
    return true;
}

/// Whether a straight move from one point to another, on which the tool turns evenly, passes all between.
bool passesAll(const std::vector<TiltedPoint>& points, std::size_t from, std::size_t to) {
    const ToolPose &a = points[from].point.pose, &b = points[to].point.pose;
    if (turnBetween(a.axis, b.axis) > largestTurn) return false;
    const double length = glm::distance(a.tip, b.tip);
    for (std::size_t i = from + 1; i < to; ++i) {
        const ToolPose& pose = points[i].point.pose;
        const double share = length > 0.0 ? glm::dot(pose.tip - a.tip, b.tip - a.tip) / (length * length) : 0.0;
        if (share < 0.0 || share > 1.0 || glm::distance(pose.tip, glm::mix(a.tip, b.tip, share)) > keptTip ||
            turnBetween(pose.axis, directionBetween(a.axis, b.axis, share)) > keptAxis)
            return false;
    }
    return true;
}

/// Leaves out inserted points that change nothing.
std::vector<TiltedPoint> withoutNeedless(const std::vector<TiltedPoint>& points) {
    std::vector<TiltedPoint> kept{points.front()};
    for (std::size_t at = 0; at + 1 < points.size();) {
        std::size_t next = at + 1;
        while (next + 1 < points.size() && points[next].inserted && next - at < longestLeftOut &&
               passesAll(points, at, next + 1))
            ++next;
        kept.push_back(points[next]);
        at = next;
    }
    return kept;
}

} // namespace

Result<std::vector<TiltedPoint>> tiltedCourse(std::span<const PathPoint> points, bool blendsIn, bool blendsOut,
                                              const AxisRules& rules, const Progress& progress) {
    double step = std::min(widestStep, 0.05 * rules.edit.blend);
    for (int halvings = 0;; ++halvings, step *= 0.5) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "tool axis", "", ""};
        Course course(points, rules, step);
        if (Result<void> found = course.findDirections(progress); !found) return std::move(found).error();
        const std::vector<TiltedPoint> made = course.tilted(blendsIn, blendsOut);
        if (rules.edit.from == ToolAxis::From::program || halvings == mostHalvings || turnsLittle(made))
            return withoutNeedless(made);
    }
}

double fluteReach(std::span<const RevolvedPiece> flutes, const glm::dvec3& axis, const glm::dvec3& direction) noexcept {
    constexpr double golden = 0.6180339887498949;
    const double along = glm::dot(axis, direction), sine = std::sqrt(std::max(0.0, 1.0 - along * along));
    double most = 0.0;
    for (const RevolvedPiece& piece : flutes) {
        const auto reach = [&](double height) { return height * along + radiusAt(piece, height) * sine; };
        double low = piece.bottom, high = piece.top; // a convex piece: the reach has one maximum
        most = std::max({most, reach(low), reach(high)});
        for (int i = 0; i < 80 && high - low > 1e-12; ++i) {
            const double a = high - golden * (high - low), b = low + golden * (high - low);
            if (reach(a) < reach(b))
                low = a;
            else
                high = b;
        }
        most = std::max(most, reach(0.5 * (low + high)));
    }
    return most;
}

glm::dvec3 directionBetween(const glm::dvec3& from, const glm::dvec3& to, double share) noexcept {
    if (share >= 1.0 || from == to) return to;
    const double angle = turnBetween(from, to), sine = std::sin(angle);
    if (sine < 1e-9) return glm::normalize(glm::mix(from, to, share));
    return glm::normalize((std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / sine);
}

} // namespace burin
