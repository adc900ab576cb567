// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/realtime_kit.h"

#include <memory>
#include <systemd/sd-bus.h>

namespace burin::realtimekit {
namespace {

constexpr const char* service = "org.freedesktop.RealtimeKit1";
constexpr const char* object = "/org/freedesktop/RealtimeKit1";
constexpr std::uint64_t patience = 500'000; // µs to wait for an answer

struct Close {
    void operator()(sd_bus* bus) const noexcept { sd_bus_flush_close_unref(bus); }
};
using Bus = std::unique_ptr<sd_bus, Close>;

Bus systemBus() noexcept {
    sd_bus* bus = nullptr;
    if (sd_bus_open_system(&bus) < 0) return nullptr;
    sd_bus_set_method_call_timeout(bus, patience);
    return Bus(bus);
}

template <class Number>
bool property(sd_bus* bus, const char* name, char type, Number& value) noexcept {
    return sd_bus_get_property_trivial(bus, service, object, service, name, nullptr, type, &value) >= 0;
}

} // namespace

bool ask(Limits& limits) noexcept {
    const Bus bus = systemBus();
    return bus != nullptr && property(bus.get(), "MaxRealtimePriority", SD_BUS_TYPE_INT32, limits.maximumPriority) &&
           property(bus.get(), "MinNiceLevel", SD_BUS_TYPE_INT32, limits.minimumNice) &&
           property(bus.get(), "RTTimeUSecMax", SD_BUS_TYPE_INT64, limits.maximumUnbroken);
}

bool makeRealtime(std::uint64_t thread, int priority) noexcept {
    const Bus bus = systemBus();
    return bus != nullptr && sd_bus_call_method(bus.get(), service, object, service, "MakeThreadRealtime", nullptr,
                                                nullptr, "tu", thread, static_cast<std::uint32_t>(priority)) >= 0;
}

bool makeHighPriority(std::uint64_t thread, int nice) noexcept {
    const Bus bus = systemBus();
    return bus != nullptr && sd_bus_call_method(bus.get(), service, object, service, "MakeThreadHighPriority", nullptr,
                                                nullptr, "ti", thread, nice) >= 0;
}

} // namespace burin::realtimekit
