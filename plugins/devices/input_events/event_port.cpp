// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/event_port.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace burin::input_events {

Result<EventPort> EventPort::open(const std::filesystem::path& node, const std::string& name) {
    const int file = ::open(node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
        const bool forbidden = errno == EACCES || errno == EPERM;
        return Error{forbidden ? ErrorCode::deviceNotAllowed : ErrorCode::deviceNotFound, name, node.string(), {}};
    }
    libevdev* made = nullptr;
    if (const int fault = libevdev_new_from_fd(file, &made); fault < 0) {
        ::close(file);
        return Error{ErrorCode::deviceFault, name, node.string(), std::strerror(-fault)};
    }
    return EventPort(file, DeviceHandle(made));
}

EventPort::EventPort(EventPort&& other) noexcept
    : file_(std::exchange(other.file_, -1)), device_(std::move(other.device_)), catchesUp_(other.catchesUp_) {}

EventPort& EventPort::operator=(EventPort&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(device_, other.device_);
    std::swap(catchesUp_, other.catchesUp_);
    return *this;
}

EventPort::~EventPort() {
    if (file_ >= 0) ::close(file_);
}

EventPort::Heard EventPort::next(input_event& event, int milliseconds) noexcept {
    for (bool waited = false;; waited = true) {
        const unsigned int flags = catchesUp_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL;
        const int read = libevdev_next_event(device_.get(), flags, &event);
        if (read == LIBEVDEV_READ_STATUS_SUCCESS) return Heard::event;
        if (read == LIBEVDEV_READ_STATUS_SYNC) {
            const bool begins = !std::exchange(catchesUp_, true);
            if (begins) continue; // this event only indicates that others were lost
            return Heard::event;
        }
        if (read != -EAGAIN && read != -EINTR) return Heard::gone;
        if (std::exchange(catchesUp_, false)) continue;
        if (waited) return Heard::nothing;
        pollfd ready{file_, POLLIN, 0};
        if (::poll(&ready, 1, milliseconds) > 0 && (ready.revents & POLLIN) == 0) return Heard::gone;
    }
}

} // namespace burin::input_events
