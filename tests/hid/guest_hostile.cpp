// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Hostile devices through the kernel, the plugins' decoders and the haptic step, with the answers checked where the
// motors would be.
#include "core/haptics/loop/servo_loop.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/hid/force_watch.h"
#include "tests/hid/hostile_reports.h"
#include "tests/hid/plugged_board.h"
#include "tests/hid/plugged_mouse.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <random>
#include <thread>

#include <pthread.h>
#include <sched.h>

namespace burin::test {
namespace {

/// Results of a stream of reports.
struct HostileOutcome {
    std::uint64_t reports = 0, seen = 0;
    std::uint64_t pressed = 0, unbelieved = 0; ///< answers with a force; answers to readings that must not be trusted
    std::uint64_t violations = 0;
    std::string detail;
};

constexpr std::size_t batch = 60; // the kernel keeps 64 unread reports
constexpr double rampSeconds = 0.03;

/// Judges the outcome of each tick; only the end of the test stops it.
class JudgedTicks final : public TickSink {
public:
    explicit JudgedTicks(double largestForce) : largest_(largestForce) {}
    AtEdge edge() noexcept override { return AtEdge::tick; }
    void tick(const Sample& sample, const TickTiming& timing) noexcept override {
        ++ticks;
        const bool good = isFinite(sample.force) && isFinite(sample.proxy.tip) && isFinite(sample.cuttingForce) &&
                          glm::length(sample.force) <= largest_ + 1e-12 &&
                          (timing.reading.valid || sample.force == glm::dvec3(0.0));
        if (!good) ++violations;
        if (glm::length(timing.reading.pose.position) > 1000.0) ++faraway;
        if (sample.removed[0].units > 0) ++cuts;
    }
    std::atomic<std::uint64_t> ticks{0}, violations{0}, cuts{0}, faraway{0};

private:
    double largest_;
};

HapticSettings settingsFor(const StylusDescription& stylus) {
    HapticSettings settings;
    settings.stylus = stylus;
    settings.rampSeconds = rampSeconds;
    settings.mapping.origin = {0.0, 0.0, 5.0}; // above the stock
    return settings;
}

/// From the device's values alone (README of core/haptics; haptics practice for clamp and slew).
ForceBounds boundsOf(const StylusDescription& stylus, const HapticSettings& settings) {
    ForceBounds bounds;
    bounds.largest = settings.forceShare * stylus.maximumForce.value;
    constexpr double longestTold = 0.003; // s: a tick that is later than this gets no force
    const double fading = 1.5 * longestTold / rampSeconds * bounds.largest;
    const double lift = 0.05; // N per tick, from the force that carries the handle
    const double slew = std::max(0.15, settings.couplingShare * stylus.maximumStiffness.value * 0.5 * 0.001) + lift;
    bounds.rise = slew + fading;
    bounds.fall = 3.0 * slew + fading;
    bounds.largestTorque = settings.forceShare * stylus.maximumTorque.value;
    bounds.jump = 20.0;
    return bounds;
}

/// Runs a loop on a block with a part in it, in a thread of its own, until it is destroyed.
class RunningLoop {
public:
    RunningLoop(const StylusHandle& stylus, const HapticSettings& settings)
        : rig(settings), ticks(settings.maximumForce()), part_(rig.volume.amounts().units[2]) {
        thread_ = std::thread([this, stylus, period = settings.tickPeriod] {
            ServoSettings servo;
            servo.period = period;
            if (!runServoLoop(stylus, rig.step, ticks, servo, stop_)) ++ticks.violations;
        });
    }
    ~RunningLoop() { end(); }
    RunningLoop(const RunningLoop&) = delete;
    RunningLoop& operator=(const RunningLoop&) = delete;

    /// Also checks whether the part was cut.
    void end() {
        if (!thread_.joinable()) return;
        stop_ = true;
        thread_.join();
        rig.step.settle();
        if (rig.volume.amounts().units[2] != part_) ++ticks.violations;
    }

    Rig rig;
    JudgedTicks ticks;

private:
    std::uint64_t part_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

/// Reports are sent in bursts: gives the sending thread a higher priority than the loop, which would otherwise run one
/// tick for each report.
class BeforeTheLoop {
public:
    BeforeTheLoop() { schedule(SCHED_FIFO, 30); }
    ~BeforeTheLoop() { schedule(SCHED_OTHER, 0); }
    BeforeTheLoop(const BeforeTheLoop&) = delete;
    BeforeTheLoop& operator=(const BeforeTheLoop&) = delete;

private:
    static void schedule(int policy, int priority) {
        const sched_param wanted{priority};
        pthread_setschedparam(pthread_self(), policy, &wanted); // as root; without it everything takes longer
    }
};

std::uint64_t seen(const DeviceHealth& health) {
    return health.readings + health.damaged + health.repeated;
}

/// A device that alternates between hostile and well-behaved reports.
class HostileBoard {
public:
    explicit HostileBoard(const ForceBounds& bounds)
        : watch(bounds)
        , firmware_([](const Board::Report&) { return true; })
        , device_(openStylusIdentity(),
                  {[this](const Report& report) { hear(report); }, [this](std::uint8_t) { return feature(); }}) {}

