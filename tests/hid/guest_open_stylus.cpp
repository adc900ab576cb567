// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_registry.h"
#include "core/device/device_watch.h"
#include "tests/hid/guest.h"
#include "tests/hid/uhid_device.h"
#include "tests/plugins/comes_true.h"
#include "tests/plugins/running_board.h"

#include <algorithm>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

namespace burin::test {
namespace {

constexpr const char* id = "open_stylus:1209:0001:0001";
constexpr uid_t nobody = 65534;
constexpr const char* hostRole = "host";
constexpr const char* userRole = "user";

UhidIdentity identity() {
    return {"Open Stylus mine", "0001", 0x1209, 0x0001,
            Report(open_stylus_descriptor, open_stylus_descriptor + OPEN_STYLUS_DESCRIPTOR_SIZE)};
}

/// A board with the reference firmware, plugged into the kernel.
class PluggedBoard : public RunningBoard {
public:
    explicit PluggedBoard(const open_stylus_limits& limits = Board::limits())
        : RunningBoard([this](const Board::Report& report) { return device_.send(report); }, limits)
        , device_(identity(),
                  {[this](const Report& report) { deliver(report); }, [this](std::uint8_t) { return feature(); }}) {
        start();
    }
    ~PluggedBoard() { stop(); }
    PluggedBoard(const PluggedBoard&) = delete;
    PluggedBoard& operator=(const PluggedBoard&) = delete;
    UhidDevice& device() { return device_; }

private:
    UhidDevice device_;
};

bool isThere(DeviceRegistry& registry) {
    return comesTrue([&] {
        const auto found = registry.scan();
        return std::ranges::find(found, id, &FoundDevice::id) != found.end();
    });
}

std::unique_ptr<SelfPacedStylus> made(DeviceRegistry& registry) {
    BURIN_EXPECT(isThere(registry));
    auto stylus = registry.make(id);
    if (!stylus) throw Unmet("make: " + stylus.error().subject + " " + stylus.error().detail);
    return std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*stylus));
}

std::vector<ErrorCode> codesOf(StylusDevice& stylus) {
    std::vector<ErrorCode> codes;
    while (const auto fault = stylus.takeFault()) codes.push_back(fault->code);
    return codes;
}

std::uint64_t mostForceSquared() {
    return static_cast<std::uint64_t>(Board::limits().maximum_force) * Board::limits().maximum_force;
}

void tellsItsLimits() {
    DeviceRegistry registry;
    PluggedBoard board;
    const StylusDescription description = made(registry)->description();
    BURIN_EXPECT(description.name == "Open Stylus mine");
    BURIN_EXPECT(description.maximumForce.value == 3.0 && description.maximumStiffness.value == 400.0);
    BURIN_EXPECT(description.rate.value == 1000.0 && description.actuated.rotations == 3);
}

void theHandFeelsTheWall() {
    DeviceRegistry registry;
    PluggedBoard board;
    Wall wall; // outlives the stylus, which calls it
    const auto stylus = made(registry);
    BURIN_EXPECT(stylus->open() && stylus->start(wall));
    board.x = -10.0;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 1.0; }));
    board.x = 3.0;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 0.0; }));
    board.takeRoundTrips();
    std::vector<double> trips;
    BURIN_EXPECT(comesTrue([&] {
        for (const double trip : board.takeRoundTrips()) trips.push_back(trip);
        return trips.size() >= 3000;
    }));
    std::ranges::sort(trips);
    tellFigure("round_trip_us.p50", 1e6 * trips[trips.size() / 2], "us");
    tellFigure("round_trip_us.p99", 1e6 * trips[trips.size() * 99 / 100], "us");
    tellFigure("lost", static_cast<double>(stylus->health().lost), "readings");
    BURIN_EXPECT(wall.timeRises && wall.oneThread);
    stylus->stop();
    BURIN_EXPECT(wall.ended && comesTrue([&] { return !board.motors.load(); }));
}

