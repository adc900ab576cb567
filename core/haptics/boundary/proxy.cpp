// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/proxy.h"

#include "core/cutting/pose_steps.h"
#include "core/haptics/boundary/contact_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double smallestStep = 1e-5;        // mm; shorter steps count as rest
constexpr double smallestTurn = 1e-8;        // rad
constexpr double smallestImprovement = 1e-9; // mm
constexpr double usableGradient = 0.2;       // below it (at a medial axis) the direction is noise
constexpr int mostLooks = 20;                // queries of the boundary in one tick, before the whole motion is checked
constexpr int chordSamples = 128;
constexpr int mostBacktracks = 3;
/// Units of PoseBoundary::work in a tick: some 0.4 ms where queries are expensive (a long tool near a fine mesh), half
/// of it for finding the motion. When it is used up, the tool has come nearer to the goal, and continues in the next
/// tick.
constexpr std::uint64_t workOfTick = 4000, workOfWay = workOfTick / 2;
constexpr int fewestSamples = 2; // of a motion, whatever they cost, so that a tool makes progress in every tick
/// Weight of a rotation in strides: between two queries the farthest point moves by half a spacing at most.
constexpr double turnShare = 0.5;
constexpr double sightInSpacings = 8.0;   // range of the clearances that are queried
constexpr double stiffTurnLength = 1.0e4; // mm: the tip yields by all but one ten-thousandth of what stops a rotation
constexpr double rounding = 1e-9;         // mm by which a pose may have become infeasible since it was accepted

/// The proxy's motion in one tick, from vertex to vertex.
class Way {
public:
    Way(PoseBoundary& boundary, const ToolPose& from, const PoseSample& sample, double chordTolerance,
        const ProxyStride& stride) noexcept
        : boundary_(boundary)
        , spacing_(boundary.spacing())
        , reach_(boundary.reach())
        , overlap_(boundary.overlap())
        , tolerance_(0.5 * chordTolerance)
        , workBefore_(boundary.work())
        , travelLeft_(stride.travel)
        , turnLeft_(stride.turn)
        , pose_(from)
        , sample_(sample) {
        vertices_[0] = from;
    }

    /// Moves towards a goal as far as the boundary allows.
    /// @param turnLength mm, of the metric; 0: the axis is fixed @param room mm from the current position that the tip
    /// may be moved away
    /// @return true if it settled, false if it was ended by the limits on iterations, travel or work
    bool towards(const ToolPose& goal, double turnLength, double room, int iterations) noexcept;
    ProxyStep end() noexcept;
    const ToolPose& pose() const noexcept { return pose_; }

private:
    double gap(const PoseSample& sample) const noexcept { return sample.clearance; }
    PoseVector rest() const noexcept { return between(pose_, goal_); }
    PoseVector between(const ToolPose& from, const ToolPose& to) const noexcept;
    ToolPose moved(const PoseVector& offset) const noexcept;
    PoseVector normal(const PoseSample& sample) const noexcept;
    double motion(const PoseVector& offset, double turnWeight) const noexcept;
    PoseVector shortened(const PoseVector& offset, double most, double turnWeight) const noexcept;
    PoseSample look(const ToolPose& pose) noexcept;
    bool spent(std::uint64_t work) const noexcept { return boundary_.work() - workBefore_ > work; }

    bool canMove() const noexcept {
        return travelLeft_ > smallestStep || (turnLength_ > 0.0 && turnLeft_ > smallestTurn);
    }
    bool advanceOnce() noexcept;
    bool advanceFree() noexcept;
    bool advanceAlongSurface() noexcept;
    bool correctOntoSurface(ToolPose pose, PoseSample sample) noexcept;
    bool shorten(const PoseVector& offset) noexcept;
    bool acceptable(const ToolPose& pose, const PoseSample& sample) noexcept;
    bool accept(const ToolPose& pose, const PoseSample& sample) noexcept;
    /// The result of checking a motion.
    struct Looked {
        enum class End : std::uint8_t { clear, blocked, workIsUp } end = End::clear;
        bool any = false;  ///< the motion is clear at least up to
        ToolPose pose;     ///< this feasible one
        PoseSample sample; ///< sample at that pose
    };
    Looked lookAlong(const ToolPose& a, const ToolPose& b) noexcept;
    void keepWholeWayClear() noexcept;

