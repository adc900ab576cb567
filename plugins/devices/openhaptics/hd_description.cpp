// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/hd_description.h"

#include "core/device/device_fault.h"

#include <algorithm>
#include <cmath>

namespace burin::openhaptics {
namespace {

constexpr double perMetre = 1000.0;      // conversion of values per mm
constexpr int translationsOfSpace = 3;   // these come first in a device's degrees of freedom
constexpr int penButtons = 2;            // of the Touch's pen; libHD does not report them
constexpr double largestRadius = 1000.0; // mm: limit for a desktop device
constexpr const char* told = BURIN_TEXT("Device", "the device itself").text;
constexpr const char* torqueSource = BURIN_TEXT("Device", "CHAI3D 3.3, table of devices: Premium 6DOF").text;

double number(const HdApi& api, unsigned int parameter) noexcept {
    double value = 0.0;
    api.getDoublev(parameter, &value);
    return std::isfinite(value) ? value : 0.0;
}

int wholeNumberOf(const HdApi& api, unsigned int parameter) noexcept {
    int value = 0;
    api.getIntegerv(parameter, &value);
    return value;
}

Freedoms freedomsOf(int count) noexcept {
    const int bounded = std::clamp(count, 0, 2 * translationsOfSpace);
    return {std::min(bounded, translationsOfSpace), std::max(bounded - translationsOfSpace, 0)};
}

/// The workspace radius, mm: half of the shortest side of the workspace.
double radiusOf(const HdApi& api) noexcept {
    std::array<double, 6> box{};
    api.getDoublev(hdUsableWorkspace, box.data());
    const double radius = 0.5 * std::min({box[3] - box[0], box[4] - box[1], box[5] - box[2]});
    return radius > 0.0 && radius <= largestRadius ? radius : 0.0;
}

/// Sets a Figure if the value is known.
template <class Known>
void state(Known& figure, double value) {
    if (value > 0.0) figure = {value, told};
}

glm::dvec3 fromHd(double x, double y, double z) noexcept {
    return {x, -z, y};
}

} // namespace

Result<StylusDescription> describeCurrent(const HdApi& api, const std::string& name) {
    StylusDescription stylus;
    const char* model = api.getString(hdDeviceModel);
    stylus.name = model != nullptr && *model != '\0' ? std::string(model) + " (" + name + ")" : name;
    stylus.sensed = freedomsOf(wholeNumberOf(api, hdInputFreedoms));
    stylus.actuated = freedomsOf(wholeNumberOf(api, hdOutputFreedoms));
    // HDAPI does not report these values; they are those of the Premium 6DOF, the only device with torque
    if (stylus.actuated.rotations > 0) {
        stylus.maximumTorque = {188.0, torqueSource};
        stylus.maximumTurningStiffness = {300.0, torqueSource};
    }
    stylus.buttons = penButtons;
    state(stylus.rate, wholeNumberOf(api, hdUpdateRate));
    state(stylus.maximumForce, number(api, hdNominalForce));
    state(stylus.continuousForce, number(api, hdContinuousForce));
    state(stylus.maximumStiffness, perMetre * number(api, hdNominalStiffness));
    state(stylus.maximumDamping, perMetre * number(api, hdNominalDamping));
    state(stylus.workspaceRadius, radiusOf(api));
    stylus.carriesHandle = true; // by its own springs and weights
    if (Result<void> checked = checkDescription(stylus); !checked)
        return Error{ErrorCode::deviceFault, name, {}, BURIN_TEXT("DeviceReason", "its limits are out of range").text};
    return stylus;
}

Pose poseOf(const std::array<double, 16>& transform) noexcept {
    const auto column = [&](std::size_t i) {
        return fromHd(transform[4 * i], transform[4 * i + 1], transform[4 * i + 2]);
    };
    Pose pose;
    pose.position = column(3);
    // The library's matrix is not exactly a rotation: the pen's axis is kept, the other axes are made perpendicular to
    // it.
    const glm::dvec3 axis = glm::normalize(column(2));
    const glm::dvec3 side = glm::normalize(column(0) - glm::dot(column(0), axis) * axis);
    pose.rotation = glm::quat_cast(glm::dmat3(side, glm::cross(axis, side), axis));
    return pose;
}

std::array<double, 3> toHd(const glm::dvec3& vector) noexcept {
    return {vector.x, vector.z, -vector.y};
}

} // namespace burin::openhaptics
