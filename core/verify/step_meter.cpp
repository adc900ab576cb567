// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/step_meter.h"

#include "core/cutting/line_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double leastFacing = 0.05; // n · d of a surface that is only grazed: 3 degrees
constexpr double stepsPerRadius = 16.0, slicesPerRadius = 8.0;

double widestOf(std::span<const RevolvedPiece> flutes) {
    double widest = 0.0;
    for (const RevolvedPiece& piece : flutes) widest = std::max(widest, piece.widestRadius());
    return widest;
}

} // namespace

std::uint32_t loadStepsOf(double length, double edge, double radius) noexcept {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / std::max(edge, radius / stepsPerRadius))));
}

void StepCut::add(const StepCut& other) noexcept {
    const float both = volume + other.volume;
    if (both > 0.0F) place = (place * volume + other.place * other.volume) / both;
    volume = both;
    surface += other.surface;
    bottom = std::min(bottom, other.bottom);
    top = std::max(top, other.top);
    tangentChip += other.tangentChip;
    tangentEdge += other.tangentEdge;
    normalChip += other.normalChip;
    normalEdge += other.normalEdge;
}

StepMeter::StepMeter(const RunVolume& workpiece) : workpiece_(&workpiece), grid_(&workpiece.grid()) {
    const PropertyList& list = workpiece.properties();
    for (int i = 1; i < list.size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        if (list.isProtected(property)) continue;
        placeOf_[property] = static_cast<std::uint8_t>(materials_.size());
        materials_.push_back(property);
    }
}

void StepMeter::begin(std::uint32_t move, std::span<const RevolvedPiece> flutes, const PlanRegion& section,
                      const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis) {
    move_ = move;
    flutes_ = flutes;
    section_ = section.empty() ? nullptr : &section;
    from_ = from;
    axis_ = axis;
    length_ = glm::distance(from, to);
    direction_ = length_ > 0.0 ? (to - from) / length_ : -axis;
    steps_ = 0;
}

/// Done on the first removal: most moves come near a row of bricks without removing anything from it.
void StepMeter::prepare() {
    const double widest = widestOf(flutes_);
    steps_ = loadStepsOf(length_, grid_->edge(), widest);
    if (sums_.size() < steps_ * materials_.size()) sums_.resize(steps_ * materials_.size());
    slice_ = std::max(1.0, widest / slicesPerRadius / grid_->edge()) * unitsPerVoxel;
    // Upright walls on a level move meet an entire run at once.
    const RevolvedPiece& lowest = flutes_.front();
    const bool walls = section_ == nullptr && flutes_.size() == 1 && !lowest.bulges() && lowest.cornerRadius == 0.0 &&
                       lowest.bottomRadius == lowest.topRadius;
    if (walls && std::abs(axis_.z) > 0.5 && std::abs(glm::dot(direction_, axis_)) < 1e-9)
        slice_ = static_cast<double>(grid_->lineEnd());
}

void StepMeter::add(LineIndex line, double low, double high) {
    if (steps_ == 0) prepare();
    if (materials_.size() == 1) return addRun(line, low, high);
    // Splits the interval at its borders of material; parts without millable material count with the one before.
    double from = low;
    for (const Segment segment : workpiece_->line(line)) {
        const double end = std::min(high, static_cast<double>(segment.end()));
        if (end <= from) continue;
        if (segment.property() != airProperty && !workpiece_->properties().isProtected(segment.property()))
            material_ = placeOf_[segment.property()];
        addRun(line, from, end);
        from = end;
        if (from >= high) return;
    }
}

void StepMeter::addRun(LineIndex line, double low, double high) {
    const glm::dvec3 corner = inLineFrame(*grid_, grid_->low());
    const double edge = grid_->edge();
    const glm::dvec2 centre = grid_->lineCentre(line);
    const double slices = std::max(1.0, std::ceil((high - low) / slice_));
    const double units = (high - low) / slices;
    const double halfHeight = 0.5 * edge * (std::abs(axis_.z) > 0.5 ? units / unitsPerVoxel : 1.0);
    for (double i = 0.0; i < slices; ++i)
        addSlice({centre.x, centre.y, corner.z + (low + (i + 0.5) * units) / unitsPerVoxel * edge},
                 units * grid_->unitVolume(), halfHeight);
}

