// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/input_events/pad_reader.h"
#include "plugins/devices/input_events/reopened_port.h"

namespace burin::input_events {

/// Reads a gamepad's events.
class PadSource final : public cap::ControlSource {
public:
    /// @param port an open gamepad
    explicit PadSource(ReopenedPort port) : port_(std::move(port)), reader_(port_.device()) {}

    bool connect() noexcept override;
    Heard receive(cap::Controls& controls, int milliseconds) noexcept override;
    void disconnect() noexcept override { port_.disconnect(); }
    const PadReader& reader() const noexcept { return reader_; } ///< its constant properties, before the thread runs

private:
    ReopenedPort port_;
    PadReader reader_;
};

} // namespace burin::input_events
