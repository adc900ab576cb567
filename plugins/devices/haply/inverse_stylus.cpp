// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/inverse_stylus.h"

#include "core/base/units.h"
#include "core/device/device_thread.h"
#include "plugins/devices/haply/inventory.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace burin::haply {
namespace {

constexpr double askedForce = 0.05;     // N: a smaller force may be below what the motors can render
constexpr double renderedForce = 0.005; // N
constexpr int buttons = 3;
constexpr const char* tutorial = BURIN_TEXT("Device", "Haply's tutorial").text;
constexpr const char* careful = BURIN_TEXT("Device", "conservative estimate").text;

void sleepUntil(double time) noexcept {
    const double rest = time - steadySeconds();
    if (rest > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(rest));
}

bool isNumber(const glm::dquat& turn) noexcept {
    const double square = glm::dot(turn, turn);
    return std::isfinite(square) && square > 0.5 && square < 2.0;
}

} // namespace

Result<std::unique_ptr<SelfPacedStylus>> InverseStylus::connect(const std::string& arm) {
    std::unique_ptr<ServiceConnection> connection = ServiceConnection::open(serviceAddress());
    const std::string_view first = connection != nullptr ? connection->first() : std::string_view();
    const std::vector<std::string> arms = armsOf(first);
    const std::optional<ServiceState> said = scanState(first, arm);
    if (std::ranges::find(arms, arm) == arms.end() || !said) return Error{ErrorCode::deviceNotFound, arm, {}, {}};
    return std::unique_ptr<SelfPacedStylus>(std::make_unique<InverseStylus>(arm, std::move(connection), *said));
}

InverseStylus::InverseStylus(std::string arm, std::unique_ptr<ServiceConnection> connection, const ServiceState& first)
    : arm_(std::move(arm))
    , connection_(std::move(connection))
    , message_(arm_)
    , said_(first)
    , hasGrip_(first.grip.has_value()) {
    if (first.cursor && isFinite(*first.cursor)) middle_ = *first.cursor;
}

StylusDescription InverseStylus::description() const {
    StylusDescription stylus;
    stylus.name = "Haply Inverse3 " + arm_;
    stylus.sensed = {3, hasGrip_ ? 3 : 0};
    stylus.actuated = {3, 0};
    stylus.buttons = hasGrip_ ? buttons : 0;
    stylus.rate = {1.0 / period, BURIN_TEXT("Device", "set by Burin").text};
    stylus.delay = {period, BURIN_TEXT("Device", "one message of the service").text};
    stylus.maximumForce = {4.0, careful};
    stylus.maximumStiffness = {800.0, tutorial};
    stylus.maximumDamping = {3.0, tutorial};
    stylus.workspaceRadius = {75.0, careful};
    stylus.carriesHandle = true; // by the service's own gravity compensation
    return stylus;
}

std::optional<Error> InverseStylus::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, "Haply Inverse3 " + arm_);
}

DeviceHealth InverseStylus::health() const noexcept {
    DeviceHealth health;
    health.connected = connected_.load(std::memory_order_relaxed);
    health.readings = readings_.load(std::memory_order_relaxed);
    if (const double battery = battery_.load(std::memory_order_relaxed); battery >= 0.0) health.batteryShare = battery;
    return health;
}

void InverseStylus::cutMotors() noexcept {
    cuts_.fetch_add(1, std::memory_order_acq_rel);
    const std::lock_guard lock(emergency_);
    if (connection_ != nullptr) connection_->cut();
}

Result<void> InverseStylus::start(StylusClient& client) {
    if (!thread_.started()) ended_ = false;
    return thread_.start(arm_, [this, &client] { run(client); });
}

void InverseStylus::stop() noexcept {
    if (!thread_.started()) return;
    thread_.end();
    const double until = steadySeconds() + stopWithin;
    while (!ended_.load(std::memory_order_acquire) && steadySeconds() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!ended_.load(std::memory_order_acquire)) cutMotors(); // the thread waits for the service
    thread_.stop();
}

void InverseStylus::run(StylusClient& client) noexcept {
    blockSignals();
    client.begins();
    startedAt_ = due_ = steadySeconds();
    while (runs()) {
        if (connection_ != nullptr && exchange(client)) continue;
        if (runs()) waitForService(client);
    }
    if (connection_ != nullptr) (void)connection_->write(message_.write(glm::dvec3(0.0), key_));
    client.ends();
    ended_.store(true, std::memory_order_release);
}

