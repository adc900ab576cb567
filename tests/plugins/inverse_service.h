// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <QByteArray>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace burin::testing {

/// The state of arm and grip that a test sets, and the commands that the arm received.
struct InverseArm {
    std::array<double, 3> cursor{0.0, -0.15, 0.2}; ///< m
    std::array<double, 4> grip{1.0, 0.0, 0.0, 0.0};
    bool hasGrip = true, a = false, b = false, calibrated = true;
    std::array<double, 3> force{}; ///< N, of the latest message
};

/// A stand-in for Haply's service: a real WebSocket on a port of its own, which sends the full state first and then
/// answers each message with one. Serves one client at a time; another one can connect directly afterwards. Runs in a
/// thread of its own; `arm` is protected by `mutex`.
class InverseService {
public:
    enum class Key { vector, values, none };

    explicit InverseService(unsigned short port = 0)
        : acceptor_(context_, {boost::asio::ip::address_v4::loopback(), port}), thread_([this] { serve(); }) {}
    ~InverseService() {
        stopping_ = true;
        boost::system::error_code ignored;
        boost::asio::io_context context;
        boost::asio::ip::tcp::socket knock(context); // makes accept return
        knock.connect(acceptor_.local_endpoint(), ignored);
        if (current_ >= 0) ::shutdown(current_, SHUT_RDWR);
        thread_.join();
    }
    unsigned short port() const { return acceptor_.local_endpoint().port(); }
    QByteArray address() const { return "127.0.0.1:" + QByteArray::number(port()); }

    std::mutex mutex;
    InverseArm arm;
    std::atomic<Key> key{Key::vector};
    std::atomic<int> delay{0};        ///< ms before each answer
    std::atomic<bool> garbage{false}; ///< answers that are not JSON
    std::atomic<bool> mute{false};    ///< no answers
    std::atomic<bool> deafToHello{false};
    std::atomic<int> messages{0}, connections{0};
    void drop() {
        if (current_ >= 0) ::shutdown(current_, SHUT_RDWR);
    }

private:
    using Stream = boost::beast::websocket::stream<boost::asio::ip::tcp::socket>;

    void serve() {
        while (!stopping_) {
            boost::system::error_code fault;
            boost::asio::ip::tcp::socket socket(context_);
            acceptor_.accept(socket, fault);
            if (fault || stopping_) continue;
            current_ = socket.native_handle();
            while (deafToHello && !stopping_) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            Stream stream(std::move(socket));
            stream.accept(fault);
            if (!fault) talk(stream);
            current_ = -1;
        }
    }
    void talk(Stream& stream) {
        ++connections;
        boost::system::error_code fault;
        stream.text(true);
        stream.write(boost::asio::buffer(state()), fault);
        while (!stopping_ && !fault) {
            boost::beast::flat_buffer buffer;
            stream.read(buffer, fault);
            if (fault) break;
            ++messages;
            take(std::string_view(static_cast<const char*>(buffer.data().data()), buffer.data().size()));
            if (delay > 0) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
            while (mute && !stopping_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            stream.write(boost::asio::buffer(garbage ? std::string("{\"inverse3\": [nonsense") : state()), fault);
        }
        const std::lock_guard lock(mutex);
        arm.force = {}; // the arm goes idle
    }
    void take(std::string_view message) {
        const nlohmann::json commands = nlohmann::json::parse(message, nullptr, false);
        const std::lock_guard lock(mutex);
        arm.force = {};
        if (!commands.is_object() || !commands.contains("inverse3")) return;
        const nlohmann::json& first = commands["inverse3"][0];
        if (first["device_id"] != "04BA") return;
        const nlohmann::json& command = first["commands"]["set_cursor_force"];
        const char* name = key == Key::vector ? "vector" : "values";
        if (key == Key::none || !command.contains(name)) return;
        arm.force = {command[name]["x"], command[name]["y"], command[name]["z"]};
    }
    std::string state() {
        const std::lock_guard lock(mutex);
        const auto vector = [](const std::array<double, 3>& of) {
            return nlohmann::json{{"x", of[0]}, {"y", of[1]}, {"z", of[2]}};
        };
        nlohmann::json told;
        told["session_id"] = 1;
        told["inverse3"] = {{{"state",
                              {{"angular_position", {{"a0", 1.5}, {"a1", -30.0}, {"a2", 91.25}}},
                               {"cursor_position", vector(arm.cursor)},
                               {"cursor_velocity", vector({0, 0, 0})},
                               {"current_cursor_force", vector(arm.force)},
                               {"transform", {{"position", vector({1, 2, 3})}}}}},
                             {"status", {{"calibrated", arm.calibrated}, {"ready", true}, {"in_use", true}}},
                             {"device_id", "04BA"}},
                            {{"device_id", "0000"}, {"state", {{"cursor_position", vector({9, 9, 9})}}}}};
        told["verse_grip"] = nlohmann::json::array();
        told["wireless_verse_grip"] = nlohmann::json::array();
        if (arm.hasGrip)
            told["wireless_verse_grip"].push_back(
                {{"device_id", "61576"},
                 {"state",
                  {{"orientation", {{"w", arm.grip[0]}, {"x", arm.grip[1]}, {"y", arm.grip[2]}, {"z", arm.grip[3]}}},
                   {"buttons", {{"a", arm.a}, {"b", arm.b}, {"c", false}}},
                   {"battery_level", 0.75}}}});
        return told.dump();
    }

    boost::asio::io_context context_;
    boost::asio::ip::tcp::acceptor acceptor_;
    std::atomic<bool> stopping_{false};
    std::atomic<int> current_{-1};
    std::thread thread_; // last, as it uses the other members
};

} // namespace burin::testing
