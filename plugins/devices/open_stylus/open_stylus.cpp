// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/open_stylus.h"

#include "core/device/device_thread.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace burin::openstylus {
namespace {

constexpr double restSeconds = 0.001; // between ticks that only report silence
constexpr int farewells = 3;          // sent several times in case one is lost
constexpr std::size_t largestReport = 64;
constexpr int mostReports = 128; // read before the next tick; the kernel keeps 64

void rest(double seconds) noexcept {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

IdentityFault askIdentity(hid::Port& port, Identity& identity) noexcept {
    std::array<std::uint8_t, featureSize> report{featureId};
    const int size = port.feature(report);
    if (size < 0) return IdentityFault::foreign;
    return decodeFeature(Bytes(report).first(std::min(static_cast<std::size_t>(size), featureSize)), identity);
}

} // namespace

bool speaksProtocol(const hid::DeviceInfo& device) {
    return device.usagePage == usagePage && device.usage == usage;
}

Result<Identity> identify(hid::Port& port, const std::string& name) {
    Identity identity;
    switch (askIdentity(port, identity)) {
    case IdentityFault::none:
        return identity;
    case IdentityFault::otherVersion:
        return Error{ErrorCode::deviceIncompatible, name, std::to_string(identity.major),
                     std::to_string(protocolMajor)};
    case IdentityFault::foreign:
        return Error{ErrorCode::deviceFault, name, {}, BURIN_TEXT("DeviceReason", "it does not identify itself").text};
    case IdentityFault::damaged:
        break;
    case IdentityFault::outOfRange:
        return Error{ErrorCode::deviceFault, name, {}, BURIN_TEXT("DeviceReason", "its limits are out of range").text};
    }
    return errorOf(DeviceFault::damaged, name);
}

OpenStylus::OpenStylus(hid::Bus& bus, std::unique_ptr<hid::Port> port, const Identity& identity, std::string id,
                       std::string name)
    : bus_(bus)
    , port_(std::move(port))
    , identity_(identity)
    , id_(std::move(id))
    , name_(std::move(name))
    , exchange_(identity)
    , silentAfter_(std::max(silentPeriods / identity.rate, 0.003)) {}

std::optional<Error> OpenStylus::takeFault() {
    const std::optional<DeviceFault> fault = exchange_.faults().take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, name_);
}

DeviceHealth OpenStylus::health() const noexcept {
    DeviceHealth health = exchange_.health();
    health.connected = connected_.load(std::memory_order_relaxed);
    return health;
}

Result<void> OpenStylus::start(StylusClient& client) {
    if (!thread_.started()) openEmergencyPort();
    return thread_.start(name_, [this, &client] { run(client); });
}

void OpenStylus::stop() noexcept {
    thread_.stop();
}

void OpenStylus::run(StylusClient& client) noexcept {
    blockSignals();
    client.begins();
    exchange_.begin();
    heardAt_ = toldAt_ = steadySeconds();
    silenceTold_ = false;
    while (runs()) {
        if (port_ != nullptr && exchangeOnce(client)) continue;
        if (!runs()) break;
        waitForDevice(client);
    }
    if (port_ != nullptr)
        for (int i = 0; i < farewells; ++i) port_->write(exchange_.farewell(steadySeconds()));
    client.ends();
}

/// Handles one reading and its answer, or reports silence. Returns false if the device is gone.
bool OpenStylus::exchangeOnce(StylusClient& client) noexcept {
    const double waited = steadySeconds() - heardAt_;
    if (!receive(waited < silentAfter_ ? silentAfter_ - waited : restSeconds)) return false;
    if (toldAt_ < heardAt_) { // a reading was received since the last tick
        toldAt_ = heardAt_;
        silenceTold_ = false;
        const bool taken = port_->write(exchange_.answer(client.tick(exchange_.state()), steadySeconds()));
        client.answered();
        return taken;
    }
    if (steadySeconds() - heardAt_ >= silentAfter_) tellSilence(client);
    return true;
}

/// Waits for a reading, then takes the newest of the available ones. Returns false if the device is gone.
bool OpenStylus::receive(double longest) noexcept {
    std::array<std::uint8_t, largestReport> report;
    int milliseconds = std::max(1, static_cast<int>(std::ceil(longest * 1e3)));
    bool heard = false;
    for (int i = 0; i < mostReports; ++i) {
        const int size = port_->read(report, milliseconds);
        if (size < 0) return false;
        if (size == 0) return true;
        const double at = steadySeconds();
        if (exchange_.take(Bytes(report).first(static_cast<std::size_t>(size)), at) == Exchange::Outcome::reading) {
            if (heard) exchange_.overtaken();
            heard = true;
            heardAt_ = at;
        }
        milliseconds = 0;
    }
    return true;
}

void OpenStylus::tellSilence(StylusClient& client) noexcept {
    const double at = steadySeconds();
    if (at - toldAt_ < restSeconds) return;
    (void)client.tick(exchange_.silence(at - toldAt_));
    client.answered();
    toldAt_ = at;
    if (connected_.load(std::memory_order_relaxed) && !silenceTold_ && at - heardAt_ > faultySilence) {
        silenceTold_ = true;
        exchange_.faults().raise(DeviceFault::silent);
    }
}

/// The device is gone: reports it, searches for it, and keeps the client's guards running in the meantime.
void OpenStylus::waitForDevice(StylusClient& client) noexcept {
    if (connected_.exchange(false, std::memory_order_relaxed)) exchange_.faults().raise(DeviceFault::unplugged);
    port_.reset();
    double lookedAt = 0.0;
    while (runs() && port_ == nullptr) {
        tellSilence(client);
        if (steadySeconds() - lookedAt >= lookEvery) {
            look();
            lookedAt = steadySeconds();
        }
        if (port_ == nullptr) rest(restSeconds);
    }
    if (port_ == nullptr) return;
    exchange_.restart();
    heardAt_ = toldAt_ = steadySeconds();
    silenceTold_ = false;
    connected_.store(true, std::memory_order_relaxed);
}

void OpenStylus::openEmergencyPort() noexcept {
    std::unique_ptr<hid::Port> port = hid::openAgain(bus_, speaksProtocol, id_);
    const std::lock_guard lock(emergency_);
    emergencyPort_ = std::move(port);
}

void OpenStylus::cutMotors() noexcept {
    exchange_.cut();
    const std::lock_guard lock(emergency_);
    if (emergencyPort_ == nullptr) return; // unplugged
    for (int i = 0; i < farewells; ++i) emergencyPort_->write(exchange_.emergency(i));
}

/// Another device, or one whose limits have changed, is not used: the session was prepared for this device.
void OpenStylus::look() noexcept {
    std::unique_ptr<hid::Port> port = hid::openAgain(bus_, speaksProtocol, id_);
    if (port == nullptr) return;
    Identity identity;
    if (askIdentity(*port, identity) != IdentityFault::none || !(identity == identity_)) return;
    port_ = std::move(port);
    openEmergencyPort();
}

} // namespace burin::openstylus
