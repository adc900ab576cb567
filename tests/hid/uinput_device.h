// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/input.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace burin::test {

struct UinputIdentity {
    std::string name;
    std::uint16_t vendor = 0, product = 0;
    std::vector<unsigned int> buttons, axes; ///< the axes from -32768 to 32767
    std::vector<unsigned int> effects;       ///< kinds of force feedback, and its properties
};

/// An input device simulated with /dev/uinput, which the kernel treats like one of its own: it keeps the effects that
/// programs upload, and its owner renders them. This one renders them by the rules of the interface: an effect lasts
/// `replay.length` from its start. It is unplugged when the object is destroyed.
class UinputDevice {
public:
    static constexpr int room = 8; ///< number of effects

    explicit UinputDevice(const UinputIdentity& identity);
    ~UinputDevice();
    UinputDevice(const UinputDevice&) = delete;
    UinputDevice& operator=(const UinputDevice&) = delete;

    /// Sends an event and the end of its group.
    void send(unsigned int type, unsigned int code, int value) const;
    /// The effect of a type that is being rendered now; empty: none is.
    std::optional<ff_effect> rendered(std::uint16_t type);
    /// The values that a property was set to, in their order.
    std::vector<int> values(unsigned int property);
    std::size_t kept(); ///< number of effects that it has

private:
    struct Kept {
        ff_effect effect{};
        double endsAt = 0.0; ///< s, steady clock
    };
    void run(const std::stop_token& stop);
    void take(const input_event& event);
    void emit(unsigned int type, unsigned int code, int value) const;

    int file_ = -1;
    std::mutex mutex_;
    std::map<int, Kept> effects_;
    std::map<unsigned int, std::vector<int>> properties_;
    std::jthread thread_; // last member: it uses the others
};

} // namespace burin::test
