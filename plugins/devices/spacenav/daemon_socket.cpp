// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacenav/daemon_socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace burin::spacenav {

std::string daemonSocket() {
    const char* named = std::getenv("SPNAV_SOCKET"); // NOLINT(concurrency-mt-unsafe): nobody changes the environment
    return named != nullptr && *named != '\0' ? named : "/var/run/spnav.sock";
}

bool daemonRuns() {
    struct stat status {};
    return stat(daemonSocket().c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
}

bool DaemonSocket::connect() noexcept {
    if (socket_ >= 0) return true;
    try {
        const std::string file = daemonSocket();
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (file.size() >= sizeof address.sun_path) return false;
        std::copy(file.begin(), file.end(), address.sun_path);
        const int made = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        if (made < 0) return false;
        // In POSIX, addresses of every kind are passed as a sockaddr.
        if (::connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
            ::close(made);
            return false;
        }
        socket_ = made;
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

cap::ControlSource::Heard DaemonSocket::receive(cap::Controls& controls, int milliseconds) noexcept {
    if (unread_.empty() && !fetch(milliseconds)) return Heard::gone;
    Heard heard = Heard::nothing;
    while (!unread_.empty() && heard == Heard::nothing) { // one packet per call, so that no button event is lost
        const EventReader::Kind kind = reader_.take(unread_);
        if (kind == EventReader::Kind::motion) heard = Heard::motion;
        if (kind == EventReader::Kind::button) heard = Heard::other;
    }
    if (heard != Heard::nothing) controls = reader_.controls();
    return heard;
}

/// Waits for data. Returns false if the daemon is gone.
bool DaemonSocket::fetch(int milliseconds) noexcept {
    pollfd waiting{socket_, POLLIN, 0};
    const int ready = poll(&waiting, 1, milliseconds);
    if (ready == 0 || (ready < 0 && errno == EINTR)) return true;
    const ssize_t size = ready < 0 ? -1 : recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (size < 0 && errno == EINTR) return true;
    if (size <= 0) return false;
    unread_ = std::span(buffer_).first(static_cast<std::size_t>(size));
    return true;
}

void DaemonSocket::disconnect() noexcept {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    reader_.reset();
    unread_ = {};
}

} // namespace burin::spacenav
