// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/force_dimension/dhd_models.h"

#include "core/base/text.h"
#include "core/base/units.h"

#include <algorithm>
#include <array>

namespace burin::forcedimension {
namespace {

struct Model {
    std::array<int, 5> types; ///< 0: none
    double force;             ///< N
    double stiffness;         ///< N/m, closed loop at 1 kHz
    double damping;           ///< N·s/m
    double radius;            ///< mm
    double torque;            ///< N·mm; 0: no actuated wrist
    double turningStiffness;  ///< N·mm/rad; 0: not known, so that no torque is rendered
};

constexpr std::array models{
    Model{{63}, 20.0, 5000.0, 30.0, 150.0, 0.0, 0.0},                // delta.3
    Model{{33, 34, 36, 35, 37}, 12.0, 5000.0, 30.0, 75.0, 0.0, 0.0}, // omega.3, .6 and .7, right and left
    Model{{104, 105, 206}, 12.0, 4000.0, 30.0, 75.0, 200.0, 1000.0}, // sigma.7 right and left, .3
    Model{{203, 131, 132}, 12.0, 8000.0, 30.0, 112.5, 0.0, 0.0},     // lambda.3, .6
    Model{{108, 109}, 12.0, 8000.0, 30.0, 112.5, 200.0, 0.0},        // lambda.7 right and left
    Model{{60}, 8.0, 3000.0, 20.0, 40.0, 0.0, 0.0},                  // Falcon
};
constexpr const char* table = BURIN_TEXT("Device", "CHAI3D 3.3, table of devices").text;

glm::dvec3 fromDhd(double x, double y, double z) noexcept {
    return {y, -x, z};
}

} // namespace

std::optional<StylusDescription> limitsOf(int type) {
    for (const Model& model : models) {
        if (type <= 0 || std::ranges::find(model.types, type) == model.types.end()) continue;
        StylusDescription limits;
        limits.maximumForce = {model.force, table};
        limits.maximumStiffness = {model.stiffness, table};
        limits.maximumDamping = {model.damping, table};
        limits.workspaceRadius = {model.radius, table};
        if (model.turningStiffness > 0.0) {
            limits.maximumTorque = {model.torque, table};
            limits.maximumTurningStiffness = {model.turningStiffness, table};
        }
        return limits;
    }
    return std::nullopt;
}

Pose poseOf(double x, double y, double z, const double (&rotation)[3][3]) noexcept {
    const auto column = [&](int i) { return fromDhd(rotation[0][i], rotation[1][i], rotation[2][i]); };
    Pose pose;
    pose.position = fromDhd(x, y, z) * millimetresPerMetre;
    // At rest, the pen of these devices lies along their x axis; Burin's tool is parallel to z, from the tip to the
    // holder.
    pose.rotation = glm::normalize(glm::quat_cast(glm::dmat3(-column(2), column(1), column(0))));
    return pose;
}

glm::dvec3 toDhd(const glm::dvec3& vector) noexcept {
    return {-vector.y, vector.x, vector.z};
}

} // namespace burin::forcedimension
