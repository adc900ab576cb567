// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/driver_thread.h"
#include "core/device/stylus.h"
#include "plugins/devices/haply/messages.h"
#include "plugins/devices/haply/service.h"
#include "plugins/devices/haply/state_scanner.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace burin::haply {

/// An Inverse3, with a VerseGrip if there is one, through Haply's service. Its own thread paces the loop: a thousand
/// times a second it sends a force and receives the resulting state; the service lets the arm go idle when nothing is
/// sent. The position of the arm at the time of the connection becomes the centre of its workspace.
///
/// Late messages make readings invalid; a broken connection is re-established by attempts twice a second. Which of the
/// two names for a force the service understands is determined from the forces that the arm renders. Threads as for
/// SelfPacedStylus.
class InverseStylus final : public SelfPacedStylus {
public:
    static constexpr double period = 0.001;     ///< s
    static constexpr double lateAfter = 0.003;  ///< s without an answer after which readings are invalid
    static constexpr double faultyAfter = 0.05; ///< s after which it is a fault
    static constexpr double brokenAfter = 1.0;  ///< s after which the connection is re-established
    static constexpr double lookEvery = 0.5;    ///< s, interval of the connection attempts
    static constexpr int answersUntilDeaf = 20; ///< number of answers without the requested force
    static constexpr double stopWithin = 0.2;   ///< s for the thread to end by itself

    /// Connects to an arm. Errors: deviceNotFound (no service, no such arm).
    static Result<std::unique_ptr<SelfPacedStylus>> connect(const std::string& arm);
    /// @param connection whose first message was read @param first content of that message
    InverseStylus(std::string arm, std::unique_ptr<ServiceConnection> connection, const ServiceState& first);
    ~InverseStylus() override { stop(); }
    InverseStylus(const InverseStylus&) = delete;
    InverseStylus& operator=(const InverseStylus&) = delete;

    StylusDescription description() const override;
    Result<void> open() override { return {}; } ///< connected since its construction
    void close() noexcept override { stop(); }
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    /// Closes the connection: the arm goes idle, and is connected again.
    void cutMotors() noexcept override;
    /// Errors: argumentInvalid (already started), outOfMemory.
    Result<void> start(StylusClient& client) override;
    void stop() noexcept override;

private:
    void run(StylusClient& client) noexcept;
    bool exchange(StylusClient& client) noexcept;
    bool awaitAnswer(StylusClient& client) noexcept;
    bool readAnswer() noexcept;
    void watchForce(const glm::dvec3& sent) noexcept;
    StylusState stateOf(const ServiceState& said) noexcept;
    void tickWithoutReading(StylusClient& client) noexcept;
    void waitForService(StylusClient& client) noexcept;
    std::unique_ptr<ServiceConnection> look() noexcept;
    void use(std::unique_ptr<ServiceConnection> connection) noexcept;
    bool runs() const noexcept { return thread_.runs(); }

    std::string arm_;
    std::mutex emergency_;
    std::unique_ptr<ServiceConnection> connection_; ///< replaced by the device's thread, under the lock
    ForceMessage message_;
    ForceKey key_ = ForceKey::vector;
    ServiceState said_;
    bool hasGrip_ = false;
    glm::dvec3 middle_{0.0}; ///< m, service's frame: centre of the workspace
    int unheard_ = 0, changes_ = 0;
    double startedAt_ = 0.0, due_ = 0.0;
    bool unusableTold_ = false;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<double> battery_{-1.0};
    std::atomic<unsigned int> cuts_{0};
    std::atomic<bool> connected_{true}, ended_{true};
    DriverThread thread_;
};

} // namespace burin::haply