    PoseBoundary& boundary_;
    const double spacing_, reach_, overlap_, tolerance_;
    const std::uint64_t workBefore_;
    ToolPose goal_;
    double turnLength_ = 0.0;
    glm::dvec3 start_{0.0};
    double room_ = 0.0;
    double travelLeft_; ///< mm
    double turnLeft_;   ///< rad
    ToolPose pose_;
    PoseSample sample_;
    ContactPlanes planes_;
    std::array<ToolPose, Proxy::maximumIterations + 1> vertices_{};
    int vertexCount_ = 1;
    int iterations_ = 0, looks_ = 0;
    bool settled_ = false;
};

PoseVector Way::between(const ToolPose& from, const ToolPose& to) const noexcept {
    return {to.tip - from.tip, turnLength_ > 0.0 ? turnLength_ * turnBetween(from.axis, to.axis) : glm::dvec3(0.0)};
}

ToolPose Way::moved(const PoseVector& offset) const noexcept {
    if (!(turnLength_ > 0.0)) return {pose_.tip + offset.move, pose_.axis};
    return {pose_.tip + offset.move, turned(pose_.axis, offset.turn / turnLength_)};
}

/// The gradient of the clearance with respect to the pose.
PoseVector Way::normal(const PoseSample& sample) const noexcept {
    return {sample.gradient, turnLength_ > 0.0 ? sample.turning / turnLength_ : glm::dvec3(0.0)};
}

/// Length of a motion, mm. @param turnWeight 1: no point of the tool moves farther
double Way::motion(const PoseVector& offset, double turnWeight) const noexcept {
    const double turn = turnLength_ > 0.0 ? turnWeight * reach_ * glm::length(offset.turn) / turnLength_ : 0.0;
    return glm::length(offset.move) + turn;
}

PoseVector Way::shortened(const PoseVector& offset, double most, double turnWeight) const noexcept {
    const double whole = motion(offset, turnWeight), travel = glm::length(offset.move);
    const double turn = glm::length(offset.turn);
    double part = whole > most ? most / whole : 1.0;
    if (travel > 0.0 && part * travel > travelLeft_) part = travelLeft_ / travel;
    if (turn > 0.0 && part * turn > turnLeft_ * turnLength_) part = turnLeft_ * turnLength_ / turn;
    return part < 1.0 ? offset * part : offset;
}

PoseSample Way::look(const ToolPose& pose) noexcept {
    ++looks_;
    const double sight = gap(sample_) > spacing_ ? sightInSpacings : 1.0;
    return boundary_.at(pose, std::min(motion(rest(), 1.0), sight * spacing_) + spacing_);
}

bool Way::towards(const ToolPose& goal, double turnLength, double room, int iterations) noexcept {
    goal_ = goal;
    turnLength_ = turnLength;
    start_ = pose_.tip;
    room_ = room;
    // Two contacts are treated as one if they are no farther apart on the tool than the linearisation is valid.
    planes_ = ContactPlanes(turnLength > 0.0 ? spacing_ / turnLength : 0.0);
    settled_ = false;
    const int last = std::min(iterations_ + iterations, Proxy::maximumIterations);
    while (!settled_ && iterations_ < last && looks_ < mostLooks && !spent(workOfWay) && canMove()) {
        settled_ = !advanceOnce() && !spent(workOfWay);
        ++iterations_;
    }
    return settled_;
}

ProxyStep Way::end() noexcept {
    keepWholeWayClear();
    ProxyStep step;
    step.pose = pose_;
    step.iterations = iterations_;
    const double steepness = glm::length(sample_.gradient);
    const PoseVector missing = rest();
    const bool pressed = settled_ || dot(normal(sample_), missing) < 0.0;
    step.onBoundary =
        pressed && gap(sample_) <= Proxy::contactGap && length(missing) > 1e-6 && steepness > usableGradient;
    if (step.onBoundary) step.normal = sample_.gradient / steepness;
    return step;
}

/// Returns false if nothing brings the tool nearer to the goal.
bool Way::advanceOnce() noexcept {
    if (length(rest()) < smallestStep) return false;
    // A coarse sample limits the step, but its direction is too rough to slide along.
    const bool readable = sample_.fine && glm::length(sample_.gradient) > usableGradient;
    if (gap(sample_) > spacing_ || !readable) return advanceFree();
    return advanceAlongSurface();
}

/// No surface within the clearance: moves straight towards the goal.
bool Way::advanceFree() noexcept {
    planes_.clear();
    const PoseVector offset = shortened(rest(), std::max(gap(sample_), 0.5 * spacing_), 1.0);
    const ToolPose pose = moved(offset);
    const PoseSample sample = look(pose);
    if (acceptable(pose, sample)) return accept(pose, sample);
    return correctOntoSurface(pose, sample) || shorten(offset);
}

