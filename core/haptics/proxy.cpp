// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/proxy.h"

#include "core/cutting/pose_steps.h"
#include "core/haptics/contact_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double smallestStep = 1e-8;        // mm; a shorter one is rest
constexpr double smallestImprovement = 1e-9; // mm
constexpr double usableGradient = 0.2;       // below it (a medial axis) the direction is noise
constexpr int chordSamples = 128;
constexpr double sightInSpacings = 8.0;   // so far ahead clearances are asked for
constexpr double stiffTurnLength = 1.0e4; // mm: a tip yields by all but a ten-thousandth of what stops a turn
constexpr double rounding = 1e-9;         // mm by which a pose may have become infeasible since it was accepted

/// One tick's way of the proxy, from vertex to vertex.
class Way {
public:
    Way(PoseBoundary& boundary, const ToolPose& from, const PoseSample& sample, double chordTolerance,
        double maximumTravel) noexcept
        : boundary_(boundary)
        , spacing_(boundary.spacing())
        , reach_(boundary.reach())
        , tolerance_(0.5 * chordTolerance)
        , travelLeft_(maximumTravel)
        , pose_(from)
        , sample_(sample) {
        vertices_[0] = from;
    }

    /// As far towards a goal as the boundary lets the tool.
    /// @param turnLength mm, of the metric; 0: the axis stands @param room mm from here that the tip may be led away
    /// @return true when it settled, false when iterations or travel ended it
    bool towards(const ToolPose& goal, double turnLength, double room, int iterations) noexcept;
    ProxyStep end() noexcept;
    const ToolPose& pose() const noexcept { return pose_; }

private:
    double gap(const PoseSample& sample) const noexcept { return sample.clearance; }
    PoseVector rest() const noexcept { return between(pose_, goal_); }
    PoseVector between(const ToolPose& from, const ToolPose& to) const noexcept;
    ToolPose moved(const PoseVector& offset) const noexcept;
    PoseVector normal(const PoseSample& sample) const noexcept;
    double motion(const PoseVector& offset) const noexcept;
    PoseVector shortened(const PoseVector& offset, double motion) const noexcept;
    PoseSample look(const ToolPose& pose) const noexcept;

    bool advanceOnce() noexcept;
    bool advanceFree() noexcept;
    bool advanceAlongSurface() noexcept;
    bool correctOntoSurface(ToolPose pose, PoseSample sample) noexcept;
    bool shorten(const PoseVector& offset) noexcept;
    bool acceptable(const ToolPose& pose, const PoseSample& sample) const noexcept;
    bool accept(const ToolPose& pose, const PoseSample& sample) noexcept;
    bool clearBetween(const ToolPose& a, const ToolPose& b) const noexcept;
    void keepWholeWayClear() noexcept;

    PoseBoundary& boundary_;
    const double spacing_, reach_, tolerance_;
    ToolPose goal_;
    double turnLength_ = 0.0;
    glm::dvec3 start_{0.0};
    double room_ = 0.0;
    double travelLeft_;
    ToolPose pose_;
    PoseSample sample_;
    ContactPlanes planes_;
    std::array<ToolPose, Proxy::maximumIterations + 1> vertices_{};
    int vertexCount_ = 1;
    int iterations_ = 0;
    bool settled_ = false;
};

PoseVector Way::between(const ToolPose& from, const ToolPose& to) const noexcept {
    return {to.tip - from.tip, turnLength_ > 0.0 ? turnLength_ * turnBetween(from.axis, to.axis) : glm::dvec3(0.0)};
}

ToolPose Way::moved(const PoseVector& offset) const noexcept {
    if (!(turnLength_ > 0.0)) return {pose_.tip + offset.move, pose_.axis};
    return {pose_.tip + offset.move, turned(pose_.axis, offset.turn / turnLength_)};
}

/// What the clearance gains with a change of pose.
PoseVector Way::normal(const PoseSample& sample) const noexcept {
    return {sample.gradient, turnLength_ > 0.0 ? sample.turning / turnLength_ : glm::dvec3(0.0)};
}

/// mm that no point of the tool moves by more.
double Way::motion(const PoseVector& offset) const noexcept {
    const double turn = turnLength_ > 0.0 ? reach_ * glm::length(offset.turn) / turnLength_ : 0.0;
    return glm::length(offset.move) + turn;
}

PoseVector Way::shortened(const PoseVector& offset, double most) const noexcept {
    const double whole = motion(offset), travel = glm::length(offset.move);
    double part = whole > most ? most / whole : 1.0;
    if (part * travel > travelLeft_) part = travelLeft_ / travel;
    return part < 1.0 ? offset * part : offset;
}

PoseSample Way::look(const ToolPose& pose) const noexcept {
    return boundary_.at(pose, std::min(motion(rest()), sightInSpacings * spacing_) + spacing_);
}

