// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/proxy.h"

#include "core/geometry/pose.h"
#include "core/haptics/contact_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr double smallestStep = 1e-8;        // mm; a shorter one is rest
constexpr double smallestImprovement = 1e-9; // mm
constexpr double usableGradient = 0.2;       // below it (a medial axis) the direction is noise
constexpr int chordSamples = 128;

/// One tick's way of the proxy, from vertex to vertex.
class Way {
public:
    Way(const ClearanceField& field, const glm::dvec3& from, const glm::dvec3& goal, double allowance,
        double chordTolerance, double maximumTravel) noexcept
        : field_(field)
        , goal_(goal)
        , allowance_(allowance)
        , tolerance_(0.5 * chordTolerance)
        , travelLeft_(maximumTravel)
        , tip_(from)
        , sample_(field.at(from)) {
        vertices_[0] = from;
    }

    ProxyStep run() noexcept;

private:
    double gap(const FieldSample& sample) const noexcept { return sample.clearance - allowance_; }
    glm::dvec3 rest() const noexcept { return goal_ - tip_; }

    bool advanceOnce() noexcept;
    bool advanceFree() noexcept;
    bool advanceAlongSurface() noexcept;
    bool correctOntoSurface(glm::dvec3 tip, FieldSample sample) noexcept;
    bool shorten(const glm::dvec3& offset) noexcept;
    bool acceptable(const glm::dvec3& tip, const FieldSample& sample) const noexcept;
    bool accept(const glm::dvec3& tip, const FieldSample& sample) noexcept;
    bool clearBetween(const glm::dvec3& a, const glm::dvec3& b) const noexcept;
    void keepStraightWayClear() noexcept;

    const ClearanceField& field_;
    glm::dvec3 goal_;
    double allowance_;
    double tolerance_;
    double travelLeft_;
    glm::dvec3 tip_;
    FieldSample sample_;
    ContactPlanes planes_;
    std::array<glm::dvec3, Proxy::maximumIterations + 1> vertices_{};
    int vertexCount_ = 1;
};

ProxyStep Way::run() noexcept {
    ProxyStep step;
    bool settled = false;
    while (!settled && step.iterations < Proxy::maximumIterations && travelLeft_ > smallestStep) {
        settled = !advanceOnce();
        ++step.iterations;
    }
    keepStraightWayClear();
    step.tip = tip_;
    const double length = glm::length(sample_.gradient);
    const bool pressed = settled || glm::dot(sample_.gradient, rest()) < 0.0;
    step.onBoundary =
        pressed && gap(sample_) <= Proxy::contactGap && glm::length(rest()) > 1e-6 && length > usableGradient;
    if (step.onBoundary) step.normal = sample_.gradient / length;
    return step;
}

/// False: nothing brings the tip nearer to the goal.
bool Way::advanceOnce() noexcept {
    if (glm::length(rest()) < smallestStep) return false;
    // A coarse sample bounds the step but its direction is too rough to slide along.
    const bool readable = sample_.fine && glm::length(sample_.gradient) > usableGradient;
    if (gap(sample_) > field_.spacing() || !readable) return advanceFree();
    return advanceAlongSurface();
}

/// No surface within the clearance: straight towards the goal.
bool Way::advanceFree() noexcept {
    planes_ = {};
    const double reach = std::max(gap(sample_), 0.5 * field_.spacing());
    const glm::dvec3 offset = clampLength(rest(), std::min(reach, travelLeft_));
    const glm::dvec3 tip = tip_ + offset;
    const FieldSample sample = field_.at(tip);
    if (acceptable(tip, sample)) return accept(tip, sample);
    return correctOntoSurface(tip, sample) || shorten(offset);
}

/// Sequential linearisation: solve for the planes known, look where that leads, take in the plane found there.
bool Way::advanceAlongSurface() noexcept {
    const double length = glm::length(sample_.gradient);
    planes_.add({sample_.gradient / length, gap(sample_) - Proxy::restingGap});
    glm::dvec3 offset(0.0);
    for (int round = 0; round < ContactPlanes::capacity; ++round) {
        offset = clampLength(planes_.nearestTo(rest()), std::min(field_.spacing(), travelLeft_));
        if (glm::length(offset) < smallestStep) return false;
        const glm::dvec3 tip = tip_ + offset;
        const FieldSample sample = field_.at(tip);
        if (acceptable(tip, sample)) return accept(tip, sample);
        if (gap(sample) >= 0.0) break; // the way there cuts an edge
        if (correctOntoSurface(tip, sample)) return true;
        const double steepness = glm::length(sample.gradient);
        if (steepness < usableGradient) break;
        const glm::dvec3 normal = sample.gradient / steepness;
        planes_.add({normal, gap(sample) - Proxy::restingGap - glm::dot(normal, offset)});
    }
    return shorten(offset);
}

