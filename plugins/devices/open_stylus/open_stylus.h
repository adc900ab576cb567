// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/driver_thread.h"
#include "core/device/stylus.h"
#include "plugins/devices/hid/hid_bus.h"
#include "plugins/devices/open_stylus/exchange.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace burin::openstylus {

/// Whether an interface uses the protocol, according to its descriptor.
bool speaksProtocol(const hid::DeviceInfo& device);

/// Queries the identity of the device on a port. Errors: deviceFault (no answer, a damaged answer, values out of
/// range), deviceIncompatible. Allocates; takes as long as the device.
Result<Identity> identify(hid::Port& port, const std::string& name);

/// A device of the open stylus protocol. Its thread waits for each input report, calls the client, and answers with an
/// output report: the device's own clock paces the loop. When the device is gone, it searches for the same device (same
/// id and identity) twice a second, and continues with it.
///
/// Threads as for SelfPacedStylus. Between two connections the device's thread allocates and locks (enumeration);
/// during a connection it does not, except for what hidapi does in a call that fails, which is the last one of a
/// connection.
class OpenStylus final : public SelfPacedStylus {
public:
    static constexpr int silentPeriods = 3;       ///< number of periods after which missing readings count as silence
    static constexpr double faultySilence = 0.05; ///< s after which silence is a fault
    static constexpr double lookEvery = 0.5;      ///< s, interval of the searches

    /// @param port already connected; @param id from idOf, used to find the device again
    OpenStylus(hid::Bus& bus, std::unique_ptr<hid::Port> port, const Identity& identity, std::string id,
               std::string name);
    ~OpenStylus() override { stop(); }
    OpenStylus(const OpenStylus&) = delete;
    OpenStylus& operator=(const OpenStylus&) = delete;

    StylusDescription description() const override { return descriptionOf(identity_, name_); }
    Result<void> open() override { return {}; } ///< connected since its construction
    void close() noexcept override { stop(); }
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    /// Sends "motors off" directly, through a port of its own, because the device's thread may be stuck in a tick or in
    /// its port. Waits until the device has accepted it, and takes a lock that is otherwise held only while the device
    /// is searched for.
    void cutMotors() noexcept override;
    /// Errors: argumentInvalid (already started), outOfMemory.
    Result<void> start(StylusClient& client) override;
    void stop() noexcept override;

private:
    void run(StylusClient& client) noexcept;
    bool exchangeOnce(StylusClient& client) noexcept;
    bool receive(double longest) noexcept;
    void tellSilence(StylusClient& client) noexcept;
    void waitForDevice(StylusClient& client) noexcept;
    void look() noexcept;
    void openEmergencyPort() noexcept;
    bool runs() const noexcept { return thread_.runs(); }

    hid::Bus& bus_;
    std::unique_ptr<hid::Port> port_; ///< belongs to the device's thread while it runs
    Identity identity_;
    std::mutex emergency_;
    std::unique_ptr<hid::Port> emergencyPort_; ///< guarded by emergency_; nothing is ever read from this port
    std::string id_, name_;
    Exchange exchange_;
    double silentAfter_;   ///< s without a reading after which the device counts as silent
    double heardAt_ = 0.0; ///< s, time of the newest reading or of the connection
    double toldAt_ = 0.0;  ///< s, time of the newest tick
    bool silenceTold_ = false;
    std::atomic<bool> connected_{true};
    DriverThread thread_;
};

} // namespace burin::openstylus
