// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/load_chart.h"

#include "core/base/units.h"
#include "core/cutting/cutting_force.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double windowPerRadius = 0.25, windowVoxels = 3.0;
constexpr double straightEnough = 0.7; // cosine of the bend that a window may span

/// Position of a move on the path: lengths add up, and an interval is a part without rapids and sharp bends.
struct PathPosition {
    double start = 0.0, length = 0.0; ///< mm
    std::size_t interval = 0;
    double before = 0.0; ///< mm, of the same motion, before this move
};

class PathLengths {
public:
    PathLengths(const std::vector<ToolMove>& moves, std::size_t motions) : of_(moves.size()), motions_(motions) {
        double now = 0.0;
        for (std::size_t i = 0; i < moves.size(); ++i) {
            const ToolMove& move = moves[i];
            PathPosition& position = of_[i];
            if (i == 0 || breaks(moves[i - 1], move)) intervals_.push_back({now, now});
            position = {now, glm::distance(move.begin().tip, move.to.tip), intervals_.size() - 1,
                        motions_[move.motion]};
            now += position.length;
            motions_[move.motion] += position.length;
            intervals_.back().second = now;
        }
    }
    const PathPosition& operator[](std::size_t move) const { return of_[move]; }
    double ofMotion(std::size_t motion) const { return motions_[motion]; }
    /// Length of the path within a distance of a position, in its interval, mm.
    double around(double position, std::size_t interval, double half) const {
        const auto& [begin, end] = intervals_[interval];
        return std::min(end, position + half) - std::max(begin, position - half);
    }

private:
    static bool breaks(const ToolMove& before, const ToolMove& move) {
        if (before.rapid || move.rapid || !move.startKnown || before.tool != move.tool) return true;
        const glm::dvec3 a = before.to.tip - before.begin().tip, b = move.to.tip - move.begin().tip;
        const double lengths = glm::length(a) * glm::length(b);
        return lengths > 0.0 && glm::dot(a, b) < straightEnough * lengths;
    }
    std::vector<PathPosition> of_;
    std::vector<double> motions_;                      ///< mm
    std::vector<std::pair<double, double>> intervals_; ///< mm, begin and end
};

/// Upper limit of what a move can meet: the projection of the flutes along it, up to a height.
class Silhouette {
public:
    explicit Silhouette(const Cutter& cutter) : radius_(cutter.radius()), height_(cutter.fluteLength) {
        for (std::size_t i = 0; i < upTo_.size(); ++i)
            upTo_[i] = slotArea(cutter, height_ * static_cast<double>(i) / last);
    }
    /// Area, mm²; never too small. @param way of any length @param top mm above the tip
    double along(const glm::dvec3& way, double top) const noexcept {
        const double length = glm::length(way);
        const double down = length > 0.0 ? std::abs(way.z) / length : 1.0, level = std::sqrt(1.0 - down * down);
        const double at = std::ceil(std::clamp(top / height_, 0.0, 1.0) * last);
        return level * upTo_[static_cast<std::size_t>(at)] + down * pi * radius_ * radius_;
    }

private:
    static constexpr double last = 256.0; ///< last index in upTo_
    double radius_, height_;              ///< mm
    std::array<double, 257> upTo_;        ///< mm², seen from the side, by height
};

/// Sums of one material over a part of the path.
struct MetMaterial {
    PropertyIndex material = airProperty;
    double volume = 0.0, surface = 0.0; ///< mm³; mm² times mm
    glm::dvec3 tangentChip{0.0}, tangentEdge{0.0}, normalChip{0.0}, normalEdge{0.0};

    void scale(double share) {
        for (double* sum : {&volume, &surface}) *sum *= share;
        for (glm::dvec3* sum : {&tangentChip, &tangentEdge, &normalChip, &normalEdge}) *sum *= share;
    }
};

/// Means over a part of the path.
struct Engaged {
    double length = 0.0;    ///< length of path that this is summed over, mm
    double most = 0.0;      ///< largest area that the tool can meet along it, mm²
    double volume = 0.0;    ///< mm³
    glm::dvec3 moment{0.0}; ///< mm³ times mm
    std::vector<MetMaterial> materials;

