// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

/// The bytes of the open HID stylus protocol 1.1, as described in protocol.md. Pure functions: thread-safe, no
/// allocation (except for descriptionOf), no exception.
namespace burin::openstylus {

inline constexpr std::uint16_t usagePage = 0xffb1;
inline constexpr std::uint16_t usage = 0x0001;
inline constexpr std::uint8_t inputId = 1, outputId = 2, featureId = 3;
inline constexpr std::size_t inputSize = 48, outputSize = 32, featureSize = 64; ///< bytes, with the id
inline constexpr std::uint8_t protocolMajor = 1;

using Bytes = std::span<const std::uint8_t>;

/// Faults reported by the device: bits of the field `faults`.
enum ReportedFault : std::uint16_t {
    reportedWatchdog = 1U << 0,
    reportedNotCalibrated = 1U << 1,
    reportedOverheated = 1U << 2,
    reportedOverloaded = 1U << 3,
    reportedTooFast = 1U << 4,
    reportedStopped = 1U << 5,
    reportedMechanism = 1U << 6,
};

/// An input report.
struct Reading {
    std::uint16_t sequence = 0;     ///< increases by one with each report, wraps around
    std::uint32_t microseconds = 0; ///< time of the pose measurement by the device's clock, wraps around
    Pose pose;                      ///< mm, device frame; rotation as sent, not yet of unit length
    std::uint32_t buttons = 0;
    std::uint16_t faults = 0; ///< ReportedFault; unknown bits are kept
    std::uint16_t echo = 0;   ///< sequence number of the newest valid output report
    bool motorsOn = false, poseValid = false, saturated = false, heard = false;
    std::optional<double> motorHeat; ///< 0 … 1, share of the motors' limit
};
/// Empty if the size, the id, the checksum or the length of the quaternion (1 within 1 %) is wrong.
std::optional<Reading> decodeInput(Bytes report) noexcept;

/// An output report.
struct Command {
    std::uint16_t sequence = 0;
    std::uint16_t echo = 0; ///< sequence number of the input report that it answers
    bool motors = false;    ///< false: motors off, which also acknowledges faults
    Wrench wrench;          ///< N, N·mm; values beyond ± 32767 are sent as ± 32767, values that are not finite as 0
};
std::array<std::uint8_t, outputSize> encodeOutput(const Command& command) noexcept;

/// The feature report.
struct Identity {
    std::uint8_t major = 0, minor = 0; ///< of the protocol
    std::array<int, 3> firmware{};
    Freedoms sensed, actuated;
    int buttons = 0;
    int source = 0;    ///< of the limits: 0 not stated, 1 estimated, 2 measured on this design, 3 on this unit
    double rate = 0.0; ///< Hz
    double watchdog = 0.0, delay = 0.0;               ///< s
    double maximumSpeed = 0.0;                        ///< mm/s
    double maximumForce = 0.0, continuousForce = 0.0; ///< N
    double maximumTorque = 0.0;                       ///< N·mm
    double maximumStiffness = 0.0;                    ///< N/m
    double maximumDamping = 0.0;                      ///< N·s/m
    double maximumTurningStiffness = 0.0;             ///< N·mm/rad
    double workspaceRadius = 0.0, positionStep = 0.0; ///< mm
    double rotationStep = 0.0;                        ///< rad
    double handleMass = 0.0;                          ///< kg that the host has to lift; 0 before version 1.1
    friend bool operator==(const Identity&, const Identity&) = default;
};
enum class IdentityFault : std::uint8_t {
    none,
    foreign,      ///< not this protocol: size, id or mark
    otherVersion, ///< another major version of it
    damaged,      ///< wrong checksum
    outOfRange,   ///< values that no such device can have (protocol.md)
};
IdentityFault decodeFeature(Bytes report, Identity& identity) noexcept;

/// @param name name of the product. Owner's thread: allocates.
StylusDescription descriptionOf(const Identity& identity, const std::string& name);

/// CRC-16/IBM-3740: polynomial 0x1021, initial value 0xffff, not reflected; check value for "123456789": 0x29b1.
std::uint16_t checksumOf(Bytes bytes) noexcept;

} // namespace burin::openstylus
