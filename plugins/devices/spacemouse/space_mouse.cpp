// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/space_mouse.h"

#include "plugins/devices/spacemouse/models.h"

namespace burin::spacemouse {
namespace {

constexpr std::size_t largestReport = 64;

} // namespace

bool isSpaceMouse(const hid::DeviceInfo& device) {
    return isSpaceMouse(device.vendor, device.product, device.usagePage, device.usage);
}

bool SpaceMouse::connect() noexcept {
    if (port_ == nullptr)
        port_ = hid::openAgain(
            bus_, [](const hid::DeviceInfo& device) { return isSpaceMouse(device); }, id_);
    if (port_ == nullptr) return false;
    if (!lit_) port_->write(ledReport(true));
    return lit_ = true;
}

cap::ControlSource::Heard SpaceMouse::receive(cap::Controls& controls, int milliseconds) noexcept {
    std::array<std::uint8_t, largestReport> report;
    const int size = port_->read(report, milliseconds);
    if (size < 0) {
        port_.reset();
        return Heard::gone;
    }
    if (size == 0) return Heard::nothing;
    const ReportKind kind = reader_.take(Bytes(report).first(static_cast<std::size_t>(size)));
    if (kind == ReportKind::unknown) return Heard::nothing;
    controls = reader_.controls();
    const bool moved = kind == ReportKind::translation || kind == ReportKind::rotation || kind == ReportKind::motion;
    return moved ? Heard::motion : Heard::other;
}

void SpaceMouse::disconnect() noexcept {
    if (port_ != nullptr) port_->write(ledReport(false));
    lit_ = false;
    reader_.rest();
}

} // namespace burin::spacemouse
