// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "plugins/devices/hid/hid_bus.h"
#include "plugins/devices/spacemouse/cap_mapping.h"
#include "plugins/devices/spacemouse/reports.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace burin::spacemouse {

/// Whether an interface is a 3D mouse's.
bool isSpaceMouse(const hid::DeviceInfo& device);

/// Hands plain values from the device's thread to any other by one atomic word each: a reader may see the axes of one
/// report and the buttons of the next, which are different reports anyway.
class SharedControls {
public:
    void publish(const Controls& controls) noexcept; ///< the device's thread
    void heardMotion() noexcept { motions_.fetch_add(1, std::memory_order_release); }
    std::array<std::int16_t, 6> axes() const noexcept;
    std::uint32_t buttons() const noexcept { return buttons_.load(std::memory_order_relaxed); }
    std::uint64_t motions() const noexcept { return motions_.load(std::memory_order_acquire); }
    int batteryPercent() const noexcept { return battery_.load(std::memory_order_relaxed); }
    bool charging() const noexcept { return charging_.load(std::memory_order_relaxed); }

private:
    std::atomic<std::uint64_t> translation_{0}, rotation_{0}; ///< three axes of 16 bits each
    std::atomic<std::uint64_t> motions_{0};
    std::atomic<std::uint32_t> buttons_{0};
    std::atomic<int> battery_{-1};
    std::atomic<bool> charging_{false};
};

/// A 3D mouse as a stylus without motors: the loop calls it. A thread of its own reads the reports, lights the LED
/// while it is open, and finds the device again after it was unplugged. Thread: read and write the loop's, which touch
/// no file; open, close, takeFault the owner's; health any.
class SpaceMouse final : public Stylus {
public:
    /// s without a report of motion; from then on the cap is at rest. A held cap reports 60 times a second and more;
    /// one that was let go reports zero, unless the report is lost.
    static constexpr double staleAfter = 0.1;
    static constexpr double lookEvery = 0.5; ///< s

    SpaceMouse(hid::Bus& bus, std::unique_ptr<hid::Port> port, std::string id, std::string name, int buttons,
               ControlMode mode);
    ~SpaceMouse() override { close(); }
    SpaceMouse(const SpaceMouse&) = delete;
    SpaceMouse& operator=(const SpaceMouse&) = delete;

    StylusDescription description() const override;
    /// Errors: argumentInvalid (it is open), outOfMemory.
    Result<void> open() override;
    void close() noexcept override;
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;

private:
    void run() noexcept;
    void receive() noexcept;
    void lose() noexcept;
    bool runs() const noexcept { return !stop_.load(std::memory_order_relaxed); }

    hid::Bus& bus_;
    std::unique_ptr<hid::Port> port_; ///< the device's thread while it runs
    std::string id_, name_;
    int buttons_;
    ReportReader reader_; ///< the device's thread
    SharedControls shared_;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<bool> connected_{true}, stop_{false};
    std::thread thread_;

    CapMapping mapping_; ///< from here on the loop's
    std::optional<double> readAt_;
    double movedAt_ = 0.0;
    std::uint64_t motions_ = 0;
};

} // namespace burin::spacemouse