/// Newton's method from an infeasible tip out to the surface.
bool Way::correctOntoSurface(glm::dvec3 tip, FieldSample sample) noexcept {
    for (int step = 0; step < 3; ++step) {
        const double steepness = glm::length(sample.gradient);
        if (steepness < usableGradient) return false;
        tip += sample.gradient * ((Proxy::restingGap - gap(sample)) / (steepness * steepness));
        sample = field_.at(tip);
        if (gap(sample) >= 0.0) return acceptable(tip, sample) && accept(tip, sample);
    }
    return false;
}

bool Way::shorten(const glm::dvec3& offset) noexcept {
    double part = 0.5;
    for (int halving = 0; halving < 6; ++halving, part *= 0.5) {
        const glm::dvec3 tip = tip_ + offset * part;
        const FieldSample sample = field_.at(tip);
        if (acceptable(tip, sample)) return accept(tip, sample);
    }
    return false;
}

bool Way::acceptable(const glm::dvec3& tip, const FieldSample& sample) const noexcept {
    if (!(gap(sample) >= 0.0)) return false;
    if (glm::length(goal_ - tip) > glm::length(rest()) - smallestImprovement) return false;
    if (glm::length(tip - tip_) > travelLeft_ * (1.0 + 1e-12)) return false;
    return clearBetween(tip_, tip);
}

bool Way::accept(const glm::dvec3& tip, const FieldSample& sample) noexcept {
    planes_.moveOrigin(tip - tip_, gap(sample));
    travelLeft_ -= glm::length(tip - tip_);
    tip_ = tip;
    sample_ = sample;
    vertices_[static_cast<std::size_t>(vertexCount_++)] = tip;
    return true;
}

/// Samples the straight way, in strides no longer than the clearance or a quarter of a cell: no wall thicker than that
/// is jumped over. Half of the tolerance is left for what lies between two samples.
bool Way::clearBetween(const glm::dvec3& a, const glm::dvec3& b) const noexcept {
    const double length = glm::length(b - a);
    const double stride = 0.25 * field_.spacing();
    if (length <= 0.0) return true;
    const glm::dvec3 direction = (b - a) / length;
    double along = std::max(a == tip_ ? gap(sample_) : 0.0, std::min(stride, 0.5 * length));
    for (int i = 0; i < chordSamples; ++i) {
        if (along >= length) return true;
        const double here = gap(field_.at(a + direction * along));
        if (here < -tolerance_) return false;
        along += std::max(here, stride);
    }
    return false;
}

/// Goes back to the last vertex that can be reached from the first in a straight line.
void Way::keepStraightWayClear() noexcept {
    const auto vertex = [&](int index) { return vertices_[static_cast<std::size_t>(index)]; };
    if (vertexCount_ <= 2 || clearBetween(vertex(0), vertex(vertexCount_ - 1))) return;
    int good = 1, bad = vertexCount_ - 1;
    while (bad - good > 1) {
        const int middle = (good + bad) / 2;
        (clearBetween(vertex(0), vertex(middle)) ? good : bad) = middle;
    }
    tip_ = vertex(good);
    sample_ = field_.at(tip_);
}

} // namespace

double Proxy::chordTolerance() const noexcept {
    return std::max(0.002, 0.25 * field_->errorBound());
}

bool Proxy::feasible(const glm::dvec3& tip, double allowance) const noexcept {
    return field_->at(tip).clearance >= allowance;
}

ProxyStep Proxy::advance(const glm::dvec3& from, const glm::dvec3& goal, double allowance,
                         double maximumTravel) const noexcept {
    if (!isFinite(goal) || !feasible(from, allowance)) {
        ProxyStep stays;
        stays.tip = from;
        return stays;
    }
    return Way(*field_, from, goal, allowance, chordTolerance(), maximumTravel).run();
}

glm::dvec3 Proxy::retreat(const glm::dvec3& from, double allowance, double maximumTravel) const noexcept {
    glm::dvec3 tip = from;
    FieldSample sample = field_->at(tip);
    double left = maximumTravel;
    for (int i = 0; i < maximumIterations && sample.clearance < allowance && left > smallestStep; ++i) {
        const double steepness = glm::length(sample.gradient);
        if (steepness < usableGradient) break;
        const double wanted = (allowance + restingGap - sample.clearance) / steepness;
        const double length = std::min({wanted, left, field_->spacing()});
        const glm::dvec3 next = tip + sample.gradient * (length / steepness);
        const FieldSample there = field_->at(next);
        if (there.clearance <= sample.clearance) break;
        tip = next;
        sample = there;
        left -= length;
    }
    return tip;
}

} // namespace burin
