// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/part_guard.h"

#include "core/geometry/upright.h"

#include <algorithm>
#include <cmath>

namespace burin {

PartGuard::PartGuard(const MeshDistance& part, const Tool& tool) : PartGuard(part, burin::pieces(tool.cutter)) {}

PartGuard::PartGuard(const MeshDistance& part, std::vector<RevolvedPiece> pieces)
    : part_(&part), pieces_(std::move(pieces)), top_(part.bounds().high.z) {
    for (const RevolvedPiece& piece : pieces_)
        reach_ = std::max(reach_, std::hypot(std::max(std::abs(piece.bottom), piece.top), piece.widestRadius()));
}

Result<PartGuard> PartGuard::of(const PathContext& context) {
    if (context.part == nullptr)
        return Error{ErrorCode::argumentInvalid, "part", "", "this edit needs the part's mesh"};
    return PartGuard(*context.part, context.tool);
}

ToolClearance PartGuard::clearance(const glm::dvec3& tip, double within) const {
    return part_->clearance(pieces_, ToolPose{tip, {0.0, 0.0, 1.0}}, within);
}

ToolClearance PartGuard::clearance(const ToolPose& pose, double within) const {
    return part_->clearance(pieces_, pose, within);
}

std::optional<PartGuard::Dip> PartGuard::deepestDip(const glm::dvec3& from, const glm::dvec3& to, double required,
                                                    double sampling) const {
    return scan(from, to, required, sampling, false);
}

namespace {

/// Between two samples, both tool and part may have a sharp edge, and a corner is cut. Samples are refined down to this
/// distance, mm.
constexpr double finestGap = 0.001;
constexpr double cornerTolerance = 2e-5; // mm

} // namespace

/// Samples the clearance along one move.
class PartGuard::Scan {
public:
    Scan(const PartGuard& guard, const glm::dvec3& from, const glm::dvec3& to, double required, bool firstIsEnough)
        : guard_(guard)
        , from_(from)
        , way_(to - from)
        , length_(glm::length(way_))
        , required_(required)
        , firstIsEnough_(firstIsEnough) {}

    std::optional<Dip> run(double sampling) {
        const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length_ / sampling)));
        const double step = length_ / static_cast<double>(steps);
        Place before;
        for (std::size_t i = 0; i <= steps;) {
            const Place here = look(length_ * static_cast<double>(i) / static_cast<double>(steps));
            if (i > 0) between(before, here);
            if (dip_ && firstIsEnough_) break;
            const double left = length_ - here.at, spare = here.clearance - required_;
            if (spare >= left && spare > 0.0) break;
            before = here;
            i += spare > step && step > 0.0 ? static_cast<std::size_t>(spare / step) : 1;
        }
        return dip_;
    }

private:
    struct Place {
        double at = 0.0;        // mm from the start
        double clearance = 0.0; // mm
        double slope = 0.0;     // of the clearance along the move
    };

    Place look(double at) {
        const double part = length_ > 0.0 ? at / length_ : 0.0;
        const ToolClearance found = guard_.clearance(from_ + part * way_, required_ + length_);
        if (found.clearance < required_ && (!dip_ || found.clearance < dip_->clearance))
            dip_ = Dip{part, found.clearance};
        return {at, found.clearance, length_ > 0.0 ? glm::dot(found.away, way_) / length_ : 0.0};
    }

    /// The distance from a convex body is a convex function, so it lies above its tangents: their intersection is its
    /// lower bound. A point between is sampled only if that is too low.
    void between(const Place& a, const Place& b) {
        const double gap = b.at - a.at;
        if (gap < finestGap || (dip_ && firstIsEnough_)) return;
        if (a.clearance < required_ || b.clearance < required_) return; // known already
        if (a.clearance + b.clearance - 2.0 * required_ >= gap) return; // by the length of the move alone
        if (a.slope >= b.slope) return;                                 // no minimum between
        const double meeting = (b.clearance - a.clearance + a.slope * a.at - b.slope * b.at) / (a.slope - b.slope);
        const double least = a.clearance + a.slope * (std::clamp(meeting, a.at, b.at) - a.at);
        if (least >= required_ - cornerTolerance) return;
        const Place middle = look(0.5 * (a.at + b.at));
        between(a, middle);
        between(middle, b);
    }

    const PartGuard& guard_;
    glm::dvec3 from_, way_;
    double length_, required_; // mm
    bool firstIsEnough_;
    std::optional<Dip> dip_;
};

/// Samples the clearance along a move on which the tool turns.
class PartGuard::TurningScan {
public:
    TurningScan(const PartGuard& guard, const ToolPose& from, const ToolPose& to, double required)
        : guard_(guard)
        , from_(from)
        , to_(to)
        , length_(glm::distance(from.tip, to.tip) +
                  guard.reach_ * std::atan2(glm::length(glm::cross(from.axis, to.axis)), glm::dot(from.axis, to.axis)))
        , required_(required) {}

    std::optional<Dip> run(double sampling) {
        const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length_ / sampling)));
        double before = look(0.0);
        for (std::size_t i = 1; i <= steps; ++i) {
            const double last = static_cast<double>(i - 1) / static_cast<double>(steps);
            const double here = static_cast<double>(i) / static_cast<double>(steps), found = look(here);
            between(last, before, here, found);
            before = found;
        }
        return dip_;
    }

private:
    double look(double part) {
        const glm::dvec3 axis = glm::mix(from_.axis, to_.axis, part);
        const ToolPose pose{glm::mix(from_.tip, to_.tip, part), glm::normalize(axis)};
        const double found = guard_.clearance(pose, required_ + length_ + sameAxis).clearance;
        if (found < required_ && (!dip_ || found < dip_->clearance)) dip_ = Dip{part, found};
        return found;
    }

    /// No point of the tool moves farther than `gap`, so that the clearance between is above the mean less half of it.
    void between(double a, double atA, double b, double atB) {
        const double gap = (b - a) * length_;
        if (gap < finestTurningGap || atA < required_ || atB < required_) return;
        if (0.5 * (atA + atB - gap) >= required_) return;
        const double middle = 0.5 * (a + b), found = look(middle);
        between(a, atA, middle, found);
        between(middle, found, b, atB);
    }

    static constexpr double finestTurningGap = 0.01; // mm
    static constexpr double sameAxis = 1e-6;         // mm: a tool that rests has to be near as well

    const PartGuard& guard_;
    ToolPose from_, to_;
    double length_, required_; // mm
    std::optional<Dip> dip_;
};

std::optional<PartGuard::Dip> PartGuard::deepestDip(const ToolPose& from, const ToolPose& to, double required,
                                                    double sampling) const {
    if (isUpright(from.axis) && isUpright(to.axis)) return scan(from.tip, to.tip, required, sampling, false);
    return TurningScan(*this, from, to, required).run(sampling);
}

std::optional<PartGuard::Dip> PartGuard::scan(const glm::dvec3& from, const glm::dvec3& to, double required,
                                              double sampling, bool firstIsEnough) const {
    return Scan(*this, from, to, required, firstIsEnough).run(sampling);
}

bool PartGuard::isClear(const Arc& arc, double required, double sampling) const {
    constexpr double chord = 0.0005; // mm
    std::vector<glm::dvec3> places;
    flatten(arc, chord, places);
    glm::dvec3 at = arc.from;
    return std::ranges::all_of(places, [&](const glm::dvec3& place) {
        const bool clear = isClear(at, place, required + chord, sampling);
        at = place;
        return clear;
    });
}

} // namespace burin