    /// @param share fraction of the step @param way its length of path, mm
    void add(const StepCut& cut, double share, double way) {
        volume += share * cut.volume;
        moment += share * cut.volume * glm::dvec3(cut.place);
        MetMaterial& met = of(cut.material);
        met.volume += share * cut.volume;
        met.surface += way * cut.surface;
        met.tangentChip += way * glm::dvec3(cut.tangentChip);
        met.tangentEdge += way * glm::dvec3(cut.tangentEdge);
        met.normalChip += way * glm::dvec3(cut.normalChip);
        met.normalEdge += way * glm::dvec3(cut.normalEdge);
    }
    /// On a path shorter than a voxel, whole columns of voxels would count for more than the size of the tool.
    void keepWithinTool() {
        if (!(volume > most * length)) return;
        const double share = most * length / volume;
        volume *= share;
        moment *= share;
        for (MetMaterial& met : materials) met.scale(share);
    }

private:
    MetMaterial& of(PropertyIndex material) {
        const auto found = std::ranges::find(materials, material, &MetMaterial::material);
        if (found != materials.end()) return *found;
        return materials.emplace_back(MetMaterial{.material = material});
    }
};

/// The rotation and speed of a tool in a motion.
struct Turning {
    double speed = 0.0;  ///< mm/s of the tip
    double turns = 0.0;  ///< 1/s
    double radius = 0.0; ///< mm
    int teeth = 1;
    bool clockwise = true;
};

Turning turningOf(const NcMotion& motion, const Tool& tool, const MotionTime& time) {
    Turning turning;
    turning.speed = motion.feed / secondsPerMinute;
    if (time.peakSpeed > 0.0) turning.speed = std::min(turning.speed, time.peakSpeed);
    turning.turns = motion.spindleOn() ? motion.spindleSpeed / secondsPerMinute : 0.0;
    turning.radius = tool.cutter.radius();
    turning.teeth = std::max(1, tool.fluteCount);
    turning.clockwise = motion.spindle != SpindleState::anticlockwise;
    return turning;
}

/// Adds the load of one material.
void addLoad(const MetMaterial& met, double length, const Turning& turning, const CuttingCoefficients::Entry& material,
             CutLoad& load) {
    const double edgeSpeed = 2.0 * pi * turning.radius * turning.turns, teeth = turning.turns * turning.teeth; // 1/s
    const double surface = met.surface / length;
    if (!(surface > 0.0)) return;
    const double removalRate = met.volume / length * turning.speed;
    const double perChip = newtonMillimetresPerJoule * material.energyAt(removalRate / (teeth * surface)); // N/mm²
    const double ofChip = perChip * removalRate / edgeSpeed;
    const double edge = turning.teeth * surface / (2.0 * pi * turning.radius); // mm, engaged on average
    load.force += ofChip + material.edgeForce * edge;
    load.radial += material.radialRatio * ofChip + material.radialEdgeForce * edge;
    const double chip = perChip * load.feedPerTooth, sense = turning.clockwise ? 1.0 : -1.0;
    const glm::dvec3 sum = sense * (chip * met.tangentChip + material.edgeForce * met.tangentEdge) +
                           chip * material.radialRatio * met.normalChip + material.radialEdgeForce * met.normalEdge;
    load.vector += -turning.teeth / (2.0 * pi) / length * sum;
}