/// Sequential linearisation: solves for the known planes, queries the result, and adds the plane found there.
bool Way::advanceAlongSurface() noexcept {
    planes_.add({normal(sample_), gap(sample_) - Proxy::restingGap});
    PoseVector offset;
    for (int round = 0; round < ContactPlanes::capacity && !spent(workOfWay); ++round) {
        offset = shortened(planes_.nearestTo(rest()), spacing_, turnShare);
        if (length(offset) < smallestStep) return false;
        const ToolPose pose = moved(offset);
        const PoseSample sample = look(pose);
        if (acceptable(pose, sample)) return accept(pose, sample);
        if (gap(sample) >= 0.0) break; // the motion to it cuts an edge
        if (correctOntoSurface(pose, sample)) return true;
        if (glm::length(sample.gradient) < usableGradient) break;
        const PoseVector there = normal(sample);
        planes_.add({there, gap(sample) - Proxy::restingGap - dot(there, offset)});
    }
    return shorten(offset);
}

/// Moves an infeasible pose out to the surface by Newton's method.
bool Way::correctOntoSurface(ToolPose pose, PoseSample sample) noexcept {
    for (int step = 0; step < 3 && !spent(workOfWay); ++step) {
        if (glm::length(sample.gradient) < usableGradient) return false;
        const PoseVector out = normal(sample);
        const PoseVector correction = out * ((Proxy::restingGap - gap(sample)) / dot(out, out));
        pose.tip += correction.move;
        if (turnLength_ > 0.0) pose.axis = turned(pose.axis, correction.turn / turnLength_);
        sample = look(pose);
        if (gap(sample) >= 0.0) return acceptable(pose, sample) && accept(pose, sample);
    }
    return false;
}

bool Way::shorten(const PoseVector& offset) noexcept {
    double part = 0.5;
    for (int halving = 0; halving < 6 && !spent(workOfWay); ++halving, part *= 0.5) {
        const ToolPose pose = moved(offset * part);
        const PoseSample sample = look(pose);
        if (acceptable(pose, sample)) return accept(pose, sample);
    }
    return false;
}

bool Way::acceptable(const ToolPose& pose, const PoseSample& sample) noexcept {
    if (!(gap(sample) >= 0.0)) return false;
    if (!(length(between(pose, goal_)) <= length(rest()) - smallestImprovement)) return false;
    if (glm::length(pose.tip - pose_.tip) > travelLeft_ * (1.0 + 1e-12)) return false;
    if (turnLength_ > 0.0 && glm::length(turnBetween(pose_.axis, pose.axis)) > turnLeft_ * (1.0 + 1e-12)) return false;
    if (glm::length(pose.tip - start_) > room_) return false;
    return motion(between(pose_, pose), 1.0) <= overlap_ || lookAlong(pose_, pose).end == Looked::End::clear;
}

bool Way::accept(const ToolPose& pose, const PoseSample& sample) noexcept {
    planes_.moveOrigin(between(pose_, pose), gap(sample));
    travelLeft_ = std::max(0.0, travelLeft_ - glm::length(pose.tip - pose_.tip));
    turnLeft_ = std::max(0.0, turnLeft_ - glm::length(turnBetween(pose_.axis, pose.axis)));
    pose_ = pose;
    sample_ = sample;
    vertices_[static_cast<std::size_t>(vertexCount_++)] = pose;
    return true;
}

/// Samples the motion in strides no longer than the clearance or a quarter of a cell, so that thicker walls are not
/// missed. Half of the tolerance is reserved for the motion between two samples.
Way::Looked Way::lookAlong(const ToolPose& a, const ToolPose& b) noexcept {
    Looked looked;
    const double turn = a.axis == b.axis ? 0.0 : reach_ * glm::length(b.axis - a.axis);
    const double whole = glm::length(b.tip - a.tip) + turnShare * turn;
    if (whole <= 0.0) return looked;
    const double stride = 0.25 * spacing_;
    const PoseSteps way(a, b, std::max(reach_, 1.0), spacing_);
    double along = std::max(&a == &pose_ ? turnShare * gap(sample_) : 0.0, std::min(stride, 0.5 * whole));
    for (int i = 0; along < whole; ++i) {
        looked.end = Looked::End::workIsUp;
        if (i >= chordSamples || (i >= fewestSamples && spent(workOfTick))) return looked;
        ++looks_;
        const ToolPose pose = way.poseAt(along / whole);
        const PoseSample here = boundary_.at(pose, std::min(whole - along, spacing_));
        looked.end = Looked::End::blocked;
        if (gap(here) < -tolerance_) return looked;
        if (gap(here) >= 0.0) {
            looked.any = true;
            looked.pose = pose;
            looked.sample = here;
        }
        along += std::max(turnShare * gap(here), stride);
    }
    looked.end = Looked::End::clear;
    return looked;
}

