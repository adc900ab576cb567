// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/hid/uhid_device.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace burin::test {

/// Limits of the force at the device: computed from the device's own values, not taken from the host.
struct ForceBounds {
    double largest = 0.0;       ///< N
    double rise = 0.0;          ///< N from one output report to the next
    double fall = 0.0;          ///< N; switching the force off altogether is never unsafe
    double largestTorque = 0.0; ///< N·mm
    double jump = 0.0;          ///< mm between two readings; a larger jump makes a reading implausible
};

/// Checks the force where the motors would be: compares each output report with the input report that it answers and
/// with the previous output report. It parses the bytes of protocol.md itself. Thread-safe.
class ForceWatch {
public:
    explicit ForceWatch(const ForceBounds& bounds) : bounds_(bounds) {}

    /// Called with a report that is about to be sent to the host.
    void sends(const Report& report);
    /// No answers to earlier reports will follow.
    void forget();
    /// Called with a report from the host.
    void hears(const Report& report);

    /// Of the newest report: whether the host has the motors on, and which input report it answers.
    bool motors() const;
    std::uint16_t answered() const;

    struct Verdict {
        std::uint64_t outputs = 0, pressed = 0; ///< number of output reports, and of those with a force
        std::uint64_t violations = 0;
        std::uint64_t unbelieved = 0;         ///< answers to readings that must not be trusted
        std::array<std::uint64_t, 6> kinds{}; ///< violations: damaged, too large, torque, motors off, slew, believed
        std::string first;                    ///< description of the first violation
        std::string text() const;             ///< all of it, for a message
    };
    Verdict verdict() const;

private:
    enum Violation : std::size_t { damaged, tooLarge, torque, motorsOff, slew, believed };
    /// A reading by its number; several with the same number can't be distinguished.
    struct Sent {
        bool there = false, believable = false, several = false;
        glm::dvec3 position{0.0};
    };
    void violate(Violation violation);

    ForceBounds bounds_;
    mutable std::mutex mutex_;
    std::array<Sent, 65536> sent_{};
    glm::dvec3 before_{0.0};
    std::uint16_t number_ = 0, answered_ = 0;
    bool known_ = false, motors_ = false;
    std::optional<glm::dvec3> position_; ///< of the previously answered reading
    Verdict verdict_;
};

} // namespace burin::test