/// The signed distance to a convex piece is convex along the move, so that Newton's steps from its start never pass the
/// first zero.
StepMeter::Met StepMeter::meetPieces(const glm::dvec3& place) const {
    constexpr int mostSteps = 12;
    constexpr double near = 1e-6; // mm
    const glm::dvec3 offset = place - from_;
    Met first;
    first.way = length_;
    bool found = false;
    double nearest = 0.0;
    for (const RevolvedPiece& piece : flutes_) {
        double way = 0.0;
        for (int i = 0; i < mostSteps; ++i) {
            const glm::dvec3 at = offset - way * direction_;
            const double height = glm::dot(at, axis_);
            const glm::dvec3 across = at - height * axis_;
            const double radius = glm::length(across);
            const glm::dvec3 outward = radius > 0.0 ? across / radius : glm::dvec3(0.0);
            const PieceDistance distance = signedDistanceAndSlope(piece, radius, height);
            const glm::dvec3 normal = distance.alongRadius * outward + distance.alongHeight * axis_;
            const double closing = glm::dot(normal, direction_);
            const bool in = distance.distance <= near;
            if (in || i + 1 == mostSteps || closing <= 0.0) {
                // If no piece is met to within rounding, the nearest one counts.
                const bool better = in ? !found || way < first.way
                                       : !found && (first.normal == glm::dvec3(0.0) || distance.distance < nearest);
                if (better) first = {way, height, radius, outward, normal, 0.0};
                if (better && !in) nearest = distance.distance;
                found = found || in;
                break;
            }
            way = std::min(length_, way + distance.distance / closing);
        }
    }
    return first;
}

/// @param normal of the flutes: (away from the axis, along it)
StepMeter::Met StepMeter::metAt(const glm::dvec3& place, double way, const glm::dvec2& normal) const {
    const glm::dvec3 at = place - from_ - way * direction_;
    const double height = glm::dot(at, axis_);
    const glm::dvec3 across = at - height * axis_;
    const double radius = glm::length(across);
    const glm::dvec3 outward = radius > 0.0 ? across / radius : glm::dvec3(0.0);
    return {way, height, radius, outward, normal.x * outward + normal.y * axis_, 0.0};
}

/// The first point of the move at which an edge of the section, as it turns, is passed from outside. In the tool's
/// frame the point moves straight: its height changes evenly, the square of its distance from the axis is a quadratic,
/// and the edge is a cone. Points that the tool holds from the start, as its tip is cut on a lattice, are met up to a
/// voxel before. Empty if there is none.
std::optional<StepMeter::Met> StepMeter::meetSection(const glm::dvec3& place) const {
    const glm::dvec3 start = place - from_;
    const double h0 = glm::dot(start, axis_), dh = -glm::dot(direction_, axis_);
    const glm::dvec3 a = start - h0 * axis_, b = -direction_ - dh * axis_; // across the axis: a + way b
    std::optional<Met> first;
    double earliest = length_ + grid_->edge();
    const auto pass = [&](const glm::dvec2& from, const glm::dvec2& to, double way) {
        if (!(way >= -grid_->edge() && way < earliest)) return;
        const glm::dvec2 along = to - from;
        const glm::dvec2 at(glm::length(a + way * b), h0 + way * dh);
        const double share = glm::dot(at - from, along) / glm::dot(along, along);
        const Met met = metAt(place, way, glm::dvec2(along.y, -along.x) / glm::length(along));
        if (!(share >= 0.0 && share <= 1.0 && glm::dot(met.normal, direction_) > 0.0)) return;
        earliest = way;
        first = met;
        first->way = std::clamp(way, 0.0, length_);
    };
    for (const PlanRing& ring : section_->rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            if (from.y == to.y) {
                if (dh != 0.0) pass(from, to, (from.y - h0) / dh);
                continue;
            }
            // |a + way b|² = (r + k (h0 + way dh - from.y))² with k = slope of the edge
            const double k = (to.x - from.x) / (to.y - from.y), r = from.x + k * (h0 - from.y);
            const double square = glm::dot(b, b) - k * k * dh * dh, half = glm::dot(a, b) - r * k * dh,
                         rest = glm::dot(a, a) - r * r;
            if (std::abs(square) < 1e-12) {
                if (half != 0.0) pass(from, to, -0.5 * rest / half);
                continue;
            }
            const double under = half * half - square * rest;
            if (under < 0.0) continue;
            const double root = std::sqrt(under);
            pass(from, to, (-half - root) / square);
            pass(from, to, (-half + root) / square);
        }
    return first;
}

StepMeter::Met StepMeter::meet(const glm::dvec3& place) const {
    if (section_ == nullptr) return meetPieces(place);
    const std::optional<Met> met = meetSection(place);
    return met ? *met : meetPieces(place);
}

