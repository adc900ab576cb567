// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/rounded_line.h"

#include "core/nc/arc_steps.h"
#include "core/path/back_steps.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

namespace burin {
namespace {

constexpr double farthestInSteps = 2.0;
constexpr std::size_t longestLeftOut = 256; // largest number of points between two that are kept
constexpr std::size_t nearEnd = 8;          // number of points that are considered together

/// A series of straight feed moves at the positions that a program can state.
class RoundedRun {
public:
    /// @param run the series; the first move is its start point and is kept, as is the last one
    RoundedRun(std::span<const NcMove> run, const NumberWords& numbers) : run_(run), numbers_(numbers) {
        for (std::size_t i = 0; i < run.size(); ++i) take(i);
    }

    struct Point {
        std::size_t number = 0; ///< in the run
        StepPlace steps{};
        bool moved = false; ///< to another position than the rounded one
    };
    /// The points that are kept.
    const std::vector<Point>& points() const noexcept { return points_; }

private:
    bool isFixed(std::size_t number) const noexcept { return number == 0 || number + 1 == run_.size(); }
    glm::dvec3 placeOf(const StepPlace& steps) const {
        return {numbers_.millimetresOf(steps[0]), numbers_.millimetresOf(steps[1]), numbers_.millimetresOf(steps[2])};
    }
    bool stepsBack(const StepPlace& from, const StepPlace& at, const StepPlace& to) const {
        return isBackStep(placeOf(from), placeOf(at), placeOf(to));
    }

    void take(std::size_t number) {
        const glm::dvec3& target = run_[number].target.linear();
        const Point point{
            number, {numbers_.stepsOf(target.x), numbers_.stepsOf(target.y), numbers_.stepsOf(target.z)}, false};
        if (!points_.empty() && points_.back().steps == point.steps) {
            if (!isFixed(number)) return;
            if (!isFixed(points_.back().number)) points_.pop_back();
        }
        points_.push_back(point);
        while (settle()) {
        }
    }

    bool stepsBackAt(std::size_t index) const {
        return index >= 1 && index + 1 < points_.size() &&
               stepsBack(points_[index - 1].steps, points_[index].steps, points_[index + 1].steps);
    }

    /// Removes the back-step at the last point but one. @return whether there may be another
    bool settle() {
        if (points_.size() < 3 || !stepsBackAt(points_.size() - 2)) return false;
        const std::size_t size = points_.size();
        if (shorten() || move(size - 2) || move(size - 3) || move(size - 1)) return true;
        return moveTwo(size - 3) || moveTwo(size - 2) || (size > 3 && moveTwo(size - 4));
    }

    /// Leaves out points near the end, as few as possible, to remove the back-step.
    bool shorten() {
        const std::size_t size = points_.size(), first = size - std::min(size, nearEnd);
        for (std::size_t count = 1; count + 2 <= size - first; ++count)
            for (const std::size_t to : {size - 1, size - 2}) {
                if (to < first + count + 1) continue;
                const std::size_t from = to - count - 1;
                if (!leavesLittle(points_[from], points_[to])) continue;
                std::vector<Point> left(points_.begin() + static_cast<std::ptrdiff_t>(from > 0 ? from - 1 : 0),
                                        points_.begin() + static_cast<std::ptrdiff_t>(from + 1));
                left.insert(left.end(), points_.begin() + static_cast<std::ptrdiff_t>(to), points_.end());
                bool clear = true;
                for (std::size_t i = 1; i + 1 < left.size(); ++i)
                    clear = clear && !stepsBack(left[i - 1].steps, left[i].steps, left[i + 1].steps);
                if (!clear) continue;
                points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(from + 1),
                              points_.begin() + static_cast<std::ptrdiff_t>(to));
                if (points_[from].steps == points_[from + 1].steps) merge(from);
                return true;
            }
        return false;
    }

    /// Merges a point with the next one if both are the same for the control.
    void merge(std::size_t index) {
        const std::size_t less = isFixed(points_[index + 1].number) ? index : index + 1;
        if (!isFixed(points_[less].number)) points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(less));
    }

    /// Whether all points between two are within the allowed number of steps of the line between these.
    bool leavesLittle(const Point& from, const Point& to) const {
        if (to.number - from.number > longestLeftOut) return false;
        const double most = farthestInSteps * numbers_.step();
        for (std::size_t i = from.number + 1; i < to.number; ++i)
            if (distanceToSegment(run_[i].target.linear(), placeOf(from.steps), placeOf(to.steps)) > most) return false;
        return true;
    }

    /// Moves a point to each position around its current one that is no farther than `farthest` mm from its exact
    /// position, and calls `accept` with the distance; `accept` has to record the position. The point is restored
    /// afterwards.
    template <class Accept>
    void atEachPosition(std::size_t index, double farthest, const Accept& accept) {
        const Point before = points_[index];
        const glm::dvec3& exact = run_[before.number].target.linear();
        for (int choice = 0; choice < 125; ++choice) {
            const std::array<int, 3> by{choice % 5 - 2, choice / 5 % 5 - 2, choice / 25 - 2};
            for (std::size_t axis = 0; axis < 3; ++axis) points_[index].steps[axis] = before.steps[axis] + by[axis];
            const double distance = glm::distance(placeOf(points_[index].steps), exact);
            if (distance <= farthest && staysLevel(index, by)) accept(distance);
        }
        points_[index] = before;
    }

