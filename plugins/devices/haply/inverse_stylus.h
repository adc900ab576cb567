// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "plugins/devices/haply/messages.h"
#include "plugins/devices/haply/service.h"
#include "plugins/devices/haply/state_scanner.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace burin::haply {

/// An Inverse3, with a VerseGrip where there is one, through Haply's service. Its thread keeps the time: a thousand
/// times a second it sends a force and gets the state that follows; the service lets the arm go idle when nobody sends.
/// Where the arm was when it was connected is the middle of its workspace.
///
/// A message that is late makes readings invalid, a broken connection is made again twice a second. Which of the two
/// names for a force the service knows is found out by what the arm renders. Thread: as SelfPacedStylus says.
class InverseStylus final : public SelfPacedStylus {
public:
    static constexpr double period = 0.001;     ///< s
    static constexpr double lateAfter = 0.003;  ///< s without an answer, from which on readings are not valid
    static constexpr double faultyAfter = 0.05; ///< s; from then on it is a fault
    static constexpr double brokenAfter = 1.0;  ///< s; from then on it is connected again
    static constexpr double lookEvery = 0.5;    ///< s
    static constexpr int answersUntilDeaf = 20; ///< in which a force that was asked for is not rendered
    static constexpr double stopWithin = 0.2;   ///< s that the thread has to end by itself

    /// Connects to an arm. Errors: deviceNotFound (no service, no such arm).
    static Result<std::unique_ptr<SelfPacedStylus>> connect(const std::string& arm);
    /// @param connection whose first message was read @param first what it said
    InverseStylus(std::string arm, std::unique_ptr<ServiceConnection> connection, const ServiceState& first);
    ~InverseStylus() override { stop(); }
    InverseStylus(const InverseStylus&) = delete;
    InverseStylus& operator=(const InverseStylus&) = delete;

    StylusDescription description() const override;
    Result<void> open() override { return {}; } ///< it is connected since it was made
    void close() noexcept override { stop(); }
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    /// Breaks the connection: the arm goes idle, and is connected again.
    void cutMotors() noexcept override;
    /// Errors: argumentInvalid (it was started already), outOfMemory.
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
    bool runs() const noexcept { return !stop_.load(std::memory_order_relaxed); }

    std::string arm_;
    std::mutex emergency_;
    std::unique_ptr<ServiceConnection> connection_; ///< replaced under the lock, by the device's thread
    ForceMessage message_;
    ForceKey key_ = ForceKey::vector;
    ServiceState said_;
    bool hasGrip_ = false;
    glm::dvec3 middle_{0.0}; ///< m, service's frame
    int unheard_ = 0, changes_ = 0;
    double startedAt_ = 0.0, due_ = 0.0;
    bool unusableTold_ = false;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<double> battery_{-1.0};
    std::atomic<unsigned int> cuts_{0};
    std::atomic<bool> connected_{true}, stop_{false}, ended_{true};
    std::thread thread_;
};

} // namespace burin::haply