/// Goes back to a vertex that can be reached from the first one by the straight motion that is cut: the last such
/// vertex that a few queries find. If the tick's work is used up before one is found, it goes as far along that motion
/// as was checked.
void Way::keepWholeWayClear() noexcept {
    const auto vertex = [&](int index) -> const ToolPose& { return vertices_[static_cast<std::size_t>(index)]; };
    const bool lookedAt = vertexCount_ == 1 || (vertexCount_ == 2 && overlap_ <= 0.0);
    if (lookedAt) return;
    int good = 0, bad = vertexCount_, next = vertexCount_ - 1;
    for (int tries = 0; bad - good > 1; ++tries) {
        const Looked looked = lookAlong(vertex(0), vertex(next));
        if (looked.end == Looked::End::clear) {
            good = next;
        } else if (looked.end == Looked::End::blocked) {
            bad = next;
        } else {
            if (good > 0 || !looked.any) break;
            pose_ = looked.pose;
            sample_ = looked.sample;
            return;
        }
        if (tries >= mostBacktracks && good > 0) break;
        next = tries < mostBacktracks ? (good + bad) / 2 : 1;
    }
    if (good == vertexCount_ - 1) return;
    pose_ = vertex(good);
    sample_ = look(pose_);
}

bool isFinite(const ToolPose& pose) noexcept {
    return burin::isFinite(pose.tip) && burin::isFinite(pose.axis) && glm::length(pose.axis) > 0.5;
}

} // namespace

double Proxy::chordTolerance() const noexcept {
    return std::max(0.002, 0.25 * boundary_->errorBound());
}

bool Proxy::feasible(const ToolPose& pose) const noexcept {
    return boundary_->at(pose, boundary_->spacing()).clearance >= 0.0;
}

ProxyStep Proxy::advance(const ToolPose& from, const ToolPose& goal, const ProxyStride& stride) const noexcept {
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    ProxyStep stays;
    stays.pose = from;
    if (!isFinite(goal)) return stays;
    const PoseSample sample = boundary_->at(from, (1.0 + sightInSpacings) * boundary_->spacing());
    if (!(sample.clearance >= -rounding)) return stays;
    Way way(*boundary_, from, sample, chordTolerance(), stride);
    if (!(stride.turn > 0.0)) {
        way.towards({goal.tip, from.axis}, 0.0, anywhere, maximumIterations);
        return way.end();
    }
    if (stride.yields == ProxyStride::Yields::both) {
        way.towards(goal, stride.turnLength, anywhere, maximumIterations);
    } else {
        way.towards({from.tip, goal.axis}, stiffTurnLength, stride.room, maximumIterations / 2);
        way.towards({goal.tip, way.pose().axis}, 0.0, anywhere, maximumIterations);
    }
    ProxyStep step = way.end();
    const double behind = glm::length(turnBetween(from.axis, goal.axis));
    const double left = glm::length(turnBetween(step.pose.axis, goal.axis));
    step.axisHeld = left > axisTolerance && behind - left < 0.5 * std::min(behind, stride.turn);
    return step;
}

ToolPose Proxy::retreat(const ToolPose& from, double maximumTravel) const noexcept {
    const double spacing = boundary_->spacing();
    ToolPose pose = from;
    PoseSample sample = boundary_->at(pose, spacing);
    double left = maximumTravel;
    for (int i = 0; i < maximumIterations && sample.clearance < 0.0 && left > smallestStep; ++i) {
        const double steepness = glm::length(sample.gradient);
        if (steepness < usableGradient) break;
        const double wanted = (restingGap - sample.clearance) / steepness;
        const double step = std::min({wanted, left, spacing});
        const ToolPose next{pose.tip + sample.gradient * (step / steepness), pose.axis};
        const PoseSample there = boundary_->at(next, spacing);
        if (there.clearance <= sample.clearance) break;
        pose = next;
        sample = there;
        left -= step;
    }
    return pose;
}

} // namespace burin