/// One tick: sends its force and receives the service's answer. Returns false if the connection is broken.
bool InverseStylus::exchange(StylusClient& client) noexcept {
    due_ = std::max(due_ + period, steadySeconds());
    sleepUntil(due_);
    const unsigned int cutsBefore = cuts_.load(std::memory_order_acquire);
    const StylusState state = stateOf(said_);
    const Wrench wrench = client.tick(state);
    const bool rendered = state.valid && cuts_.load(std::memory_order_acquire) == cutsBefore;
    const glm::dvec3 force = rendered ? wrench.force : glm::dvec3(0.0);
    const bool sent = connection_->write(message_.write(force, key_));
    client.answered();
    if (!sent || !awaitAnswer(client) || !readAnswer()) return false;
    watchForce(force);
    return true;
}

/// Waits for an answer. Returns false if none arrives any more.
bool InverseStylus::awaitAnswer(StylusClient& client) noexcept {
    constexpr int milliseconds = static_cast<int>(lateAfter * 1e3);
    if (connection_->waits(milliseconds)) return true;
    const double since = steadySeconds() - lateAfter;
    bool told = false;
    while (runs() && steadySeconds() - since < brokenAfter) {
        tickWithoutReading(client);
        if (!told && steadySeconds() - since > faultyAfter) {
            told = true;
            faults_.raise(DeviceFault::silent);
        }
        if (connection_->waits(1)) return true;
    }
    return false;
}

bool InverseStylus::readAnswer() noexcept {
    const std::string_view message = connection_->read();
    if (message.empty()) return false;
    const std::optional<ServiceState> said = scanState(message, arm_);
    if (said)
        said_ = *said;
    else
        faults_.raise(DeviceFault::damaged);
    if (!said) said_.cursor.reset(); // no reading in this case
    if (said_.batteryShare) battery_.store(*said_.batteryShare, std::memory_order_relaxed);
    return true;
}

/// If the arm does not render a force, this version of the service does not know the name used for it.
void InverseStylus::watchForce(const glm::dvec3& sent) noexcept {
    const bool unheard = glm::length(sent) > askedForce && said_.force && glm::length(*said_.force) < renderedForce;
    unheard_ = unheard ? unheard_ + 1 : 0;
    if (unheard_ < answersUntilDeaf) return;
    unheard_ = 0;
    key_ = key_ == ForceKey::vector ? ForceKey::values : ForceKey::vector;
    if (++changes_ == 2) faults_.raise(DeviceFault::deaf); // it knows neither name
}

StylusState InverseStylus::stateOf(const ServiceState& said) noexcept {
    StylusState state;
    state.time = steadySeconds() - startedAt_;
    const bool usable = said.calibrated && said.ready;
    if (!usable && !unusableTold_) faults_.raise(DeviceFault::notCalibrated);
    unusableTold_ = !usable;
    if (!usable || !said.cursor || !isFinite(*said.cursor)) return state;
    state.pose.position = (*said.cursor - middle_) * millimetresPerMetre;
    if (hasGrip_) {
        if (!said.grip || !isNumber(*said.grip)) return state;
        state.pose.rotation = glm::normalize(*said.grip);
        state.buttons = said.buttons;
    }
    state.valid = true;
    readings_.fetch_add(1, std::memory_order_relaxed);
    return state;
}

void InverseStylus::tickWithoutReading(StylusClient& client) noexcept {
    StylusState state;
    state.time = steadySeconds() - startedAt_;
    (void)client.tick(state);
    client.answered();
}

/// The connection is broken: reports it, reconnects, and keeps the client's guards running in the meantime.
void InverseStylus::waitForService(StylusClient& client) noexcept {
    if (connected_.exchange(false, std::memory_order_relaxed)) faults_.raise(DeviceFault::unplugged);
    use(nullptr);
    double lookedAt = steadySeconds();
    while (runs() && connection_ == nullptr) {
        tickWithoutReading(client);
        if (steadySeconds() - lookedAt >= lookEvery) {
            use(look());
            lookedAt = steadySeconds();
        }
        if (connection_ == nullptr) sleepUntil(steadySeconds() + period);
    }
    if (connection_ == nullptr) return;
    unheard_ = changes_ = 0;
    connected_.store(true, std::memory_order_relaxed);
}

std::unique_ptr<ServiceConnection> InverseStylus::look() noexcept {
    try {
        std::unique_ptr<ServiceConnection> connection = ServiceConnection::open(serviceAddress());
        if (connection == nullptr) return nullptr;
        const std::optional<ServiceState> said = scanState(connection->first(), arm_);
        if (!said || !said->cursor || said->grip.has_value() != hasGrip_) return nullptr;
        said_ = *said;
        return connection;
    } catch (const std::exception&) { // out of memory, or a name that can't be resolved: retried at the next attempt
        return nullptr;
    }
}

void InverseStylus::use(std::unique_ptr<ServiceConnection> connection) noexcept {
    const std::lock_guard lock(emergency_);
    connection_ = std::move(connection);
}

} // namespace burin::haply
