// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Milling with devices on the real bus that are unplugged in the middle of a stroke and plugged in again: no force,
// no cut, a message, and the stroke continues; and the replay of the trace is bitwise identical.
#include "tests/core/haptics/replayed_session.h"
#include "tests/hid/force_watch.h"
#include "tests/hid/plugged_board.h"
#include "tests/hid/plugged_mouse.h"

#include <atomic>
#include <filesystem>
#include <thread>

namespace burin::test {
namespace {

const std::filesystem::path traceFile = "/tmp/trace.csv";
constexpr double forEver = 1e9; // s

HapticSettings settingsFor(const StylusDescription& stylus) {
    HapticSettings settings;
    settings.stylus = stylus;
    settings.rampSeconds = 0.1;
    settings.mapping.origin = {0.0, 0.0, 5.0}; // above the stock
    return settings;
}

/// A session that is recorded in a thread of its own.
class RecordedMilling {
public:
    explicit RecordedMilling(const StylusHandle& stylus) : settings_(settingsFor(stylus.device().description())) {
        thread_ = std::thread([this, stylus] {
            session_ = recordSession(stylus, settings_, traceFile, forEver, OwnerTells::nothing, stop_, &newest_);
        });
    }
    ~RecordedMilling() {
        if (thread_.joinable()) end();
    }
    RecordedMilling(const RecordedMilling&) = delete;
    RecordedMilling& operator=(const RecordedMilling&) = delete;

