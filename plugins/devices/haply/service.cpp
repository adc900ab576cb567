// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/service.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_static_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <poll.h>
#include <sys/socket.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>

namespace burin::haply {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;

constexpr std::chrono::seconds patience{1}; // for a server that accepts connections but does not answer

/// Closes a socket if its operation does not end in time: these calls have no time limit of their own.
class Limit {
public:
    explicit Limit(int handle)
        : thread_([this, handle](const std::stop_token& stop) {
            std::unique_lock lock(mutex_);
            woken_.wait_for(lock, stop, patience, [] { return false; });
            if (!stop.stop_requested()) ::shutdown(handle, SHUT_RDWR);
        }) {}

private:
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_; // last: it uses the members above
};

} // namespace

ServiceAddress serviceAddress() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody changes the environment
    const char* named = std::getenv("HAPLY_INVERSE_SERVICE");
    const std::string text = named != nullptr ? named : "localhost:10001";
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {text, "10001"};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

struct ServiceConnection::Socket {
    asio::io_context context;
    beast::websocket::stream<asio::ip::tcp::socket, false> stream{context}; // false: no compression
    beast::flat_static_buffer<longestMessage> buffer;
    int handle = -1;
};

std::unique_ptr<ServiceConnection> ServiceConnection::open(const ServiceAddress& address) {
    auto socket = std::make_unique<Socket>();
    beast::error_code fault;
    asio::ip::tcp::resolver resolver(socket->context);
    const auto places = resolver.resolve(address.host, address.port, fault);
    if (fault) return nullptr;
    asio::connect(socket->stream.next_layer(), places, fault);
    if (fault) return nullptr;
    socket->stream.next_layer().set_option(asio::ip::tcp::no_delay(true), fault);
    socket->handle = socket->stream.next_layer().native_handle();
    socket->stream.read_message_max(longestMessage);
    const Limit limit(socket->handle);
    socket->stream.handshake(address.host + ":" + address.port, "/", fault);
    if (fault) return nullptr;
    // The beginning of the first message may have arrived with the handshake: the stream has it then, and polling the
    // socket would not show it.
    socket->stream.read(socket->buffer, fault);
    if (fault) return nullptr;
    socket->stream.text(true);
    return std::unique_ptr<ServiceConnection>(new ServiceConnection(std::move(socket)));
}

ServiceConnection::ServiceConnection(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}
ServiceConnection::~ServiceConnection() = default;

std::string_view ServiceConnection::first() const noexcept {
    const auto bytes = std::as_const(socket_->buffer).data();
    return {static_cast<const char*>(bytes.data()), bytes.size()};
}

bool ServiceConnection::waits(int milliseconds) noexcept {
    pollfd arriving{socket_->handle, POLLIN, 0};
    return poll(&arriving, 1, milliseconds) > 0;
}

std::string_view ServiceConnection::read() noexcept {
    beast::error_code fault;
    socket_->buffer.clear();
    socket_->stream.read(socket_->buffer, fault);
    if (fault) return {};
    return first();
}

bool ServiceConnection::write(std::string_view message) noexcept {
    beast::error_code fault;
    socket_->stream.write(asio::buffer(message.data(), message.size()), fault);
    return !fault;
}

void ServiceConnection::cut() noexcept {
    ::shutdown(socket_->handle, SHUT_RDWR);
}

} // namespace burin::haply
