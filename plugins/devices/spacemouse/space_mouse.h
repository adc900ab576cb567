// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/hid/hid_bus.h"
#include "plugins/devices/spacemouse/reports.h"

#include <memory>
#include <string>

namespace burin::spacemouse {

/// Whether an interface belongs to a 3D mouse.
bool isSpaceMouse(const hid::DeviceInfo& device);

/// Reads the reports of a 3D mouse, and lights its LED while it is connected.
class SpaceMouse final : public cap::ControlSource {
public:
    /// Time in s without a report of motion after which the cap counts as at rest. A held cap reports at least 60 times
    /// a second; a cap that was released reports zero, unless that report is lost.
    static constexpr double staleAfter = 0.1;

    /// @param port already connected; @param id from idOf, used to find the device again
    SpaceMouse(hid::Bus& bus, std::unique_ptr<hid::Port> port, std::string id)
        : bus_(bus), port_(std::move(port)), id_(std::move(id)) {}

    bool connect() noexcept override;
    Heard receive(cap::Controls& controls, int milliseconds) noexcept override;
    void disconnect() noexcept override;

private:
    hid::Bus& bus_;
    std::unique_ptr<hid::Port> port_;
    std::string id_;
    bool lit_ = false;
    ReportReader reader_;
};

} // namespace burin::spacemouse
