// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_watch.h"
#include "tests/hid/guest.h"
#include "tests/hid/plugged_board.h"
#include "tests/plugins/comes_true.h"

#include <algorithm>

#include <sys/wait.h>
#include <unistd.h>

namespace burin::test {
namespace {

constexpr uid_t nobody = 65534;
constexpr const char* hostRole = "host";
constexpr const char* userRole = "user";
constexpr auto id = openStylusId;

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
    const StylusDescription description = madeOpenStylus(registry)->description();
    BURIN_EXPECT(description.name == "Open Stylus mine");
    BURIN_EXPECT(description.maximumForce.value == 3.0 && description.maximumStiffness.value == 400.0);
    BURIN_EXPECT(description.rate.value == 1000.0 && description.actuated.rotations == 3);
}

void theHandFeelsTheWall() {
    DeviceRegistry registry;
    PluggedBoard board;
    Wall wall; // outlives the stylus, which calls it
    const auto stylus = madeOpenStylus(registry);
    BURIN_EXPECT(stylus->open() && stylus->start(wall));
    board.x = -10.0;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 1.0; }));
    board.x = 3.0;
    BURIN_EXPECT(comesTrue([&] { return board.force.load() == 0.0; }));
    board.takeRoundTrips();
    std::vector<double> trips;
    BURIN_EXPECT(comesTrue([&] {
        for (const double trip : board.takeRoundTrips()) trips.push_back(trip);
        return trips.size() >= 2000;
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
    const auto stylus = madeOpenStylus(registry);
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

/// Starts this program again, in a process of its own.
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

/// Switches the motors off through a second file of the same device, while the thread that serves the first one hangs
/// in a tick. The device's own watchdog would take 100 ms.
void motorsAreCutWhileATickHangs() {
    DeviceRegistry registry;
    open_stylus_limits limits = Board::limits();
    limits.watchdog = 100;
    PluggedBoard board(limits);
    HangingClient client; // outlives the stylus, which calls it
    const auto stylus = madeOpenStylus(registry);
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
    BURIN_EXPECT(comesTrue([&] { return board.force.load() > 0.9; })); // armed again automatically
    BURIN_EXPECT(client.invalid > 0);
    stylus->stop();
}

void whoHasNoRightIsTold() {
    PluggedBoard board;
    {
        DeviceRegistry registry;
        BURIN_EXPECT(openStylusIsThere(registry));
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
    const UhidDevice device(openStylusIdentity(), {[](const Report&) {}, [&](std::uint8_t) { return feature; }});
    BURIN_EXPECT(openStylusIsThere(registry));
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
    const auto stylus = madeOpenStylus(registry);
    if (!stylus->start(wall)) return 1;
    for (;;) pause(); // until it is killed
}

std::vector<GuestCheck> roundTripChecks() {
    return {{"the hand at an open stylus feels the wall", theHandFeelsTheWall}};
}

std::vector<GuestCheck> openStylusChecks() {
    return {{"an open stylus tells its limits", tellsItsLimits},
            roundTripChecks().front(),
            {"an open stylus unplugged in mid stroke goes on when it is back", unpluggedInMidStroke},
            {"the watchdog cuts the motors of a host that died", theWatchdogCutsTheMotorsOfAHostThatDied},
            {"motors are cut while a tick hangs", motorsAreCutWhileATickHangs},
            {"an open stylus of another version is refused", anotherVersionIsRefused},
            {"who has no right to a device is told", whoHasNoRightIsTold},
            {"the watch tells of plugging in and out", theWatchTellsOfPluggingInAndOut}};
}

} // namespace burin::test
