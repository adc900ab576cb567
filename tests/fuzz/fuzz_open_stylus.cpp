// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/exchange.h"
#include "tests/fuzz/reports.h"
#include "tests/plugins/board.h"

#include <cstdlib>
#include <vector>

namespace {

using namespace burin;

/// A report with the checksum that the device would have sent, which a fuzzer can't guess. Every other report stays as
/// it is.
std::vector<std::uint8_t> mended(std::span<const std::uint8_t> bytes, bool mend) {
    std::vector<std::uint8_t> report(bytes.begin(), bytes.end());
    if (!mend || report.size() < 3) return report;
    const std::uint16_t crc = openstylus::checksumOf(std::span(report).first(report.size() - 2));
    report[report.size() - 2] = static_cast<std::uint8_t>(crc & 0xffU);
    report[report.size() - 1] = static_cast<std::uint8_t>(crc >> 8U);
    return report;
}

} // namespace

/// Both sides receive the same hostile input. No force may exceed the limits, and time may not decrease.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    test::Board board([](const test::Board::Report&) { return true; });
    openstylus::Identity identity;
    if (openstylus::decodeFeature(board.feature(), identity) != openstylus::IdentityFault::none) std::abort();
    openstylus::Exchange exchange(identity);
    const std::uint64_t most =
        static_cast<std::uint64_t>(test::Board::limits().maximum_force) * test::Board::limits().maximum_force;
    double now = 1.0, time = -1.0;
    bool mend = false;
    fuzz::forEachReport({bytes, count}, [&](std::span<const std::uint8_t> raw) {
        mend = !mend;
        const std::vector<std::uint8_t> report = mended(raw, mend);
        board.receive(report);
        exchange.take(report, now += 0.001);
        const auto answer = exchange.answer({{now, -1e9, 3.0}, {1e12, now, 0.0}}, now);
        board.receive({answer.begin(), answer.end()});
        board.step(static_cast<std::uint32_t>(raw.size()) * 100);
        if (board.largestForceSquared > most || exchange.state().time < time) std::abort();
        time = exchange.state().time;
        while (exchange.faults().take()) {
        }
        openstylus::Identity other;
        static_cast<void>(openstylus::decodeFeature(report, other));
    });
    return 0;
}
