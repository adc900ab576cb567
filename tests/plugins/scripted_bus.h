// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/hid/hid_bus.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace burin::test {

/// The two ends of a plugged-in device: the port, and the test that simulates the device. Thread-safe.
class Wire {
public:
    using Report = std::vector<std::uint8_t>;

    /// Sends a report from the device. Like the kernel, keeps 64 reports and drops newer ones.
    bool send(const Report& report) {
        const std::lock_guard lock(mutex_);
        if (reports_.size() >= 64) return false;
        reports_.push_back(report);
        arrived_.notify_all();
        return true;
    }
    /// Sets a handler for what the host sends, called on the host's thread.
    void onOutput(std::function<void(const Report&)> heard) {
        const std::lock_guard lock(hearing_);
        heard_ = std::move(heard);
    }
    /// The reports that the host sent, oldest first.
    std::vector<Report> takeOutputs() {
        const std::lock_guard lock(mutex_);
        return std::exchange(outputs_, {});
    }
    void unplug() {
        const std::lock_guard lock(mutex_);
        plugged_ = false;
        arrived_.notify_all();
    }
    /// Also removes the handler.
    void cut() {
        unplug();
        onOutput({});
    }

    int read(std::span<std::uint8_t> bytes, int milliseconds) {
        std::unique_lock lock(mutex_);
        arrived_.wait_for(lock, std::chrono::milliseconds(milliseconds),
                          [this] { return !plugged_ || !reports_.empty(); });
        if (!plugged_) return -1;
        if (reports_.empty()) return 0;
        const Report report = std::move(reports_.front());
        reports_.pop_front();
        const std::size_t size = std::min(report.size(), bytes.size());
        std::copy_n(report.begin(), size, bytes.begin());
        return static_cast<int>(size);
    }
    bool write(std::span<const std::uint8_t> bytes) {
        const Report report(bytes.begin(), bytes.end());
        {
            const std::lock_guard lock(mutex_);
            if (!plugged_) return false;
            outputs_.push_back(report);
        }
        const std::lock_guard lock(hearing_);
        if (heard_) heard_(report);
        return true;
    }

private:
    std::mutex mutex_, hearing_;
    std::function<void(const Report&)> heard_;
    std::condition_variable arrived_;
    std::deque<Report> reports_;
    std::vector<Report> outputs_;
    bool plugged_ = true;
};

/// A bus on which a test plugs and unplugs devices. Thread-safe.
class ScriptedBus final : public hid::Bus {
public:
    using Feature = std::function<std::vector<std::uint8_t>()>;

    /// @param feature  the answer to GET_REPORT, if the device has one
    std::shared_ptr<Wire> plug(hid::DeviceInfo device, Feature feature = {}) {
        const std::lock_guard lock(mutex_);
        device.path = "wire" + std::to_string(++plugs_);
        devices_.push_back({std::move(device), std::make_shared<Wire>(), std::move(feature)});
        return devices_.back().wire;
    }
    void unplugAll() {
        const std::lock_guard lock(mutex_);
        for (const Plugged& device : devices_) device.wire->unplug();
        devices_.clear();
    }
    /// From now on opening a device fails.
    void forbid() { forbidden_ = true; }

    std::vector<hid::DeviceInfo> list() override {
        const std::lock_guard lock(mutex_);
        std::vector<hid::DeviceInfo> devices;
        for (const Plugged& device : devices_) devices.push_back(device.info);
        return devices;
    }
    Result<std::unique_ptr<hid::Port>> open(const hid::DeviceInfo& wanted) override {
        const std::lock_guard lock(mutex_);
        if (forbidden_) return Error{ErrorCode::deviceNotAllowed, wanted.name, wanted.path, {}};
        for (const Plugged& device : devices_)
            if (device.info.path == wanted.path)
                return std::unique_ptr<hid::Port>(std::make_unique<WirePort>(device.wire, device.feature));
        return Error{ErrorCode::deviceNotFound, wanted.name, {}, {}};
    }

private:
    class WirePort final : public hid::Port {
    public:
        WirePort(std::shared_ptr<Wire> wire, Feature feature) : wire_(std::move(wire)), feature_(std::move(feature)) {}
        int read(std::span<std::uint8_t> bytes, int milliseconds) noexcept override {
            return wire_->read(bytes, milliseconds);
        }
        bool write(std::span<const std::uint8_t> report) noexcept override { return wire_->write(report); }
        int feature(std::span<std::uint8_t> bytes) noexcept override {
            if (!feature_) return -1;
            const auto answer = feature_();
            const std::size_t size = std::min(answer.size(), bytes.size());
            std::copy_n(answer.begin(), size, bytes.begin());
            return static_cast<int>(size);
        }

    private:
        std::shared_ptr<Wire> wire_;
        Feature feature_;
    };
    struct Plugged {
        hid::DeviceInfo info;
        std::shared_ptr<Wire> wire;
        Feature feature;
    };

    std::mutex mutex_;
    std::vector<Plugged> devices_;
    int plugs_ = 0;
    std::atomic<bool> forbidden_{false};
};

} // namespace burin::test
