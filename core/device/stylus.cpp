// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/stylus.h"

#include <cmath>

namespace burin {
namespace {

Error refused(const char* what, const char* allowed) {
    return {ErrorCode::argumentInvalid, "stylus", what, allowed};
}

bool withinThree(Freedoms freedoms) {
    const auto within = [](int count) { return count >= 0 && count <= 3; };
    return within(freedoms.translations) && within(freedoms.rotations);
}

template <UnitName name>
bool stated(const Figure<name>& figure) {
    return std::isfinite(figure.value) && figure.value >= 0.0 && (figure.value == 0.0 || !figure.source.empty());
}

/// The name of the first value that breaks a rule; null if there is none.
const char* faultyFigure(const StylusDescription& of) {
    const struct {
        const char* name;
        bool good;
    } figures[] = {
        {"rate", stated(of.rate)},
        {"delay", stated(of.delay)},
        {"maximum force", stated(of.maximumForce)},
        {"continuous force", stated(of.continuousForce)},
        {"maximum torque", stated(of.maximumTorque)},
        {"maximum stiffness", stated(of.maximumStiffness)},
        {"maximum damping", stated(of.maximumDamping)},
        {"maximum turning stiffness", stated(of.maximumTurningStiffness)},
        {"workspace radius", stated(of.workspaceRadius)},
        {"position step", stated(of.positionStep)},
        {"rotation step", stated(of.rotationStep)},
        {"maximum speed", stated(of.maximumSpeed)},
        {"handle mass", stated(of.handleMass)},
    };
    for (const auto& figure : figures)
        if (!figure.good) return figure.name;
    return nullptr;
}

} // namespace

Result<void> checkDescription(const StylusDescription& description) {
    if (description.name.empty()) return refused("name", "a text");
    if (!withinThree(description.sensed) || !withinThree(description.actuated))
        return refused("degrees of freedom", "0 to 3 translations and 0 to 3 rotations");
    if (description.assist.forceAxes < 0 || description.assist.forceAxes > 2)
        return refused("axes with force", "0 to 2");
    if (description.buttons < 0 || description.buttons > 32) return refused("buttons", "0 to 32");
    if (const char* figure = faultyFigure(description)) return refused(figure, "0 or more, and who says so");
    if (description.workspaceRadius.value == 0.0) return refused("workspace radius", "more than 0 mm");
    if (description.maximumSpeed.value == 0.0) return refused("maximum speed", "more than 0 mm/s");
    if (description.actuated.translations > 0 &&
        (description.maximumForce.value == 0.0 || description.maximumStiffness.value == 0.0))
        return refused("maximum force and stiffness", "more than 0 with motors");
    if (description.actuated.rotations > 0 && description.maximumTorque.value == 0.0)
        return refused("maximum torque", "more than 0 with motors");
    return {};
}

} // namespace burin