bool Way::towards(const ToolPose& goal, double turnLength, double room, int iterations) noexcept {
    goal_ = goal;
    turnLength_ = turnLength;
    start_ = pose_.tip;
    room_ = room;
    // Two contacts of a tool no farther apart than the linearisation holds are one.
    planes_ = ContactPlanes(turnLength > 0.0 ? spacing_ / turnLength : 0.0);
    settled_ = false;
    const int last = std::min(iterations_ + iterations, Proxy::maximumIterations);
    while (!settled_ && iterations_ < last && travelLeft_ > smallestStep) {
        settled_ = !advanceOnce();
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

/// False: nothing brings the tool nearer to the goal.
bool Way::advanceOnce() noexcept {
    if (length(rest()) < smallestStep) return false;
    // A coarse sample bounds the step but its direction is too rough to slide along.
    const bool readable = sample_.fine && glm::length(sample_.gradient) > usableGradient;
    if (gap(sample_) > spacing_ || !readable) return advanceFree();
    return advanceAlongSurface();
}

/// No surface within the clearance: straight towards the goal.
bool Way::advanceFree() noexcept {
    planes_.clear();
    const PoseVector offset = shortened(rest(), std::max(gap(sample_), 0.5 * spacing_));
    const ToolPose pose = moved(offset);
    const PoseSample sample = look(pose);
    if (acceptable(pose, sample)) return accept(pose, sample);
    return correctOntoSurface(pose, sample) || shorten(offset);
}

/// Sequential linearisation: solve for the planes known, look where that leads, take in the plane found there.
bool Way::advanceAlongSurface() noexcept {
    planes_.add({normal(sample_), gap(sample_) - Proxy::restingGap});
    PoseVector offset;
    for (int round = 0; round < ContactPlanes::capacity; ++round) {
        offset = shortened(planes_.nearestTo(rest()), spacing_);
        if (length(offset) < smallestStep) return false;
        const ToolPose pose = moved(offset);
        const PoseSample sample = look(pose);
        if (acceptable(pose, sample)) return accept(pose, sample);
        if (gap(sample) >= 0.0) break; // the way there cuts an edge
        if (correctOntoSurface(pose, sample)) return true;
        if (glm::length(sample.gradient) < usableGradient) break;
        const PoseVector there = normal(sample);
        planes_.add({there, gap(sample) - Proxy::restingGap - dot(there, offset)});
    }
    return shorten(offset);
}

/// Newton's method from an infeasible pose out to the surface.
bool Way::correctOntoSurface(ToolPose pose, PoseSample sample) noexcept {
    for (int step = 0; step < 3; ++step) {
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
    for (int halving = 0; halving < 6; ++halving, part *= 0.5) {
        const ToolPose pose = moved(offset * part);
        const PoseSample sample = look(pose);
        if (acceptable(pose, sample)) return accept(pose, sample);
    }
    return false;
}

bool Way::acceptable(const ToolPose& pose, const PoseSample& sample) const noexcept {
    if (!(gap(sample) >= 0.0)) return false;
    if (length(between(pose, goal_)) > length(rest()) - smallestImprovement) return false;
    if (glm::length(pose.tip - pose_.tip) > travelLeft_ * (1.0 + 1e-12)) return false;
    if (glm::length(pose.tip - start_) > room_) return false;
    return clearBetween(pose_, pose);
}

bool Way::accept(const ToolPose& pose, const PoseSample& sample) noexcept {
    planes_.moveOrigin(between(pose_, pose), gap(sample));
    travelLeft_ -= glm::length(pose.tip - pose_.tip);
    pose_ = pose;
    sample_ = sample;
    vertices_[static_cast<std::size_t>(vertexCount_++)] = pose;
    return true;
}

/// Samples the way, in strides no longer than the clearance or a quarter of a cell: no wall thicker than that is jumped
/// over. Half of the tolerance is left for what lies between two samples.
bool Way::clearBetween(const ToolPose& a, const ToolPose& b) const noexcept {
    const double whole = glm::length(b.tip - a.tip) + (a.axis == b.axis ? 0.0 : reach_ * glm::length(b.axis - a.axis));
    const double stride = 0.25 * spacing_;
    if (whole <= 0.0) return true;
    const PoseSteps way(a, b, std::max(reach_, 1.0), spacing_);
    double along = std::max(&a == &pose_ ? gap(sample_) : 0.0, std::min(stride, 0.5 * whole));
    for (int i = 0; i < chordSamples; ++i) {
        if (along >= whole) return true;
        const double here = gap(boundary_.at(way.poseAt(along / whole), whole - along));
        if (here < -tolerance_) return false;
        along += std::max(here, stride);
    }
    return false;
}

/// Goes back to the last vertex that can be reached from the first on the way that is cut.
void Way::keepWholeWayClear() noexcept {
    const auto vertex = [&](int index) -> const ToolPose& { return vertices_[static_cast<std::size_t>(index)]; };
    if (vertexCount_ <= 2 || clearBetween(vertex(0), vertex(vertexCount_ - 1))) return;
    int good = 1, bad = vertexCount_ - 1;
    while (bad - good > 1) {
        const int middle = (good + bad) / 2;
        (clearBetween(vertex(0), vertex(middle)) ? good : bad) = middle;
    }
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
    Way way(*boundary_, from, sample, chordTolerance(), stride.travel);
    if (!(stride.turn > 0.0)) {
        way.towards({goal.tip, from.axis}, 0.0, anywhere, maximumIterations);
        return way.end();
    }
    const glm::dvec3 wanted = turned(from.axis, clampLength(turnBetween(from.axis, goal.axis), stride.turn));
    if (stride.yields == ProxyStride::Yields::both) {
        way.towards({goal.tip, wanted}, stride.turnLength, anywhere, maximumIterations);
    } else {
        way.towards({from.tip, wanted}, stiffTurnLength, stride.room, maximumIterations / 2);
        way.towards({goal.tip, way.pose().axis}, 0.0, anywhere, maximumIterations);
    }
    ProxyStep step = way.end();
    step.axisHeld = glm::length(step.pose.axis - wanted) > axisTolerance;
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