    void send(const Report& report) {
        watch.sends(report);
        device_.send(report);
    }
    /// Waits for the host's answer to a reading, for a limited time: the reading may have been overtaken, or rejected.
    void comesBack(std::uint16_t sequence) {
        std::unique_lock lock(mutex_);
        heard_.wait_for(lock, std::chrono::milliseconds(2), [&] { return watch.answered() == sequence; });
    }
    /// Waits until the driver has read a number of reports, for a limited time: it answers only those that it accepts.
    void comesToSee(const StylusDevice& stylus, std::uint64_t reports) {
        std::unique_lock lock(mutex_);
        for (int i = 0; i < 10 && seen(stylus.health()) < reports; ++i)
            heard_.wait_for(lock, std::chrono::milliseconds(1));
    }
    std::uint64_t largestForceSquared() {
        const std::lock_guard lock(mutex_);
        return firmware_.largestForceSquared;
    }
    ForceWatch watch;

private:
    void hear(const Report& report) {
        watch.hears(report);
        const std::lock_guard lock(mutex_);
        firmware_.receive(report);
        heard_.notify_all();
    }
    Report feature() {
        const std::lock_guard lock(mutex_);
        return firmware_.feature();
    }

    std::mutex mutex_;
    std::condition_variable heard_;
    Board firmware_;
    UhidDevice device_; // last member: its thread uses the others
};

/// Reports with an id that the descriptor does not name are dropped by the kernel.
bool reachesTheDriver(const Report& report) {
    return report[0] == OPEN_STYLUS_INPUT_ID;
}

/// The motion of a hand that mills in circles through the stock and presses on the part below it.
glm::dvec3 stroke(double time) {
    return {8.0 * std::sin(3.0 * time), 8.0 * std::cos(3.0 * time), -17.0 + 3.0 * std::sin(5.0 * time)};
}

HostileOutcome hostileOpenStylus(std::uint64_t count) {
    constexpr std::uint64_t calm = 80, storm = 32 * batch;
    DeviceRegistry registry;
    // The values of the board, which the test knows without asking the host.
    StylusDescription figures;
    figures.maximumForce.value = 3.0;
    figures.maximumStiffness.value = 400.0;
    figures.maximumTorque.value = 100.0;
    HostileBoard board(boundsOf(figures, {}));
    const auto stylus = madeOpenStylus(registry);
    BURIN_EXPECT(stylus->description().maximumForce.value == figures.maximumForce.value);
    RunningLoop loop(*stylus, settingsFor(stylus->description()));
    HostileReports hostile(29);
    InputReport good;
    HostileOutcome outcome;
    const auto sendGood = [&] {
        good.sequence = static_cast<std::uint16_t>(good.sequence + 1);
        good.microseconds += 1000;
        good.flags = board.watch.motors() ? 3 : 2;
        good.position = stroke(1e-3 * static_cast<double>(outcome.reports));
        board.send(good.bytes());
        ++outcome.reports;
        board.comesBack(good.sequence);
    };
    const BeforeTheLoop ahead;
    while (outcome.reports < count) {
        for (std::uint64_t i = 0; i < calm; ++i) sendGood();
        std::uint64_t wanted = seen(stylus->health());
        for (std::uint64_t i = 0; i < storm; ++i, ++outcome.reports) {
            const Report report = hostile.next(good);
            board.send(report);
            wanted += reachesTheDriver(report) ? 1U : 0U;
            if (i % batch == batch - 1) {
                board.comesToSee(*stylus, wanted);
                wanted = seen(stylus->health());
            }
        }
        hostile.pause();
        good.sequence = static_cast<std::uint16_t>(good.sequence + storm + 1);
        board.watch.forget();
    }
    loop.end();
    const ForceWatch::Verdict verdict = board.watch.verdict();
    const DeviceHealth health = stylus->health();
    outcome.seen = seen(health);
    outcome.pressed = verdict.pressed;
    outcome.unbelieved = verdict.unbelieved;
    outcome.violations = verdict.violations + loop.ticks.violations;
    const auto most = static_cast<std::uint64_t>(Board::limits().maximum_force);
    if (board.largestForceSquared() > most * most) ++outcome.violations;
    outcome.detail = verdict.text() + "; " + std::to_string(loop.ticks.ticks) + " ticks, " +
                     std::to_string(loop.ticks.violations) + " bad; ";
    // Guards against a meaningless run: forces, cuts, rejected readings and damaged reports must occur.
    BURIN_EXPECT(verdict.pressed > verdict.outputs / 100 && loop.ticks.cuts > 0);
    BURIN_EXPECT(verdict.unbelieved > count / 1000 && health.damaged > count / 10 && health.readings > count / 10);
    return outcome;
}

HostileOutcome hostileMice(std::uint64_t count) {
    struct Kind {
        std::uint16_t product;
        std::string_view descriptor;
        const char* id;
        const char* mode;
    };
    const Kind kinds[] = {{0xc635, navigatorDescriptor, "spacemouse:256f:c635", "rate"},
                          {0xc62e, wirelessDescriptor, "spacemouse:256f:c62e", "position"},
                          {0xc633, enterpriseDescriptor, "spacemouse:256f:c633", "rate"}};
    constexpr std::array<std::uint8_t, 8> ids{0x01, 0x02, 0x03, 0x04, 0x17, 0x1c, 0x05, 0x13};
    HostileOutcome outcome;
    std::mt19937 random(31);
    for (const Kind& kind : kinds) {
        DeviceRegistry registry;
        PluggedMouse mouse(0x256f, kind.product, kind.descriptor);
        const auto stylus = openedMouse(registry, kind.id, kind.mode);
        const double reach = stylus->description().workspaceRadius.value;
        HapticSettings settings = settingsFor(stylus->description());
        settings.tickPeriod = 0.004; // an emulated processor cannot run a thousand ticks a second
        RunningLoop loop(*stylus, settings);
        for (std::uint64_t i = 0; i < (count + 2) / 3; ++i, ++outcome.reports) {
            Report report(random() % 32 == 0 ? 1 + random() % 4096 : 1 + random() % 16);
            for (auto& byte : report) byte = static_cast<std::uint8_t>(random());
            if (random() % 8 != 0) report[0] = ids[random() % ids.size()];
            mouse.send(report);
            if (i % 32 == 31) std::this_thread::sleep_for(std::chrono::milliseconds(1)); // at most half the queue
        }
        BURIN_EXPECT(comesTrue([&] { return loop.ticks.ticks > 100; }));
        loop.end();
        for (const Report& output : mouse.outputs()) // only the LED's
            if (output != Report{0x04, 0x01} && output != Report{0x04, 0x00}) ++outcome.violations;
        const glm::dvec3 place = stylus->read(1e6).pose.position;
        if (!(glm::length(place) <= reach + 1e-9)) ++outcome.violations;
        outcome.violations += loop.ticks.violations + loop.ticks.faraway;
        outcome.seen += stylus->health().readings;
        BURIN_EXPECT(stylus->health().readings > count / 60);
    }
    return outcome;
}

double secondsSince(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

void hostileReportsDoNoHarm() {
    const std::uint64_t wanted = hostileReports();
    const auto begun = std::chrono::steady_clock::now();
    const HostileOutcome stylus = hostileOpenStylus(wanted / 2);
    const double stylusSeconds = secondsSince(begun);
    const HostileOutcome mice = hostileMice(wanted - wanted / 2);
    const double mouseSeconds = secondsSince(begun) - stylusSeconds;
    const auto violations = stylus.violations + mice.violations;
    tellFigure("hostile.reports", static_cast<double>(stylus.reports + mice.reports), "reports");
    tellFigure("hostile.seen", static_cast<double>(stylus.seen + mice.seen), "reports");
    tellFigure("hostile.violations", static_cast<double>(violations), "reports");
    tellFigure("hostile.pressed", static_cast<double>(stylus.pressed), "answers");
    tellFigure("hostile.unbelieved", static_cast<double>(stylus.unbelieved), "answers");
    tellFigure("hostile.open_stylus_us", 1e6 * stylusSeconds / static_cast<double>(stylus.reports), "us");
    tellFigure("hostile.spacemouse_us", 1e6 * mouseSeconds / static_cast<double>(mice.reports), "us");
    if (violations > 0) throw Unmet(stylus.detail + mice.detail);
}

} // namespace

std::vector<GuestCheck> hostileChecks() {
    return {{"hostile reports do no harm", hostileReportsDoNoHarm}};
}

} // namespace burin::test
