// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/space_mouse.h"

#include "plugins/devices/spacemouse/models.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <system_error>

namespace burin::spacemouse {
namespace {

constexpr int waitMilliseconds = 20; // so long `close` may have to wait
constexpr std::size_t largestReport = 64;
constexpr double percent = 0.01;

std::uint64_t packed(const std::array<std::int16_t, 6>& axes, std::size_t first) noexcept {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 3; ++i)
        word |= static_cast<std::uint64_t>(static_cast<std::uint16_t>(axes[first + i])) << (16 * i);
    return word;
}

void unpack(std::uint64_t word, std::array<std::int16_t, 6>& axes, std::size_t first) noexcept {
    for (std::size_t i = 0; i < 3; ++i)
        axes[first + i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(word >> (16 * i) & 0xffffU));
}

} // namespace

bool isSpaceMouse(const hid::DeviceInfo& device) {
    return isSpaceMouse(device.vendor, device.product, device.usagePage, device.usage);
}

void SharedControls::publish(const Controls& controls) noexcept {
    translation_.store(packed(controls.axes, 0), std::memory_order_relaxed);
    rotation_.store(packed(controls.axes, 3), std::memory_order_relaxed);
    buttons_.store(controls.buttons, std::memory_order_relaxed);
    battery_.store(controls.batteryPercent, std::memory_order_relaxed);
    charging_.store(controls.charging, std::memory_order_relaxed);
}

std::array<std::int16_t, 6> SharedControls::axes() const noexcept {
    std::array<std::int16_t, 6> axes{};
    unpack(translation_.load(std::memory_order_relaxed), axes, 0);
    unpack(rotation_.load(std::memory_order_relaxed), axes, 3);
    return axes;
}

SpaceMouse::SpaceMouse(hid::Bus& bus, std::unique_ptr<hid::Port> port, std::string id, std::string name, int buttons,
                       ControlMode mode)
    : bus_(bus)
    , port_(std::move(port))
    , id_(std::move(id))
    , name_(std::move(name))
    , buttons_(buttons)
    , mapping_(mode) {}

StylusDescription SpaceMouse::description() const {
    const std::string mapping = "Burin's mapping of the cap";
    StylusDescription description;
    description.name = name_;
    description.buttons = buttons_;
    description.workspaceRadius = {CapMapping::workspaceRadius, mapping};
    description.rate = {62.5, "recordings of SpaceNavigator and SpaceMouse Wireless: full sets of axes a second"};
    description.maximumSpeed = {2.0 * CapMapping::followSpeed, mapping};
    return description;
}

Result<void> SpaceMouse::open() {
    if (thread_.joinable()) return Error{ErrorCode::argumentInvalid, "stylus", "open", "a stylus that is closed"};
    stop_.store(false, std::memory_order_relaxed);
    mapping_.reset();
    readAt_.reset();
    motions_ = shared_.motions();
    movedAt_ = -2.0 * staleAfter;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory, name_, {}, "no thread"};
    }
    return {};
}

void SpaceMouse::close() noexcept {
    if (!thread_.joinable()) return;
    stop_.store(true, std::memory_order_relaxed);
    thread_.join();
}

std::optional<Error> SpaceMouse::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, name_);
}

DeviceHealth SpaceMouse::health() const noexcept {
    DeviceHealth health;
    health.connected = connected_.load(std::memory_order_relaxed);
    health.readings = readings_.load(std::memory_order_relaxed);
    if (const int battery = shared_.batteryPercent(); battery >= 0) health.batteryShare = percent * battery;
    health.charging = shared_.charging();
    return health;
}

StylusState SpaceMouse::read(double time) noexcept {
    if (const std::uint64_t motions = shared_.motions(); motions != motions_) {
        motions_ = motions;
        movedAt_ = time;
    }
    const bool stale = time - movedAt_ > staleAfter;
    const double elapsed = readAt_ ? std::max(0.0, time - *readAt_) : 0.0;
    readAt_ = time;
    StylusState state;
    state.time = time;
    state.pose = mapping_.advance(stale ? std::array<std::int16_t, 6>{} : shared_.axes(), elapsed);
    state.buttons = shared_.buttons();
    state.valid = connected_.load(std::memory_order_relaxed);
    return state;
}

void SpaceMouse::write(const Wrench& /*wrench*/) noexcept {}

void SpaceMouse::run() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr); // they are the other threads'
    if (port_ != nullptr) port_->write(ledReport(true));
    while (runs()) {
        if (port_ != nullptr) {
            receive();
            continue;
        }
        port_ = hid::openAgain(
            bus_, [](const hid::DeviceInfo& device) { return isSpaceMouse(device); }, id_);
        if (port_ != nullptr) {
            port_->write(ledReport(true));
            connected_.store(true, std::memory_order_relaxed);
            continue;
        }
        const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(lookEvery);
        while (runs() && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(std::chrono::milliseconds(waitMilliseconds));
    }
    if (port_ != nullptr) port_->write(ledReport(false));
}

void SpaceMouse::receive() noexcept {
    std::array<std::uint8_t, largestReport> report;
    const int size = port_->read(report, waitMilliseconds);
    if (size < 0) return lose();
    if (size == 0) return;
    const ReportKind kind = reader_.take(Bytes(report).first(static_cast<std::size_t>(size)));
    if (kind == ReportKind::unknown) return;
    readings_.fetch_add(1, std::memory_order_relaxed);
    shared_.publish(reader_.controls());
    if (kind == ReportKind::translation || kind == ReportKind::rotation || kind == ReportKind::motion)
        shared_.heardMotion();
}

void SpaceMouse::lose() noexcept {
    port_.reset();
    reader_.rest();
    shared_.publish(reader_.controls());
    connected_.store(false, std::memory_order_relaxed);
    faults_.raise(DeviceFault::unplugged);
}

} // namespace burin::spacemouse