void unpluggedInMidStroke() {
    DeviceRegistry registry;
    auto board = std::make_unique<PluggedBoard>();
    Wall wall; // outlives the stylus, which calls it
    const auto stylus = made(registry);
    board->x = -10.0;
    BURIN_EXPECT(stylus->start(wall));
    BURIN_EXPECT(comesTrue([&] { return board->force.load() > 0.0; }));
    codesOf(*stylus);
    board.reset();
    BURIN_EXPECT(comesTrue([&] { return !stylus->health().connected; }));
    BURIN_EXPECT(codesOf(*stylus) == std::vector{ErrorCode::deviceUnplugged});
    const int invalid = wall.invalid;
    BURIN_EXPECT(comesTrue([&] { return wall.invalid > invalid + 20; }));
    board = std::make_unique<PluggedBoard>();
    board->x = -20.0;
    BURIN_EXPECT(comesTrue([&] { return board->force.load() == 2.0; }));
    BURIN_EXPECT(stylus->health().connected && wall.timeRises);
    BURIN_EXPECT(board->largestForceSquared() <= mostForceSquared());
}

/// This program again, in a process of its own.
pid_t started(const char* role) {
    const pid_t process = fork();
    if (process == 0) {
        execl("/proc/self/exe", "program", role, nullptr);
        _exit(127);
    }
    return process;
}

void theWatchdogCutsTheMotorsOfAHostThatDied() {
    PluggedBoard board;
    const pid_t host = started(hostRole);
    board.x = -10.0;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 1.0; }));
    const auto killed = std::chrono::steady_clock::now();
    kill(host, SIGKILL);
    BURIN_EXPECT(comesTrue([&] { return !board.motors.load() && board.force.load() == 0.0; }));
    const auto after = std::chrono::duration<double>(std::chrono::steady_clock::now() - killed).count();
    tellFigure("killed_to_motors_off_ms", 1e3 * after, "ms");
    waitpid(host, nullptr, 0);
}

/// Through a second file of the same device, while the thread that serves the first one is stuck in a tick. The
/// device's own watchdog would take 100 ms.
void motorsAreCutWhileATickHangs() {
    DeviceRegistry registry;
    open_stylus_limits limits = Board::limits();
    limits.watchdog = 100;
    PluggedBoard board(limits);
    HangingClient client; // outlives the stylus, which calls it
    const auto stylus = made(registry);
    BURIN_EXPECT(stylus->open() && stylus->start(client));
    BURIN_EXPECT(comesTrue([&] { return board.force.load() > 0.9; }));
    client.hang = true;
    BURIN_EXPECT(comesTrue([&] { return client.held.load(); }));
    const int offs = board.offs;
    const auto cut = std::chrono::steady_clock::now();
    stylus->cutMotors();
    BURIN_EXPECT(comesTrue([&] { return board.offs >= offs + 1 && !board.motors.load(); }));
    const auto after = std::chrono::duration<double>(std::chrono::steady_clock::now() - cut).count();
    tellFigure("cut_to_motors_off_ms", 1e3 * after, "ms");
    client.hang = false;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() > 0.9; })); // armed again by itself
    BURIN_EXPECT(client.invalid > 0);
    stylus->stop();
}

std::uint64_t seen(const DeviceHealth& health) {
    return health.readings + health.damaged + health.repeated;
}

/// Waits until the driver has looked at so many reports, but never long: some may be lost.
void comesToSee(const StylusDevice& stylus, std::uint64_t reports) {
    for (int i = 0; i < 20 && seen(stylus.health()) < reports; ++i)
        std::this_thread::sleep_for(std::chrono::microseconds(50));
}