/// 1 / (n · d); where the side of the flutes only grazes the line, its mean over the width of the line.
double StepMeter::surfaceFor(const Met& met) const {
    const double along = glm::dot(direction_, axis_);
    const glm::dvec3 level = direction_ - along * axis_;
    const double pace = glm::length(level), side = glm::dot(met.normal, met.outward);
    double facing = glm::dot(met.normal, axis_) * along;
    if (pace > 1e-9 && side != 0.0) {
        const double half = 0.5 * grid_->edge(), radius = std::max(met.radius, half);
        const double aside = std::abs(glm::dot(met.outward * met.radius, glm::cross(axis_, level / pace)));
        const auto angle = [&](double at) { return std::asin(std::clamp(at / radius, -1.0, 1.0)); };
        const double spread = radius * (angle(aside + half) - angle(aside - half)) / (2.0 * half);
        facing += std::abs(side) * pace / std::max(spread, leastFacing);
    }
    return 1.0 / std::max(facing, leastFacing);
}

/// A piece of a run represents a voxel: its contribution is spread over an equal length of the move, so that the load
/// in a slot does not ripple with the columns of voxels that are removed.
void StepMeter::addSlice(const glm::dvec3& place, double volume, double halfHeight) {
    Met met = meet(place);
    met.surface = surfaceFor(met);
    const double half = 0.5 * grid_->edge(), step = length_ / steps_;
    const double first = std::clamp(met.way - half, 0.0, length_), last = std::clamp(met.way + half, 0.0, length_);
    if (!(last > first) || steps_ == 1) return addTo(0, met, place, volume, halfHeight);
    const auto number = [&](double way) {
        return static_cast<std::uint32_t>(std::clamp(std::floor(way / step), 0.0, steps_ - 1.0));
    };
    for (std::uint32_t i = number(first); i <= number(last); ++i) {
        const double within = std::min(last, (i + 1.0) * step) - std::max(first, i * step);
        if (within > 0.0) addTo(i, met, place, volume * within / (last - first), halfHeight);
    }
}

void StepMeter::addTo(std::size_t step, const Met& met, const glm::dvec3& place, double volume, double halfHeight) {
    const std::size_t entry = step * materials_.size() + material_;
    Sum& sum = sums_[entry];
    if (!(sum.volume > 0.0)) {
        touched_.push_back(entry);
        sum.bottom = sum.top = met.height;
    }
    const double seen = length_ > 0.0 ? volume * steps_ / length_ : 0.0; // mm², along the move
    const double surface = seen * met.surface, radius = std::max(met.radius, 0.5 * grid_->edge());
    const glm::dvec3 tangent = -glm::cross(axis_, met.outward);
    sum.volume += volume;
    sum.surface += surface;
    sum.moment += volume * place;
    sum.bottom = std::max(0.0, std::min(sum.bottom, met.height - halfHeight));
    sum.top = std::min(flutes_.back().top, std::max(sum.top, met.height + halfHeight));
    sum.tangentChip += seen / radius * tangent;
    sum.tangentEdge += surface / radius * tangent;
    sum.normalChip += seen / radius * met.normal;
    sum.normalEdge += surface / radius * met.normal;
}

void StepMeter::finish(std::vector<StepCut>& cuts) {
    std::ranges::sort(touched_);
    for (const std::size_t entry : touched_) {
        const Sum sum = std::exchange(sums_[entry], Sum{});
        const auto ofSetup = [&](const glm::dvec3& v) { return glm::vec3(inSetupFrame(*grid_, v)); };
        StepCut cut;
        cut.move = move_;
        cut.step = static_cast<std::uint32_t>(entry / materials_.size());
        cut.material = materials_[entry % materials_.size()];
        cut.steps = steps_;
        cut.volume = static_cast<float>(sum.volume);
        cut.surface = static_cast<float>(sum.surface);
        cut.bottom = static_cast<float>(sum.bottom);
        cut.top = static_cast<float>(sum.top);
        cut.place = ofSetup(sum.moment / sum.volume);
        cut.tangentChip = ofSetup(sum.tangentChip);
        cut.tangentEdge = ofSetup(sum.tangentEdge);
        cut.normalChip = ofSetup(sum.normalChip);
        cut.normalEdge = ofSetup(sum.normalEdge);
        cuts.push_back(cut);
    }
    touched_.clear();
    steps_ = 0;
}

} // namespace burin
