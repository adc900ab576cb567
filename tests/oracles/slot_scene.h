// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/haptic_step.h"
#include "tests/core/device/desktop_stylus.h"
#include "tests/oracles/simulated_handle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace burin::test {

/// A slot of constant depth that a simulated hand mills with a device's handle, through one material or from one into
/// another, with no part in the stock. The force to be felt follows from closed formulas: K times the area of the
/// cutter projected along its motion.
struct SlotCase {
    CutterType cutter = CutterType::flat;
    double radius = 3.0;       ///< mm
    double cornerRadius = 1.0; ///< mm, of a bull nose
    double depth = 1.5;        ///< mm, at most the radius, at least a bull nose's corner radius
    double voxel = 0.2;        ///< mm
    double speed = 20.0;       ///< mm/s, of the intended position
    double heading = 0.0;      ///< rad, of the feed in the plane across the tool axis
    double firstEnergy = 1.0;  ///< K, J/mm³
    double secondEnergy = 1.0;
    double radialRatio = 0.0; ///< Kr of both materials
    /// The border has the shape of the cutter's front, so that the whole front crosses it at once; otherwise it is a
    /// plane.
    bool borderLikeFront = true;
    SimulatedGrip grip = middleGrip;
    SimulatedMechanism mechanism{};
    double stiffness = 320.0;  ///< N/m, of the coupling
    double maximumForce = 2.4; ///< N, largest force that is ever sent
};

/// Measured values of the force that the hand felt.
struct SlotFigures {
    double expected = 0.0;       ///< N, against the feed in the first material, by formula
    double expectedSecond = 0.0; ///< N, in the second one
    double forceError = 0.0; ///< relative error of mean forces against the feed to `expected`, worse of both materials
    double noise = 0.0;      ///< N, the largest change from tick to tick within either material
    double creep = 0.0;      ///< mm/s, of the tool, root mean square, while the intended position rests in the slot
    /// Ticks from the first one that removed anything of the second material to the first force that changed by more
    /// than a tenth of the total change; 0: at once or before, because the force looks a voxel ahead. Negative: no
    /// change followed.
    int ticksToChange = -1;
};

class SlotScene {
public:
    explicit SlotScene(const SlotCase& of)
        : case_(of)
        , direction_(std::cos(of.heading), std::sin(of.heading), 0.0)
        , volume_(stock(of, direction_))
        , step_(volume_, field_, tool(of), settings(of))
        , handle_(of.grip, of.mechanism, place(-startDistance(of))) {}

    /// Starts outside, mills through the first material into the second, then rests.
    SlotFigures mill() {
        SlotFigures figures;
        figures.expected = expectedForce(case_.firstEnergy);
        figures.expectedSecond = expectedForce(case_.secondEnergy);
        // Samples near the border are not judged: there the material changes, and the hand oscillates.
        const double clear = 2.0 * case_.radius + 4.0, end = slotLength + 4.0;
        double sum = 0.0, sumSecond = 0.0;
        int count = 0, countSecond = 0, firstOfSecond = -1, firstChange = -1;
        const double change = figures.expectedSecond - figures.expected;
        glm::dvec3 last(0.0);
        const int ticks = static_cast<int>((startDistance(case_) + end) / case_.speed / period);
        for (int tick = 0; tick < ticks; ++tick) {
            const Sample sample = this->tick(place(-startDistance(case_) + case_.speed * period * (tick + 1)));
            const double at = glm::dot(sample.proxy.tip, direction_), force = -glm::dot(sample.force, direction_);
            const bool inFirst = at > -slotLength + clear && at<-clear, inSecond = at> clear;
            if (inFirst) sum += force, ++count;
            if (inSecond) sumSecond += force, ++countSecond;
            if (inFirst || inSecond) figures.noise = std::max(figures.noise, glm::length(sample.force - last));
            last = sample.force;
            const bool metSecond = std::any_of(sample.removed.begin(), sample.removed.end(), [](const auto& removed) {
                return removed.property == second && removed.units > 0;
            });
            if (metSecond && firstOfSecond < 0) firstOfSecond = tick;
            const bool shows = change != 0.0 && at > -clear && (force - figures.expected) / change > 0.1;
            if (shows && firstChange < 0) firstChange = tick;
        }
        if (firstChange >= 0) figures.ticksToChange = std::max(0, firstChange - firstOfSecond);
        const auto off = [](double mean, double expected) { return std::abs(mean / expected - 1.0); };
        figures.forceError =
            std::max(off(sum / count, figures.expected), off(sumSecond / countSecond, figures.expectedSecond));
        figures.creep = creepAtRest(place(end));
        return figures;
    }

    /// One tick of hand, device and loop. @param intent mm, position the hand intends to hold
    Sample tick(const glm::dvec3& intent) {
        StylusState state;
        state.pose.position = handle_.reading();
        state.valid = true;
        const Sample sample = step_.advance(state, period);
        handle_.hold(step_.deviceWrench().force, intent, glm::dvec3(0.0), period);
        return sample;
    }

    /// mm, a point on the slot's centre line, at the given distance from the border.
    glm::dvec3 place(double along) const { return along * direction_ - glm::dvec3(0.0, 0.0, case_.depth); }
    HapticStep& step() noexcept { return step_; }

    /// N against the feed: K A scaled by the device's share and the reference cut (a slot of one radius depth in the
    /// harder material), by formula alone.
    double expectedForce(double energy) const {
        const double hardest = std::max(case_.firstEnergy, case_.secondEnergy);
        const double reference = hardest * area(case_, case_.radius);
        return 0.6 * case_.maximumForce * energy * area(case_, case_.depth) * (1.0 + case_.radialRatio) / reference;
    }

