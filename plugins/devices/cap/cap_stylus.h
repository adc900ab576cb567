// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/stylus.h"
#include "plugins/devices/cap/cap_mapping.h"
#include "plugins/devices/cap/controls.h"
#include "plugins/devices/polled/polling_thread.h"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin::cap {

/// Reads a device with a cap. All calls come from one thread, that of the stylus.
class ControlSource {
public:
    enum class Heard : std::uint8_t { nothing, motion, other, gone };
    virtual ~ControlSource() = default;
    /// Searches for the device and opens it. Returns true if it is open, also if it was open before.
    virtual bool connect() noexcept = 0;
    /// Waits for an event, up to a time limit. @param[out] controls the complete state, if something was received
    virtual Heard receive(Controls& controls, int milliseconds) noexcept = 0;
    /// May also be called when it is not connected.
    virtual void disconnect() noexcept = 0;
};

/// Passes plain values from the device's thread to any other one by one atomic word each: a reader may see the axes of
/// one report together with the buttons of the next, which arrive in different reports anyway.
class SharedControls {
public:
    void publish(const Controls& controls) noexcept; ///< called on the device's thread
    void heardMotion() noexcept { motions_.fetch_add(1, std::memory_order_release); }
    std::array<std::int16_t, AxisMap::mostAxes> axes() const noexcept;
    std::uint32_t silent() const noexcept { return silent_.load(std::memory_order_relaxed); }
    std::uint32_t buttons() const noexcept { return buttons_.load(std::memory_order_relaxed); }
    std::uint64_t motions() const noexcept { return motions_.load(std::memory_order_acquire); }
    int batteryPercent() const noexcept { return battery_.load(std::memory_order_relaxed); }
    bool charging() const noexcept { return charging_.load(std::memory_order_relaxed); }

private:
    /// The axes, four in each word: those of a word are of the same reading.
    using AxisWords = std::array<std::uint64_t, AxisMap::mostAxes / 4>;
    std::array<std::atomic<std::uint64_t>, std::tuple_size_v<AxisWords>> axes_{};
    std::atomic<std::uint64_t> motions_{0};
    std::atomic<std::uint32_t> silent_{0}, buttons_{0};
    std::atomic<int> battery_{-1};
    std::atomic<bool> charging_{false};
};

/// Description of a stylus based on a cap, and how it interprets what it receives.
struct CapStylusSettings {
    std::string name;
    int buttons = 0;
    Figure<"Hz"> rate;
    /// s without motion after which the cap counts as at rest; 0: the device always reports rest
    double staleAfter = 0.0;
    ControlMode mode = ControlMode::rate;
    std::vector<DeviceAxis> axes = capAxes(); ///< in the order of Controls::axes
    AxisMap map = capMap();
    double fullScale = CapMapping::fullScale; ///< counts at full deflection
    std::uint32_t silent = 0;                 ///< axes that report nothing before they move, one bit each
};

/// A cap as a stylus without motors, called by the loop. A thread of its own reads the device, and finds it again after
/// it was unplugged. read and write are called on the haptic thread and access no file; open, close and takeFault on
/// the owner's thread; health on any thread.
class CapStylus final : public Stylus {
public:
    CapStylus(std::unique_ptr<ControlSource> source, CapStylusSettings settings);
    ~CapStylus() override { close(); }
    CapStylus(const CapStylus&) = delete;
    CapStylus& operator=(const CapStylus&) = delete;

    StylusDescription description() const override;
    /// Errors: argumentInvalid (already open), outOfMemory.
    Result<void> open() override;
    void close() noexcept override { thread_.stop(); }
    std::optional<Error> takeFault() override { return thread_.takeFault(); }
    DeviceHealth health() const noexcept override;
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;
    std::vector<DeviceAxis> axes() const override { return settings_.axes; }
    AxisMap axisMap() const override { return settings_.map; }
    void assign(const AxisMap& map) noexcept override { maps_.post(map); }
    AxisReading axisReading() const noexcept override;

private:
    /// The part that the polling thread uses.
    class Published final : public polled::PolledDevice {
    public:
        /// @param settings outlive it
        Published(std::unique_ptr<ControlSource> source, const CapStylusSettings& settings);
        bool connect() noexcept override { return source_->connect(); }
        Heard receive(int milliseconds) noexcept override;
        void disconnect() noexcept override { source_->disconnect(); }
        void rest() noexcept override;
        const SharedControls& shared() const noexcept { return shared_; }

    private:
        std::unique_ptr<ControlSource> source_;
        const CapStylusSettings& settings_;
        Controls controls_;
        SharedControls shared_;
    };

    std::array<double, AxisMap::mostAxes> readings() const noexcept; ///< as shares; haptic thread

    CapStylusSettings settings_;
    Published device_;
    polled::PollingThread thread_; ///< declared after the device that it reads

    Mailbox<AxisMap> maps_; ///< from the owner's thread to the haptic one

    AxisMap map_; ///< in use; this member and the following belong to the haptic thread
    CapMapping mapping_;
    std::optional<double> readAt_;
    double movedAt_ = 0.0;
    std::uint64_t motions_ = 0;
};

} // namespace burin::cap
