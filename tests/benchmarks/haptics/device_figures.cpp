// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/places.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace burin::benchmarks {

namespace {

const std::string tests = BURIN_SOURCE_DIRECTORY "/tests/hid/", work = BURIN_BUILD_DIRECTORY "/hid-guest";
constexpr long hostileReports = 1'000'000;
/// The period at 1 kHz: an answer that takes longer is a sample late, which costs a third of the stiffness.
constexpr double longestRoundTrip = 1000.0; // us

struct ClosePipe {
    void operator()(FILE* pipe) const noexcept { ::pclose(pipe); }
};
using Pipe = std::unique_ptr<FILE, ClosePipe>;

bool succeeds(const std::string& command) {
    FILE* pipe = ::popen((command + " >/dev/null 2>&1 </dev/null").c_str(), "r");
    return pipe != nullptr && ::pclose(pipe) == 0;
}

/// What the virtual machine lacks, in words; nullopt if nothing is missing.
std::optional<std::string> missing() {
    if (!std::filesystem::exists(tests + "boot")) return "Burin's sources are not where it was built from";
    for (const char* program : {"qemu-system-x86_64", "busybox"})
        if (!succeeds("command -v " + std::string(program)))
            return std::string(program) + " is not installed (tests/packages.txt names its package)";
    if (!succeeds("'" + tests + "fetch-kernel' '" + work + "/kernel'"))
        return "Debian's kernel can't be fetched (network, package lists)";
    return std::nullopt;
}

Figure withLimit(const std::string& name, double value, const std::string& unit) {
    if (name == "round_trip_us.p50") return figure("hid." + name, value, unit, longestRoundTrip);
    if (name == "hostile.violations") return figure("hid." + name, value, unit, 0.0);
    Figure plain = figure("hid." + name, value, unit);
    if (name == "hostile.reports") {
        plain.limit = static_cast<double>(hostileReports);
        plain.atLeast = true;
    }
    return plain;
}

/// Handles one line of the virtual machine's output. Returns true for a figure.
bool take(Session& session, const std::string& line) {
    std::istringstream words(line);
    std::string hid, kind, name, unit;
    double value = 0.0;
    if (!(words >> hid >> kind) || hid != "hid") return false;
    if (kind == "failed") session.check(false, line);
    if (kind != "figure" || !(words >> name >> value >> unit)) return false;
    session.add(withLimit(name, value, unit));
    return true;
}

} // namespace

/// The virtual machine of the hid tests prints its own figures, one per line: "hid figure NAME VALUE UNIT". It is
/// emulated in software, so its times are an upper bound for any real machine.
void deviceFigures(Session& session) {
    if (!session.wants("hid.")) return;
    const bool hostile = session.wants("hid.hostile.");
    session.stage(hostile ? "hid.*: a virtual machine, a million hostile reports (some minutes)"
                          : "hid.*: a virtual machine (half a minute)");
    if (const std::optional<std::string> lacks = missing()) {
        session.note("hid.* is left out: the virtual machine does not run, as " + *lacks + ".");
        return;
    }
    const Pipe pipe(::popen(("'" + tests + "boot' '" + work + "/kernel' '" + work +
                             "/bench' '" BURIN_HID_GUEST "' '" BURIN_BUILD_DIRECTORY "/plugins/devices' figures " +
                             std::to_string(hostile ? hostileReports : 0) + " 2>&1")
                                .c_str(),
                            "r"));
    bool any = false;
    std::string line, last;
    std::array<char, 4096> block{};
    while (pipe != nullptr && std::fgets(block.data(), static_cast<int>(block.size()), pipe.get()) != nullptr) {
        Session::throwIfCancelled();
        line = block.data();
        any = take(session, line) || any;
        last = line;
    }
    session.check(any, "the virtual machine of hid.* ran; its last words: " + last);
}

} // namespace burin::benchmarks
