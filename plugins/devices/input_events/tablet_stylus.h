// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/stylus.h"
#include "plugins/devices/input_events/event_port.h"
#include "plugins/devices/input_events/pen_mapping.h"
#include "plugins/devices/input_events/reopened_port.h"
#include "plugins/devices/polled/polling_thread.h"

#include <memory>
#include <optional>
#include <string>

namespace burin::input_events {

/// A pen on a tablet as a stylus without motors. Thread: read and write the loop's, which touch no file; open, close,
/// takeFault the owner's; health any.
class TabletStylus final : public Stylus {
public:
    /// @param port an open tablet
    TabletStylus(ReopenedPort port, std::string name);
    ~TabletStylus() override { close(); }
    TabletStylus(const TabletStylus&) = delete;
    TabletStylus& operator=(const TabletStylus&) = delete;

    StylusDescription description() const override;
    /// Errors: argumentInvalid (it is open), outOfMemory.
    Result<void> open() override;
    void close() noexcept override { thread_.stop(); }
    std::optional<Error> takeFault() override { return thread_.takeFault(); }
    DeviceHealth health() const noexcept override { return thread_.health(); }
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;

private:
    /// The polling thread's side.
    class Published final : public polled::PolledDevice {
    public:
        explicit Published(ReopenedPort port) : port_(std::move(port)), reader_(port_.device()) {}
        bool connect() noexcept override { return port_.connect(); }
        Heard receive(int milliseconds) noexcept override;
        void disconnect() noexcept override { port_.disconnect(); }
        void rest() noexcept override;
        const TabletReader& reader() const noexcept { return reader_; } ///< what it is made for; any thread
        /// The loop's. False: nothing was told since.
        bool take(Pen& pen) noexcept { return pens_.take(pen); }

    private:
        ReopenedPort port_;
        TabletReader reader_;
        Mailbox<Pen> pens_;
    };

    std::string name_;
    Published device_;
    polled::PollingThread thread_; ///< after what it reads

    PenMapping mapping_; ///< from here on the loop's
    Pen pen_;
    std::optional<double> readAt_;
};

} // namespace burin::input_events