    /// Moves a point to the nearest other position at which nothing steps back; it stays if there is none.
    bool move(std::size_t index) {
        if (isFixed(points_[index].number)) return false;
        double least = farthestInSteps * numbers_.step();
        std::optional<StepPlace> best;
        atEachPosition(index, least, [&](double distance) {
            if (distance > least || touchesNeighbour(index)) return;
            if (stepsBackAt(index - 1) || stepsBackAt(index) || stepsBackAt(index + 1)) return;
            least = distance;
            best = points_[index].steps;
        });
        if (best) points_[index] = {points_[index].number, *best, true};
        return best.has_value();
    }

    /// The same for a point together with the next one, if neither of them alone suffices.
    bool moveTwo(std::size_t index) {
        if (index + 1 >= points_.size() || isFixed(points_[index].number) || isFixed(points_[index + 1].number))
            return false;
        const double farthest = farthestInSteps * numbers_.step();
        double least = 2.0 * farthest;
        std::optional<std::pair<StepPlace, StepPlace>> best;
        atEachPosition(index, farthest, [&](double one) {
            if (stepsBackAt(index - 1) || points_[index - 1].steps == points_[index].steps) return;
            atEachPosition(index + 1, farthest, [&](double other) {
                if (one + other > least || touchesNeighbour(index + 1)) return;
                if (stepsBackAt(index) || stepsBackAt(index + 1) || stepsBackAt(index + 2)) return;
                least = one + other;
                best = {points_[index].steps, points_[index + 1].steps};
            });
        });
        if (!best) return false;
        points_[index] = {points_[index].number, best->first, true};
        points_[index + 1] = {points_[index + 1].number, best->second, true};
        return true;
    }

    bool touchesNeighbour(std::size_t index) const {
        return points_[index - 1].steps == points_[index].steps ||
               (index + 1 < points_.size() && points_[index + 1].steps == points_[index].steps);
    }

    /// Whether a point moves along no axis along which its neighbours do not move.
    bool staysLevel(std::size_t index, const std::array<int, 3>& by) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (by[axis] == 0) continue;
            const long long level = points_[index].steps[axis] - by[axis];
            const bool before = points_[index - 1].steps[axis] == level;
            const bool behind = index + 1 == points_.size() || points_[index + 1].steps[axis] == level;
            if (before && behind) return false;
        }
        return true;
    }

    std::span<const NcMove> run_;
    const NumberWords& numbers_;
    std::vector<Point> points_;
};

/// Appends a series, without its start point.
void append(std::vector<NcMove>& moves, std::span<const NcMove> run, const NumberWords& numbers) {
    const RoundedRun rounded(run, numbers);
    std::size_t next = 1;
    for (const RoundedRun::Point& point : rounded.points()) {
        if (point.number == 0) continue;
        NcMove move = run[point.number];
        std::string comment;
        double speed = 0.0; // the last one requested by a point that is left out
        std::optional<Coolant> coolant;
        for (; next < point.number; ++next) {
            if (comment.empty()) comment = run[next].comment;
            if (run[next].spindleSpeed > 0.0) speed = run[next].spindleSpeed;
            if (run[next].coolant) coolant = run[next].coolant;
        }
        next = point.number + 1;
        if (move.comment.empty()) move.comment = std::move(comment);
        if (!(move.spindleSpeed > 0.0)) move.spindleSpeed = speed;
        if (!move.coolant) move.coolant = coolant;
        if (point.moved)
            for (const Axis axis : linearAxes)
                move.target.set(axis, numbers.millimetresOf(point.steps[static_cast<std::size_t>(axis)]));
        moves.push_back(std::move(move));
    }
}

/// Whether a rotary axis turns on a move.
bool turns(const std::vector<NcMove>& moves, std::size_t i) {
    if (i == 0 || (moves[i].target.onlyLinear() && moves[i - 1].target.onlyLinear())) return false;
    return std::ranges::any_of(std::array{Axis::a, Axis::b, Axis::c},
                               [&](Axis axis) { return moves[i].target[axis] != moves[i - 1].target[axis]; });
}

} // namespace

std::vector<NcMove> withoutRoundedBackSteps(const std::vector<NcMove>& moves, const NumberWords& numbers) {
    std::vector<NcMove> kept;
    kept.reserve(moves.size());
    for (std::size_t i = 0; i < moves.size();) {
        std::size_t end = i;
        while (end < moves.size() && moves[end].kind == NcMoveKind::line && !turns(moves, end)) ++end;
        const bool begins = i > 0 && moves[i - 1].kind != NcMoveKind::dwell;
        if (end > i + 1 && begins)
            append(kept, std::span(moves).subspan(i - 1, end - i + 1), numbers);
        else
            kept.insert(kept.end(), moves.begin() + static_cast<std::ptrdiff_t>(i),
                        moves.begin() + static_cast<std::ptrdiff_t>(std::max(end, i + 1)));
        i = std::max(end, i + 1);
    }
    return kept;
}

} // namespace burin
