// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/stylus.h"
#include "plugins/devices/input_events/force_writer.h"

#include <memory>

namespace burin::input_events {

/// A gamepad or joystick whose vibration or force assists: reads through the stylus that it owns, and passes what the
/// loop wants to show to a ForceWriter.
class AssistedStylus final : public Stylus {
public:
    /// @param stylus its first two axes are those of the stick. @param abilities of the device
    AssistedStylus(std::unique_ptr<Stylus> stylus, std::unique_ptr<ForceWriter> writer,
                   const AssistAbilities& abilities);
    ~AssistedStylus() override { close(); }
    AssistedStylus(const AssistedStylus&) = delete;
    AssistedStylus& operator=(const AssistedStylus&) = delete;

    StylusDescription description() const override;
    /// Errors: those of the stylus and of ForceWriter::start.
    Result<void> open() override;
    void close() noexcept override;
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override { return stylus_->health(); }
    void cutMotors() noexcept override { writer_->cut(); }
    std::vector<DeviceAxis> axes() const override { return stylus_->axes(); }
    AxisMap axisMap() const override { return stylus_->axisMap(); }
    void assign(const AxisMap& map) noexcept override;
    AxisReading axisReading() const noexcept override { return stylus_->axisReading(); }
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;

private:
    std::unique_ptr<Stylus> stylus_;
    std::unique_ptr<ForceWriter> writer_;
    const AssistAbilities abilities_;
    Mailbox<AxisMap> maps_; ///< from the owner's thread to the haptic one
    AxisMap map_;           ///< in use; belongs to the haptic thread
};

} // namespace burin::input_events