/// Reports of a hostile device through the kernel: random, damaged, whole with senseless values, of every size.
void hostileReportsDoNoHarm() {
    constexpr int count = 100000, batch = 32; // the kernel keeps 64 reports that nobody has read
    constexpr std::size_t inputSize = OPEN_STYLUS_INPUT_SIZE;
    DeviceRegistry registry;
    PluggedBoard board;
    Wall wall; // outlives the stylus, which calls it
    const auto stylus = made(registry);
    board.x = -25.0; // the wall answers 2.5 N; what it answers to readings that are not valid would be 1732 N
    BURIN_EXPECT(stylus->start(wall));
    BURIN_EXPECT(comesTrue([&] { return board.force.load() > 0.0; }));
    std::mt19937 random(29);
    Report report;
    std::uint64_t before = seen(stylus->health());
    const auto begun = std::chrono::steady_clock::now();
    for (int i = 0; i < count; ++i) {
        const unsigned kind = random() % 8;
        report.resize(kind == 0 ? 1 + random() % 64 : inputSize);
        for (auto& byte : report) byte = static_cast<std::uint8_t>(random());
        if (kind != 1) report[0] = OPEN_STYLUS_INPUT_ID;
        if (kind >= 6 && report.size() == inputSize) {
            for (std::size_t at = 20; at < 36; ++at) report[at] = 0;
            report[23] = 0x40;
            const std::uint16_t crc = open_stylus_crc(report.data(), 46);
            report[46] = static_cast<std::uint8_t>(crc & 0xffU);
            report[47] = static_cast<std::uint8_t>(crc >> 8U);
        }
        board.device().send(report);
        if (i % batch != batch - 1) continue;
        comesToSee(*stylus, before + batch);
        before = seen(stylus->health());
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    tellFigure("hostile_reports", count, "reports");
    tellFigure("hostile_us_per_report", 1e6 * seconds / count, "us");
    const DeviceHealth health = stylus->health();
    tellFigure("hostile_seen", static_cast<double>(seen(health)), "reports");
    BURIN_EXPECT(health.damaged > count / 2 && health.readings > count / 100);
    BURIN_EXPECT(board.largestForceSquared() <= mostForceSquared());
    BURIN_EXPECT(wall.timeRises);
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 2.5; })); // all is well again
}

void whoHasNoRightIsTold() {
    PluggedBoard board;
    {
        DeviceRegistry registry;
        BURIN_EXPECT(isThere(registry));
    }
    const pid_t user = started(userRole);
    int status = 0;
    waitpid(user, &status, 0);
    BURIN_EXPECT(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

void theWatchTellsOfPluggingInAndOut() {
    DeviceRegistry registry;
    std::mutex mutex;
    std::vector<std::string> heard;
    const auto has = [&](const std::string& change) {
        const std::lock_guard lock(mutex);
        return std::ranges::find(heard, change) != heard.end();
    };
    const DeviceWatch watch(
        registry,
        [&](const DeviceChange& change) {
            const std::lock_guard lock(mutex);
            heard.push_back((change.arrived ? "+" : "-") + change.device.id);
        },
        std::chrono::milliseconds(50));
    auto board = std::make_unique<PluggedBoard>();
    BURIN_EXPECT(comesTrue([&] { return has(std::string("+") + id); }));
    board.reset();
    BURIN_EXPECT(comesTrue([&] { return has(std::string("-") + id); }));
}

void anotherVersionIsRefused() {
    DeviceRegistry registry;
    Board source([](const Board::Report&) { return true; });
    Report feature = source.feature();
    feature[1] = 2;
    const UhidDevice device(identity(), {[](const Report&) {}, [&](std::uint8_t) { return feature; }});
    BURIN_EXPECT(isThere(registry));
    const auto refused = registry.make(id);
    BURIN_EXPECT(!refused && refused.error().code == ErrorCode::deviceIncompatible);
}

} // namespace

int runAs(const std::string& role) {
    if (role == userRole && (setgid(nobody) != 0 || setuid(nobody) != 0)) return 2;
    DeviceRegistry registry;
    if (role == userRole) {
        const auto refused = registry.make(id);
        const bool told = !refused && refused.error().code == ErrorCode::deviceNotAllowed;
        return told && refused.error().place.starts_with("/dev/hidraw") ? 0 : 1;
    }
    Wall wall;
    const auto stylus = made(registry);
    if (!stylus->start(wall)) return 1;
    for (;;) pause(); // until it is killed
}

std::vector<GuestCheck> openStylusChecks() {
    return {{"an open stylus tells its limits", tellsItsLimits},
            {"the hand at an open stylus feels the wall", theHandFeelsTheWall},
            {"an open stylus unplugged in mid stroke goes on when it is back", unpluggedInMidStroke},
            {"the watchdog cuts the motors of a host that died", theWatchdogCutsTheMotorsOfAHostThatDied},
            {"motors are cut while a tick hangs", motorsAreCutWhileATickHangs},
            {"an open stylus of another version is refused", anotherVersionIsRefused},
            {"who has no right to a device is told", whoHasNoRightIsTold},
            {"the watch tells of plugging in and out", theWatchTellsOfPluggingInAndOut},
            {"hostile reports do no harm", hostileReportsDoNoHarm}};
}

} // namespace burin::test