    /// mm²: area of the cutter, projected along the feed, in a slot of this depth.
    static double area(const SlotCase& of, double depth) {
        const double r = of.radius;
        switch (of.cutter) {
        case CutterType::ball: // segment of a circle
            return r * r * std::acos(1.0 - depth / r) - (r - depth) * std::sqrt((2.0 * r - depth) * depth);
        case CutterType::bullNose: // two corners of a square without their quarter circles are missing
            return 2.0 * r * depth - 2.0 * of.cornerRadius * of.cornerRadius * (1.0 - 0.25 * pi);
        default:
            return 2.0 * r * depth;
        }
    }

private:
    static constexpr double period = 0.001;    ///< s
    static constexpr double slotLength = 24.0; ///< mm, through each of the materials
    static constexpr PropertyIndex first = 1, second = 2;

    /// A clearance field without any obstacle.
    class NoPart final : public ClearanceField {
        FieldSample at(const glm::dvec3&) const noexcept override { return {1e3, {0.0, 0.0, 1.0}, false}; }
        double errorBound() const noexcept override { return 0.0; }
        double spacing() const noexcept override { return 0.25; }
    };

    /// mm above the tip: height of the cutter's lower surface at a distance from its axis; very high beyond the radius.
    static double heightOf(const SlotCase& of, double distance) {
        if (distance >= of.radius) return 1e3;
        const double corner = of.cutter == CutterType::ball       ? of.radius
                              : of.cutter == CutterType::bullNose ? of.cornerRadius
                                                                  : 0.0;
        const double inCorner = std::max(0.0, distance - (of.radius - corner));
        return corner - std::sqrt(corner * corner - inCorner * inCorner);
    }

    static double startDistance(const SlotCase& of) { return slotLength + of.radius + 2.0; }

    static Tool tool(const SlotCase& of) {
        Tool tool;
        tool.id = "slot";
        tool.cutter.type = of.cutter;
        tool.cutter.diameter = 2.0 * of.radius;
        if (of.cutter == CutterType::ball) tool.cutter.cornerRadius = of.radius;
        if (of.cutter == CutterType::bullNose) tool.cutter.cornerRadius = of.cornerRadius;
        tool.cutter.fluteLength = 15.0;
        tool.cutter.shankDiameter = 1.8 * of.radius;
        tool.cutter.stickOut = 30.0;
        return tool;
    }

    static HapticSettings settings(const SlotCase& of) {
        HapticSettings settings;
        settings.stylus = desktopStylus();
        settings.stylus.name = "slot";
        settings.stylus.maximumForce = {of.maximumForce / settings.forceShare, "made up"};
        settings.stylus.maximumStiffness = {of.stiffness / settings.couplingShare, "made up"};
        settings.stylus.positionStep = {of.mechanism.encoder, "made up"};
        settings.rampSeconds = 0.0;
        return settings;
    }

    static Property material(const char* id, double energy, double radialRatio) {
        Property property;
        property.id = id;
        property.values[std::string(specificCuttingEnergy)] = {energy, "J/mm^3", "made up", true};
        property.values[std::string(radialForceRatio)] = {radialRatio, "1", "made up", true};
        return property;
    }

    /// A block that extends by slotLength to either side of the border along the feed, with its top at 0.
    static RunVolume stock(const SlotCase& of, const glm::dvec3& direction) {
        PropertyList properties;
        const bool listed = properties.add(material("first", of.firstEnergy, of.radialRatio)).hasValue() &&
                            properties.add(material("second", of.secondEnergy, of.radialRatio)).hasValue();
        const double half = slotLength + 12.0;
        const auto lines = static_cast<int>(std::ceil(2.0 * half / of.voxel));
        const Grid grid = *Grid::make({-half, -half, -of.depth - 2.0}, of.voxel,
                                      {lines, lines, static_cast<int>((of.depth + 4.0) / of.voxel)});
        RunVolume volume = *RunVolume::make(grid, properties);
        const RunPosition top = grid.toRunPosition(0.0);
        for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
            for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
                const glm::dvec2 at = grid.lineCentre({u, v});
                const double along = at.x * direction.x + at.y * direction.y;
                if (along < -slotLength) continue;
                // In the shape of the cutter: the region that it occupies while its axis is at the border is of the
                // first material.
                const double height = of.borderLikeFront && along > 0.0 ? heightOf(of, glm::length(at))
                                      : along > 0.0                     ? 1e3
                                                                        : 0.0;
                const RunPosition border = grid.toRunPosition(std::min(0.0, height - of.depth));
                if (!listed || !volume.fillSpan({u, v}, 0, top, first)) std::abort();
                if (along > 0.0 && !volume.fillSpan({u, v}, 0, border, second)) std::abort();
            }
        return volume;
    }

    /// The intended position rests: speed of the tool in the last fifth of two seconds.
    double creepAtRest(const glm::dvec3& intent) {
        constexpr int ticks = 2000, judged = 400;
        double squares = 0.0;
        for (int i = 0; i < ticks; ++i) {
            tick(intent);
            if (i >= ticks - judged) squares += glm::dot(handle_.velocity(), handle_.velocity());
        }
        return std::sqrt(squares / judged);
    }

    SlotCase case_;
    glm::dvec3 direction_;
    NoPart field_;
    RunVolume volume_;
    HapticStep step_;
    SimulatedHandle handle_;
};

} // namespace burin::test
