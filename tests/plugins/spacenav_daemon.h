// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <QByteArray>
#include <QString>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace burin::test {

/// A stand-in for spacenavd: a socket of its own, with one client.
class SpacenavDaemon {
public:
    using Packet = std::array<std::int32_t, 8>;

    explicit SpacenavDaemon(const QString& file) : file_(file.toLocal8Bit()) { listen(); }
    ~SpacenavDaemon() { stop(); }

    void listen() {
        listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, file_.constData(), static_cast<std::size_t>(file_.size()));
        if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) std::abort();
        if (::listen(listener_, 4) != 0) std::abort();
    }
    void accept() { client_ = ::accept(listener_, nullptr, nullptr); }
    void send(const Packet& packet) const { send(&packet, sizeof packet); }
    void send(const void* bytes, std::size_t size) const {
        if (::send(client_, bytes, size, MSG_NOSIGNAL) != static_cast<ssize_t>(size)) std::abort();
    }
    void stop() {
        if (client_ >= 0) close(std::exchange(client_, -1));
        if (listener_ >= 0) close(std::exchange(listener_, -1));
        unlink(file_.constData());
    }

private:
    QByteArray file_;
    int listener_ = -1, client_ = -1;
};

} // namespace burin::test
