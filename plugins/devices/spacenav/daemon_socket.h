// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/cap_stylus.h"
#include "plugins/devices/spacenav/events.h"

#include <span>
#include <string>

namespace burin::spacenav {

/// Path of the daemon's socket: $SPNAV_SOCKET, or /var/run/spnav.sock.
std::string daemonSocket();
/// Whether the socket exists; does not connect to it.
bool daemonRuns();

/// Reads the messages of the daemon.
class DaemonSocket final : public cap::ControlSource {
public:
    DaemonSocket() = default;
    ~DaemonSocket() override { disconnect(); }
    DaemonSocket(const DaemonSocket&) = delete;
    DaemonSocket& operator=(const DaemonSocket&) = delete;

    bool connect() noexcept override;
    Heard receive(cap::Controls& controls, int milliseconds) noexcept override;
    void disconnect() noexcept override;

private:
    bool fetch(int milliseconds) noexcept;

    int socket_ = -1;
    EventReader reader_;
    std::array<std::uint8_t, 4096> buffer_{};
    std::span<const std::uint8_t> unread_; ///< part of buffer_
};

} // namespace burin::spacenav
