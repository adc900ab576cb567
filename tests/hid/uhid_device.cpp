// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/hid/uhid_device.h"

#include <linux/uhid.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <unistd.h>

namespace burin::test {
namespace {

constexpr std::uint16_t busUsb = 0x03;
constexpr int waitMilliseconds = 20;

void copyText(std::uint8_t* target, std::size_t size, const std::string& text) {
    std::memcpy(target, text.data(), std::min(text.size(), size - 1));
}

bool writeEvent(int file, const uhid_event& event) {
    return write(file, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
}

} // namespace

UhidDevice::UhidDevice(const UhidIdentity& identity, Handlers handlers) : handlers_(std::move(handlers)) {
    file_ = open("/dev/uhid", O_RDWR | O_CLOEXEC);
    uhid_event event{};
    event.type = UHID_CREATE2;
    copyText(event.u.create2.name, sizeof event.u.create2.name, identity.name);
    copyText(event.u.create2.uniq, sizeof event.u.create2.uniq, identity.serial);
    event.u.create2.bus = busUsb;
    event.u.create2.vendor = identity.vendor;
    event.u.create2.product = identity.product;
    event.u.create2.rd_size = static_cast<std::uint16_t>(identity.descriptor.size());
    std::ranges::copy(identity.descriptor, event.u.create2.rd_data);
    if (file_ < 0 || !writeEvent(file_, event)) {
        std::perror("/dev/uhid");
        std::abort(); // without the kernel's uhid there is no test
    }
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

UhidDevice::~UhidDevice() {
    thread_.request_stop();
    thread_.join();
    uhid_event event{};
    event.type = UHID_DESTROY;
    writeEvent(file_, event);
    close(file_);
}

bool UhidDevice::send(std::span<const std::uint8_t> report) {
    uhid_event event{};
    event.type = UHID_INPUT2;
    const std::size_t size = std::min(report.size(), sizeof event.u.input2.data);
    event.u.input2.size = static_cast<std::uint16_t>(size);
    std::copy_n(report.begin(), size, event.u.input2.data);
    const std::lock_guard lock(writing_);
    // The kernel accepts events that end where their data ends.
    const std::size_t whole = offsetof(uhid_event, u) + offsetof(uhid_input2_req, data) + size;
    return write(file_, &event, whole) == static_cast<ssize_t>(whole);
}

void UhidDevice::run(const std::stop_token& stop) {
    const auto event = std::make_unique<uhid_event>();
    while (!stop.stop_requested()) {
        pollfd wanted{file_, POLLIN, 0};
        if (poll(&wanted, 1, waitMilliseconds) <= 0) continue;
        if (read(file_, event.get(), sizeof *event) <= 0) continue;
        if (event->type == UHID_OUTPUT) {
            const auto& output = event->u.output;
            handlers_.output(Report(output.data, output.data + output.size));
        } else if (event->type == UHID_GET_REPORT) {
            const Report answer = handlers_.feature ? handlers_.feature(event->u.get_report.rnum) : Report{};
            uhid_event reply{};
            reply.type = UHID_GET_REPORT_REPLY;
            reply.u.get_report_reply.id = event->u.get_report.id;
            reply.u.get_report_reply.err = answer.empty() ? 5 : 0; // EIO
            reply.u.get_report_reply.size = static_cast<std::uint16_t>(answer.size());
            std::ranges::copy(answer, reply.u.get_report_reply.data);
            const std::lock_guard lock(writing_);
            writeEvent(file_, reply);
        } else if (event->type == UHID_SET_REPORT) {
            uhid_event reply{};
            reply.type = UHID_SET_REPORT_REPLY;
            reply.u.set_report_reply.id = event->u.set_report.id;
            reply.u.set_report_reply.err = 5;
            const std::lock_guard lock(writing_);
            writeEvent(file_, reply);
        }
    }
}

} // namespace burin::test
