// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace burin::haply {

/// Where the service listens: $HAPLY_INVERSE_SERVICE as HOST:PORT, or localhost:10001.
struct ServiceAddress {
    std::string host, port;
};
ServiceAddress serviceAddress();

/// A WebSocket to the service. It answers each message with one; its first comes unasked. Thread: one, but for `cut`.
class ServiceConnection {
public:
    static constexpr std::size_t longestMessage = 64 * 1024; ///< bytes

    /// Null: nobody listens there, it is no WebSocket, or it says nothing by itself. May take a second.
    static std::unique_ptr<ServiceConnection> open(const ServiceAddress& address);
    ~ServiceConnection();
    ServiceConnection(const ServiceConnection&) = delete;
    ServiceConnection& operator=(const ServiceConnection&) = delete;

    /// What it said by itself. Valid until `read`.
    std::string_view first() const noexcept;
    /// Whether a message has begun to arrive, after a wait of so long at most.
    bool waits(int milliseconds) noexcept;
    /// The message that arrives now; empty: the connection is broken. Valid until the next call. Allocates nothing once
    /// a message as long has been read.
    std::string_view read() noexcept;
    bool write(std::string_view message) noexcept; ///< false: the connection is broken
    /// Any thread: breaks the connection, so that the arm goes idle and whoever reads or writes comes back.
    void cut() noexcept;

private:
    struct Socket;
    explicit ServiceConnection(std::unique_ptr<Socket> socket);
    std::unique_ptr<Socket> socket_;
};

} // namespace burin::haply