/// @param top, bottom mm above the tip, of the material met
CutLoad loadOf(const Engaged& engaged, float bottom, float top, const Turning& turning,
               const CuttingCoefficients& coefficients) {
    CutLoad load;
    const double length = engaged.length;
    load.place = engaged.moment / engaged.volume;
    load.depth = top - bottom;
    load.height = 0.5 * (top + bottom);
    const double area = engaged.volume / length;
    double surface = 0.0;
    for (const MetMaterial& met : engaged.materials) surface += met.surface / length;
    if (load.depth > 0.0) load.width = std::min(area / load.depth, 2.0 * turning.radius); // a plunge has no depth
    load.removalRate = area * turning.speed;
    const double edgeSpeed = 2.0 * pi * turning.radius * turning.turns, teeth = turning.turns * turning.teeth; // 1/s
    if (!(edgeSpeed > 0.0) || !(surface > 0.0)) return load;
    load.feedPerTooth = turning.speed / teeth;
    load.chip = load.removalRate / (teeth * surface);
    for (const MetMaterial& met : engaged.materials)
        addLoad(met, length, turning, coefficients.byProperty[met.material], load);
    load.power = load.force * edgeSpeed / newtonMillimetresPerJoule;
    load.torque = load.force * turning.radius / millimetresPerMetre;
    load.axial = load.vector.z;
    load.side = std::hypot(load.vector.x, load.vector.y);
    return load;
}

bool isLess(const CutLoad& a, const CutLoad& b) {
    return a.force != b.force ? a.force < b.force : a.removalRate < b.removalRate;
}

/// Iterates over the steps, each with the part of the path around it.
class LoadRecorder {
public:
    LoadRecorder(const ReplayedProgram& replayed, const PropertyList& properties)
        : replayed_(replayed), lengths_(*replayed.moves, replayed.program->motions.size()) {
        for (const Tool& tool : replayed.tools) {
            coefficients_.push_back(cuttingCoefficients(properties, tool.cutter.diameter));
            silhouettes_.emplace_back(tool.cutter);
        }
    }

    LoadRecord record(const LoadVisitor& visit) {
        startMotions();
        const std::vector<StepCut>& steps = *replayed_.steps;
        for (std::size_t i = 0; i < steps.size();) {
            std::size_t end = i + 1; // of the same step, whatever the material
            while (end < steps.size() && steps[end].move == steps[i].move && steps[end].step == steps[i].step) ++end;
            tell(i, end, visit);
            i = end;
        }
        finishMotions();
        return std::move(record_);
    }

private:
    /// Sums what the motions removed over all the straight moves that they consist of.
    void startMotions() {
        byMotion_.resize(replayed_.program->motions.size());
        for (std::size_t i = 0; i < replayed_.moves->size(); ++i) {
            MotionLoad& load = byMotion_[(*replayed_.moves)[i].motion];
            const MoveCut& cut = (*replayed_.cuts)[i];
            load.volume += cut.volume;
            load.place += cut.volume * cut.centroid;
        }
    }
    void finishMotions() {
        for (std::size_t i = 0; i < byMotion_.size(); ++i) {
            MotionLoad& load = byMotion_[i];
            if (!(load.volume > 0.0)) continue;
            load.motion = static_cast<std::uint32_t>(i);
            load.line = replayed_.program->motions[i].line;
            load.start = replayed_.time->motions[i].start;
            load.duration = replayed_.time->motions[i].duration;
            load.place /= load.volume;
            const double perSecond = load.duration > 0.0 ? 1.0 / load.duration : 0.0;
            load.removalRate = load.volume * perSecond;
            load.force *= perSecond; // sums over time so far
            load.power *= perSecond;
            record_.motions.push_back(load);
        }
    }

    double lengthOf(const StepCut& cut) const { return lengths_[cut.move].length / cut.steps; }
    double startOf(const StepCut& cut) const { return lengths_[cut.move].start + cut.step * lengthOf(cut); }
    double windowOf(const StepCut& cut) const {
        const double radius = replayed_.tools[(*replayed_.moves)[cut.move].tool].cutter.radius();
        return std::max(windowPerRadius * radius, windowVoxels * replayed_.voxel);
    }

