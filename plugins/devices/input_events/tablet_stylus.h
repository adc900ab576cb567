// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/stylus.h"
#include "plugins/devices/input_events/event_port.h"
#include "plugins/devices/input_events/pen_mapping.h"
#include "plugins/devices/input_events/reopened_port.h"
#include "plugins/devices/polled/polling_thread.h"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin::input_events {

/// A pen on a tablet as a stylus without motors. read and write are called on the haptic thread and access no file;
/// open, close and takeFault on the owner's thread; health on any thread.
class TabletStylus final : public Stylus {
public:
    /// @param port an open tablet
    TabletStylus(ReopenedPort port, std::string name);
    ~TabletStylus() override { close(); }
    TabletStylus(const TabletStylus&) = delete;
    TabletStylus& operator=(const TabletStylus&) = delete;

    StylusDescription description() const override;
    /// Errors: argumentInvalid (already open), outOfMemory.
    Result<void> open() override;
    void close() noexcept override { thread_.stop(); }
    std::optional<Error> takeFault() override { return thread_.takeFault(); }
    DeviceHealth health() const noexcept override { return thread_.health(); }
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;
    std::vector<DeviceAxis> axes() const override { return penAxes(); }
    AxisMap axisMap() const override { return penMap(); }
    void assign(const AxisMap& map) noexcept override { maps_.post(map); }
    AxisReading axisReading() const noexcept override { return device_.newest(); }

private:
    /// The part that the polling thread uses.
    class Published final : public polled::PolledDevice {
    public:
        explicit Published(ReopenedPort port) : port_(std::move(port)), reader_(port_.device()) {}
        bool connect() noexcept override { return port_.connect(); }
        Heard receive(int milliseconds) noexcept override;
        void disconnect() noexcept override { port_.disconnect(); }
        void rest() noexcept override;
        const TabletReader& reader() const noexcept { return reader_; } ///< its constant properties; any thread
        /// Called on the haptic thread. Returns false if there was no report since the last call.
        bool take(Pen& pen) noexcept { return pens_.take(pen); }
        AxisReading newest() const noexcept; ///< any thread

    private:
        void publish() noexcept;

        ReopenedPort port_;
        TabletReader reader_;
        Mailbox<Pen> pens_;
        /// For any thread, value by value: one may be of the next report.
        std::array<std::atomic<double>, AxisMap::mostAxes> values_{};
        std::atomic<std::uint32_t> buttons_{0};
    };

    std::string name_;
    Published device_;
    polled::PollingThread thread_; ///< declared after the device that it reads

    Mailbox<AxisMap> maps_; ///< from the owner's thread to the haptic one

    AxisMap map_ = penMap(); ///< in use; this member and the following belong to the haptic thread
    PenMapping mapping_;
    Pen pen_;
    std::optional<double> readAt_;
};

} // namespace burin::input_events
