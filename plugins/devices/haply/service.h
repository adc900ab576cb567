// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace burin::haply {

/// The address of the service: $HAPLY_INVERSE_SERVICE as HOST:PORT, or localhost:10001.
struct ServiceAddress {
    std::string host, port;
};
ServiceAddress serviceAddress();

/// A WebSocket connection to the service. The service answers each message with one message; its first one is sent
/// without a request. Used by one thread, except for `cut`.
class ServiceConnection {
public:
    static constexpr std::size_t longestMessage = 64 * 1024; ///< bytes

    /// Null if there is no server, if it is not a WebSocket, or if it does not send a first message. May take a second.
    static std::unique_ptr<ServiceConnection> open(const ServiceAddress& address);
    ~ServiceConnection();
    ServiceConnection(const ServiceConnection&) = delete;
    ServiceConnection& operator=(const ServiceConnection&) = delete;

    /// The first message, sent without a request. Valid until `read`.
    std::string_view first() const noexcept;
    /// Whether a message has begun to arrive, after waiting for at most this time.
    bool waits(int milliseconds) noexcept;
    /// Reads the message that arrives now; empty if the connection is broken. Valid until the next call. Does not
    /// allocate once a message of that length has been read.
    std::string_view read() noexcept;
    bool write(std::string_view message) noexcept; ///< false: the connection is broken
    /// Any thread. Closes the connection, so that the arm goes idle and pending reads and writes return.
    void cut() noexcept;

private:
    struct Socket;
    explicit ServiceConnection(std::unique_ptr<Socket> socket);
    std::unique_ptr<Socket> socket_;
};

} // namespace burin::haply