    /// Of the newest tick.
    const TickProgress& now() const { return newest_; }
    const RecordedSession& end() {
        stop_ = true;
        thread_.join();
        return session_;
    }
    std::string differenceOfReplay() const { return differenceOf(session_, replaySession(settings_, traceFile)); }

private:
    HapticSettings settings_;
    TickProgress newest_;
    std::atomic<bool> stop_{false};
    RecordedSession session_;
    std::thread thread_;
};

/// Checks the samples of an interrupted session.
void looksInterrupted(const RecordedSession& session, std::uint64_t from, std::uint64_t to) {
    BURIN_EXPECT(session.fault.empty());
    BURIN_EXPECT(from + 50 < to && to + 50 < session.samples.size());
    std::uint64_t cutBefore = 0, cutAfter = 0, away = 0;
    for (std::size_t i = 0; i < session.samples.size(); ++i) {
        const Sample& sample = session.samples[i];
        std::uint64_t units = 0;
        for (const RemovedMaterial& removed : sample.removed) units += removed.units;
        if ((sample.flags & sampleStylusInvalid) != 0) {
            BURIN_EXPECT(units == 0 && sample.force == glm::dvec3(0.0));
            if (i >= from && i < to) ++away;
        }
        (i < from ? cutBefore : cutAfter) += i < from || i >= to ? units : 0;
    }
    BURIN_EXPECT(cutBefore > 0 && cutAfter > 0 && away > 50);
}

/// Moves down into the stock and in circles without end: a hand that does not know that its device has gone.
class Hand {
public:
    explicit Hand(std::function<void(double)> moves)
        : thread_([moves = std::move(moves)](const std::stop_token& stop) {
            for (double time = 0.0; !stop.stop_requested(); time += 0.002) {
                moves(time);
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        }) {}

private:
    std::jthread thread_;
};

ForceBounds boundsOfTheBoard() {
    ForceBounds bounds;
    bounds.largest = 0.6 * 3.0;
    bounds.largestTorque = 0.6 * 100.0;
    bounds.rise = 0.16 + 0.05 + 1.5 * 0.003 / 0.1 * bounds.largest; // slew, force that carries the handle, fading in
    bounds.fall = 3.0 * bounds.rise;
    bounds.jump = 20.0;
    return bounds;
}

void anOpenStylusPulledOutInMidStroke() {
    DeviceRegistry registry;
    ForceWatch before(boundsOfTheBoard()), after(boundsOfTheBoard());
    std::mutex swapping;
    auto board = std::make_unique<PluggedBoard>(Board::limits(), [&](const Report& report) { before.hears(report); });
    const auto stylus = madeOpenStylus(registry);
    RecordedMilling milling(*stylus);
    const Hand hand([&](double time) {
        const std::lock_guard lock(swapping);
        if (!board) return;
        // Pressed against the part, with the radius growing each turn: even a slow machine finds something to cut for a
        // minute.
        const double depth = std::min(20.0 * time, 17.0), radius = std::min(4.0 + 0.2 * time, 14.0);
        board->x = radius * std::sin(2.0 * time);
        board->y = radius * std::cos(2.0 * time);
        board->z = -depth;
    });
    BURIN_EXPECT(comesTrue([&] { return milling.now().cut > 100 && before.verdict().pressed > 20; }));
    while (stylus->takeFault()) {
    }
    const std::uint64_t from = milling.now().ticks, invalid = milling.now().invalid; // ticks before the first report
    {
        const std::lock_guard lock(swapping);
        board.reset();
    }
    BURIN_EXPECT(comesTrue([&] { return !stylus->health().connected; }));
    const auto fault = stylus->takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceUnplugged && fault->subject == "Open Stylus mine");
    BURIN_EXPECT(comesTrue([&] { return milling.now().invalid > invalid + 100; }));
    {
        const std::lock_guard lock(swapping);
        board = std::make_unique<PluggedBoard>(Board::limits(), [&](const Report& report) { after.hears(report); });
    }
    BURIN_EXPECT(comesTrue([&] { return stylus->health().connected; }));
    const std::uint64_t to = milling.now().ticks, cut = milling.now().cut;
    BURIN_EXPECT(comesTrue([&] { return milling.now().cut > cut + 50 && after.verdict().pressed > 20; }));
    looksInterrupted(milling.end(), from, to);
    for (const ForceWatch* watch : {&before, &after})
        if (watch->verdict().violations > 0) throw Unmet(watch->verdict().text());
    const std::string difference = milling.differenceOfReplay();
    if (!difference.empty()) throw Unmet("the replay differs: " + difference);
}

void aMousePulledOutInMidStroke() {
    DeviceRegistry registry;
    std::mutex swapping;
    const auto plugged = [] { return std::make_unique<PluggedMouse>(0x256f, 0xc62e, wirelessDescriptor, "A"); };
    auto mouse = plugged();
    const auto stylus = openedMouse(registry, "spacemouse:256f:c62e:A");
    RecordedMilling milling(*stylus);
    const Hand hand([&](double time) {
        const std::lock_guard lock(swapping);
        if (!mouse || std::fmod(time, 0.016) > 0.0019) return;
        Report report{0x01};
        // The radius grows with each turn here too.
        const double reach = std::min(150.0 + 4.0 * time, 350.0);
        const double axes[] = {reach * std::sin(3.0 * time), reach * std::cos(3.0 * time), 180.0, 0.0, 0.0, 0.0};
        for (const double axis : axes) {
            const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(axis));
            report.push_back(static_cast<std::uint8_t>(bits & 0xffU));
            report.push_back(static_cast<std::uint8_t>(bits >> 8U));
        }
        mouse->send(report);
    });
    BURIN_EXPECT(comesTrue([&] { return milling.now().cut > 100; }));
    const std::uint64_t from = milling.now().ticks, invalid = milling.now().invalid; // ticks before the first report
    {
        const std::lock_guard lock(swapping);
        mouse.reset();
    }
    BURIN_EXPECT(comesTrue([&] { return milling.now().invalid > invalid + 100; }));
    const auto fault = stylus->takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceUnplugged);
    {
        const std::lock_guard lock(swapping);
        mouse = plugged();
    }
    BURIN_EXPECT(comesTrue([&] { return stylus->health().connected; }));
    const std::uint64_t to = milling.now().ticks, cut = milling.now().cut;
    BURIN_EXPECT(comesTrue([&] { return milling.now().cut > cut + 50; }));
    looksInterrupted(milling.end(), from, to);
    const std::string difference = milling.differenceOfReplay();
    if (!difference.empty()) throw Unmet("the replay differs: " + difference);
}

} // namespace

std::vector<GuestCheck> millingChecks() {
    return {{"an open stylus pulled out in mid stroke mills on when it is back", anOpenStylusPulledOutInMidStroke},
            {"a 3D mouse pulled out in mid stroke mills on when it is back", aMousePulledOutInMidStroke}};
}

} // namespace burin::test
