// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>

namespace burin::benchmarks {

namespace {

struct ClosePipe {
    void operator()(FILE* pipe) const noexcept { ::pclose(pipe); }
};

/// What a program writes; nothing where it fails.
std::optional<std::string> outputOf(const std::string& command) {
    const std::unique_ptr<FILE, ClosePipe> pipe(::popen(command.c_str(), "r"));
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe.get()))
        text.append(block.data(), count);
    return text;
}

} // namespace

/// The virtual machine of the hid tests tells its figures itself, a line each: "hid figure NAME VALUE UNIT". All of it
/// is emulated in software, so that times are an upper bound of any real machine's.
void deviceFigures(Session& session) {
    if (!session.wants("hid.")) return;
    session.stage("hid.*: a virtual machine (a minute)");
    const std::string tests = BURIN_SOURCE_DIRECTORY "/tests/hid/", work = BURIN_BUILD_DIRECTORY "/hid-guest";
    const std::optional<std::string> text =
        outputOf("'" + tests + "fetch-kernel' '" + work + "/kernel' >/dev/null 2>&1 && '" + tests + "boot' '" + work +
                 "/kernel' '" + work + "' '" BURIN_HID_GUEST "' '" BURIN_BUILD_DIRECTORY "/plugins/devices' 2>&1");
    std::istringstream lines(text.value_or(std::string()));
    bool any = false;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string hid, kind, name, unit;
        double value = 0.0;
        if (!(words >> hid >> kind >> name >> value >> unit) || hid != "hid" || kind != "figure") continue;
        session.add(figure("hid." + name, value, unit));
        any = true;
    }
    if (!any)
        session.note("The virtual machine did not run (qemu, busybox, a network for its kernel): hid.* is left out.");
}

} // namespace burin::benchmarks
