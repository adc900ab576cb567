// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/open_stylus/reports.h"
#include "tests/plugins/running_board.h"
#include "tests/plugins/scripted_bus.h"

#include <memory>

namespace burin::test {

inline hid::DeviceInfo boardInfo(const char* serial = "0001") {
    hid::DeviceInfo info;
    info.vendor = 0x1209;
    info.product = 0x0001;
    info.usagePage = openstylus::usagePage;
    info.usage = openstylus::usage;
    info.serial = serial;
    info.name = "Open Stylus mine";
    return info;
}

/// A running board on a scripted bus.
class PluggedBoard : public RunningBoard {
public:
    explicit PluggedBoard(ScriptedBus& bus, const open_stylus_limits& limits = Board::limits())
        : RunningBoard([this](const Board::Report& report) { return wire_->send(report); }, limits)
        , wire_(bus.plug(boardInfo(), [this] { return feature(); })) {
        wire_->onOutput([this](const Board::Report& report) { deliver(report); });
        start();
    }
    ~PluggedBoard() {
        stop();
        wire_->cut();
    }
    PluggedBoard(const PluggedBoard&) = delete;
    PluggedBoard& operator=(const PluggedBoard&) = delete;

private:
    std::shared_ptr<Wire> wire_;
};

} // namespace burin::test
