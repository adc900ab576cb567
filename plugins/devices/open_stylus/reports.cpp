// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/reports.h"

#include <algorithm>
#include <cmath>

namespace burin::openstylus {
namespace {

// Powers of two, so that every value of a report is an exact double.
constexpr double perLength = 0x1.0p-16;     // mm, N, N·mm, N·s/m
constexpr double perRotation = 0x1.0p-30;   // quaternion, rad
constexpr double perStiffness = 0x1.0p-8;   // N/m, N·mm/rad
constexpr double perFineLength = 0x1.0p-24; // mm
constexpr double perMass = 0x1.0p-16;       // kg
constexpr int massSince = 1;                // minor version of the protocol that introduced the mass
constexpr double heatScale = 200.0;
constexpr std::uint8_t heatUnknown = 255;
constexpr double unitTolerance = 0.01;

/// Reads little-endian numbers one after the other.
class Reader {
public:
    explicit Reader(Bytes bytes, std::size_t at = 0) noexcept : bytes_(bytes), at_(at) {}
    std::uint8_t u8() noexcept { return bytes_[at_++]; }
    std::uint16_t u16() noexcept {
        const unsigned low = u8();
        return static_cast<std::uint16_t>(low | static_cast<unsigned>(u8()) << 8U);
    }
    std::uint32_t u32() noexcept {
        const std::uint32_t low = u16();
        return low | static_cast<std::uint32_t>(u16()) << 16U;
    }
    double scaled(double unit) noexcept { return static_cast<double>(static_cast<std::int32_t>(u32())) * unit; }
    double scaledUnsigned(double unit) noexcept { return static_cast<double>(u32()) * unit; }
    glm::dvec3 vector(double unit) noexcept {
        const double x = scaled(unit), y = scaled(unit), z = scaled(unit);
        return {x, y, z};
    }

private:
    Bytes bytes_;
    std::size_t at_;
};

class Writer {
public:
    explicit Writer(std::span<std::uint8_t> bytes) noexcept : bytes_(bytes) {}
    void u8(unsigned value) noexcept { bytes_[at_++] = static_cast<std::uint8_t>(value); }
    void u16(unsigned value) noexcept {
        u8(value & 0xffU);
        u8(value >> 8U & 0xffU);
    }
    void u32(std::uint32_t value) noexcept {
        u16(value & 0xffffU);
        u16(value >> 16U);
    }
    void scaled(double value, double unit) noexcept {
        constexpr double largest = 32767.0 / perLength;
        const double steps = std::isfinite(value) ? std::clamp(std::round(value / unit), -largest, largest) : 0.0;
        u32(static_cast<std::uint32_t>(static_cast<std::int32_t>(steps)));
    }
    void vector(const glm::dvec3& value, double unit) noexcept {
        for (int axis = 0; axis < 3; ++axis) scaled(value[axis], unit);
    }

private:
    std::span<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

bool whole(Bytes report, std::size_t size, std::uint8_t id) noexcept {
    return report.size() == size && report[0] == id &&
           Reader(report, size - 2).u16() == checksumOf(report.first(size - 2));
}

Freedoms freedoms(unsigned packed) noexcept {
    return {static_cast<int>(packed & 0xfU), static_cast<int>(packed >> 4U)};
}

bool withinThree(Freedoms freedoms) noexcept {
    return freedoms.translations <= 3 && freedoms.rotations <= 3;
}

bool inRange(const Identity& identity) noexcept {
    const bool pushes = identity.actuated.translations > 0, turns = identity.actuated.rotations > 0;
    return withinThree(identity.sensed) && withinThree(identity.actuated) && identity.buttons <= 32 &&
           identity.source <= 3 && identity.rate >= 100.0 && identity.rate <= 8000.0 && identity.watchdog >= 0.002 &&
           identity.watchdog <= 0.1 && identity.workspaceRadius > 0.0 && identity.maximumSpeed > 0.0 &&
           (!pushes || (identity.maximumForce > 0.0 && identity.maximumStiffness > 0.0)) &&
           (!turns || identity.maximumTorque > 0.0);
}

const char* wordsOf(int source) {
    constexpr std::array words{
        "the device's own report, which does not say how it knows", "the device's own report, estimated by its maker",
        "the device's own report, measured on its design", "the device's own report, measured on this unit"};
    return words[static_cast<std::size_t>(std::clamp(source, 0, 3))];
}

} // namespace

std::uint16_t checksumOf(Bytes bytes) noexcept {
    std::uint32_t crc = 0xffffU;
    for (const std::uint8_t byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte) << 8U;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? crc << 1U ^ 0x1021U : crc << 1U;
    }
    return static_cast<std::uint16_t>(crc & 0xffffU);
}

std::optional<Reading> decodeInput(Bytes report) noexcept {
    if (!whole(report, inputSize, inputId)) return std::nullopt;
    Reader in(report, 1);
    Reading reading;
    const unsigned flags = in.u8();
    reading.motorsOn = (flags & 1U) != 0;
    reading.poseValid = (flags & 2U) != 0;
    reading.saturated = (flags & 4U) != 0;
    reading.heard = (flags & 8U) != 0;
    reading.sequence = in.u16();
    reading.microseconds = in.u32();
    reading.pose.position = in.vector(perLength);
    const double w = in.scaled(perRotation);
    const glm::dvec3 axis = in.vector(perRotation);
    reading.pose.rotation = glm::dquat(w, axis.x, axis.y, axis.z);
    if (!(std::abs(glm::length(reading.pose.rotation) - 1.0) <= unitTolerance)) return std::nullopt;
    reading.buttons = in.u32();
    reading.faults = in.u16();
    reading.echo = in.u16();
    const std::uint8_t heat = in.u8();
    if (heat != heatUnknown) reading.motorHeat = static_cast<double>(heat) / heatScale;
    return reading;
}

std::array<std::uint8_t, outputSize> encodeOutput(const Command& command) noexcept {
    std::array<std::uint8_t, outputSize> report{};
    Writer out(report);
    out.u8(outputId);
    out.u8(command.motors ? 1U : 0U);
    out.u16(command.sequence);
    out.vector(command.wrench.force, perLength);
    out.vector(command.wrench.torque, perLength);
    out.u16(command.echo);
    out.u16(checksumOf(Bytes(report).first(outputSize - 2)));
    return report;
}

IdentityFault decodeFeature(Bytes report, Identity& identity) noexcept {
    constexpr std::array<std::uint8_t, 4> mark{'O', 'S', 'T', 'Y'};
    if (report.size() < featureSize || report[0] != featureId || !std::ranges::equal(report.subspan(4, 4), mark))
        return IdentityFault::foreign;
    identity.major = report[1];
    identity.minor = report[2];
    if (identity.major != protocolMajor) return IdentityFault::otherVersion;
    if (!whole(report, featureSize, featureId)) return IdentityFault::damaged;
    if (report[3] != 1) return IdentityFault::outOfRange; // values are in other units
    Reader in(report, 8);
    const int major = in.u8(), minor = in.u8(), patch = in.u16();
    identity.firmware = {major, minor, patch};
    identity.sensed = freedoms(in.u8());
    identity.actuated = freedoms(in.u8());
    identity.buttons = in.u8();
    identity.source = in.u8();
    identity.rate = in.u16();
    identity.watchdog = 1e-3 * in.u16();
    identity.delay = 1e-6 * in.u16();
    identity.maximumSpeed = in.u16();
    identity.maximumForce = in.scaledUnsigned(perLength);
    identity.continuousForce = in.scaledUnsigned(perLength);
    identity.maximumTorque = in.scaledUnsigned(perLength);
    identity.maximumStiffness = in.scaledUnsigned(perStiffness);
    identity.maximumDamping = in.scaledUnsigned(perLength);
    identity.maximumTurningStiffness = in.scaledUnsigned(perStiffness);
    identity.workspaceRadius = in.scaledUnsigned(perLength);
    identity.positionStep = in.scaledUnsigned(perFineLength);
    identity.rotationStep = in.scaledUnsigned(perRotation);
    const std::uint16_t mass = in.u16();
    identity.handleMass = identity.minor >= massSince ? mass * perMass : 0.0;
    return inRange(identity) ? IdentityFault::none : IdentityFault::outOfRange;
}

StylusDescription descriptionOf(const Identity& identity, const std::string& name) {
    const std::string source = wordsOf(identity.source);
    StylusDescription description;
    description.name = name;
    description.sensed = identity.sensed;
    description.actuated = identity.actuated;
    description.buttons = identity.buttons;
    description.rate = {identity.rate, source};
    description.delay = {identity.delay, source};
    description.maximumForce = {identity.maximumForce, source};
    description.continuousForce = {identity.continuousForce, source};
    description.maximumTorque = {identity.maximumTorque, source};
    description.maximumStiffness = {identity.maximumStiffness, source};
    description.maximumDamping = {identity.maximumDamping, source};
    description.maximumTurningStiffness = {identity.maximumTurningStiffness, source};
    description.workspaceRadius = {identity.workspaceRadius, source};
    description.positionStep = {identity.positionStep, source};
    description.rotationStep = {identity.rotationStep, source};
    description.maximumSpeed = {identity.maximumSpeed, source};
    description.handleMass = {identity.handleMass, source};
    return description;
}

} // namespace burin::openstylus
