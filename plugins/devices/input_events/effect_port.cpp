// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/effect_port.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace burin::input_events {
namespace {

/// Repeats a call that a signal interrupted. @return 0 or the error number
template <class Call>
int faultOf(const Call& call) noexcept {
    for (;;) {
        if (call() >= 0) return 0;
        if (errno != EINTR) return errno;
    }
}

class SystemEffects final : public EffectPort {
public:
    explicit SystemEffects(int file) noexcept : file_(file) {}
    ~SystemEffects() override { ::close(file_); } // the kernel removes the effects of the file
    SystemEffects(const SystemEffects&) = delete;
    SystemEffects& operator=(const SystemEffects&) = delete;

    int upload(ff_effect& effect) noexcept override {
        return faultOf([&] { return ioctl(file_, EVIOCSFF, &effect); });
    }
    int play(int id, bool on) noexcept override { return send(static_cast<unsigned int>(id), on ? 1 : 0); }
    int set(unsigned int property, int value) noexcept override { return send(property, value); }

private:
    int send(unsigned int code, int value) const noexcept {
        input_event event{};
        event.type = EV_FF;
        event.code = static_cast<std::uint16_t>(code);
        event.value = value;
        return faultOf([&] { return ::write(file_, &event, sizeof event); });
    }

    int file_;
};

} // namespace

std::unique_ptr<EffectPort> openEffectPort(const std::filesystem::path& node, int& fault) {
    const int file = ::open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    fault = file < 0 ? errno : 0;
    return file < 0 ? nullptr : std::make_unique<SystemEffects>(file);
}

} // namespace burin::input_events