    /// Sums over the path around a step, in its interval; steps at the ends count with the fraction that lies within.
    Engaged around(std::size_t i) const {
        const std::vector<StepCut>& steps = *replayed_.steps;
        const StepCut& here = steps[i];
        const std::size_t interval = lengths_[here.move].interval;
        const double middle = startOf(here) + 0.5 * lengthOf(here);
        const double half = 0.5 * std::max(windowOf(here), lengthOf(here));
        Engaged engaged;
        engaged.length = lengths_.around(middle, interval, half);
        // False if it lies outside, as do all beyond it
        const auto add = [&](const StepCut& cut) {
            if (lengths_[cut.move].interval != interval) return false;
            const double begins = startOf(cut), length = lengthOf(cut);
            const double way = std::min(begins + length, middle + half) - std::max(begins, middle - half);
            if (!(way > 0.0) && length > 0.0) return false;
            if (length > 0.0) engaged.add(cut, way / length, way);
            const ToolMove& move = (*replayed_.moves)[cut.move];
            engaged.most =
                std::max(engaged.most, silhouettes_[move.tool].along(move.to.tip - move.begin().tip, cut.top));
            return true;
        };
        for (std::size_t k = i + 1; k-- > 0 && add(steps[k]);) {
        }
        for (std::size_t k = i + 1; k < steps.size() && add(steps[k]); ++k) {
        }
        engaged.keepWithinTool();
        return engaged;
    }

    /// @param i, end range of the step's records, one per material
    void tell(std::size_t i, std::size_t end, const LoadVisitor& visit) {
        StepCut here = (*replayed_.steps)[i];
        for (std::size_t other = i + 1; other < end; ++other) here.add((*replayed_.steps)[other]);
        const ToolMove& move = (*replayed_.moves)[here.move];
        const NcMotion& motion = replayed_.program->motions[move.motion];
        const MotionTime& time = replayed_.time->motions[move.motion];
        const PathPosition& path = lengths_[here.move];
        const Engaged engaged = around(i);
        if (!(engaged.length > 0.0) || !(engaged.volume > 0.0)) return;
        const Turning turning = turningOf(motion, replayed_.tools[move.tool], time);
        const CuttingCoefficients& coefficients = coefficients_[move.tool];
        CutLoad load = loadOf(engaged, here.bottom, here.top, turning, coefficients);
        const double all = lengths_.ofMotion(move.motion), share = lengthOf(here) / all;
        const double begin = (path.before + here.step * lengthOf(here)) / all;
        load.at = time.start + time.duration * (begin + 0.5 * share);
        MotionLoad& sum = byMotion_[move.motion];
        if (turning.speed > 0.0) {
            sum.force += load.force * lengthOf(here) / turning.speed;
            sum.power += load.power * lengthOf(here) / turning.speed;
        }
        if (isLess(sum.peak, load)) sum.peak = load;
        record_.steps.push_back({static_cast<float>(time.start + time.duration * begin),
                                 static_cast<float>(time.duration * share), static_cast<float>(load.force),
                                 static_cast<float>(load.power), move.motion});
        if (!visit) return;
        const std::function<CutLoad(double)> at = [&](double feed) {
            Turning slower = turning;
            slower.speed = feed / secondsPerMinute;
            return loadOf(engaged, here.bottom, here.top, slower, coefficients);
        };
        visit({move.motion, motion, move.tool, load, turning.speed * secondsPerMinute, at});
    }

    const ReplayedProgram& replayed_;
    PathLengths lengths_;
    std::vector<CuttingCoefficients> coefficients_; ///< by tool
    std::vector<Silhouette> silhouettes_;           ///< by tool
    std::vector<MotionLoad> byMotion_;
    LoadRecord record_;
};

} // namespace

LoadRecord recordLoads(const ReplayedProgram& replayed, const PropertyList& properties, const LoadVisitor& visit) {
    return LoadRecorder(replayed, properties).record(visit);
}

const MotionLoad* peakLoad(const std::vector<MotionLoad>& loads) {
    const auto less = [](const MotionLoad& a, const MotionLoad& b) { return isLess(a.peak, b.peak); };
    const auto peak = std::max_element(loads.begin(), loads.end(), less);
    return peak == loads.end() ? nullptr : &*peak;
}

} // namespace burin
