// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/simulated_stylus.h"
#include "plugins/devices/open_stylus/driver.h"
#include "plugins/devices/spacemouse/driver.h"
#include "tests/core/haptics/replayed_session.h"
#include "tests/plugins/board_on_bus.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_replayed_devices {

using namespace burin::test;

namespace {

constexpr double seconds = 1.2;

HapticSettings settingsFor(const StylusDescription& stylus) {
    HapticSettings settings;
    settings.stylus = stylus;
    settings.rampSeconds = 0.05;
    settings.mapping.origin = {0.0, 0.0, 5.0}; // above the stock
    return settings;
}

/// Calls `moves` alongside a session, with the time since its start, until it is destroyed.
class Mover {
public:
    explicit Mover(std::function<void(double time)> moves)
        : thread_([moves = std::move(moves)](const std::stop_token& stop) {
            const auto start = std::chrono::steady_clock::now();
            while (!stop.stop_requested()) {
                moves(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }) {}

private:
    std::jthread thread_;
};

/// Moves down through the stock onto the part below it, and in a circle.
glm::dvec3 stroke(double time) {
    const double depth = std::min(60.0 * std::max(0.0, time - 0.05), 17.0);
    return {6.0 * std::sin(8.0 * time), 6.0 * (1.0 - std::cos(8.0 * time)), -depth};
}

struct Session {
    explicit Session(const QTemporaryDir& folder) : file(folder.filePath("trace.csv").toStdString()) {}
    void run(const StylusHandle& stylus) {
        settings = settingsFor(stylus.device().description());
        original = recordSession(stylus, settings, file, seconds);
        difference = differenceOf(original, replaySession(settings, file));
        events = eventsOf(original.samples);
    }
    std::filesystem::path file;
    HapticSettings settings;
    RecordedSession original;
    std::string difference;
    SessionEvents events;
};

} // namespace

/// A session with each supported device, during which guides, levels, allowance, workspace, clutch, spindle, takes and
/// layers change, is reproduced from its trace to the bit: pose, force, removed volume.
class TestReplayedDevices : public QObject {
    Q_OBJECT
private slots:
    void theOpenStylus() {
        auto owned = std::make_unique<ScriptedBus>();
        PluggedBoard board(*owned);
        const auto driver = openstylus::makeDriver(std::move(owned));
        auto made = driver->make("1209:0001:0001", {});
        QVERIFY(made);
        QTemporaryDir folder;
        Session session(folder);
        {
            const Mover mover([&](double time) {
                const glm::dvec3 place = stroke(time);
                board.x = place.x;
                board.y = place.y;
                board.z = place.z;
                board.heat = time > 0.8 && time < 0.9 ? 190 : 100;
                board.buttons = time > 0.3 && time < 0.4 ? 4U : 0U;
            });
            session.run(*made);
        }
        QVERIFY2(session.difference.empty(), session.difference.c_str());
        QVERIFY(session.events.cut > 50 && session.events.held > 20 && session.events.guided > 20);
        QVERIFY(session.events.felt > 20);
        QVERIFY(std::ranges::any_of(session.original.samples,
                                    [](const Sample& sample) { return (sample.flags & sampleMotorsHot) != 0; }));
    }

    void aSpaceMouse_data() {
        QTest::addColumn<QString>("mode");
        QTest::newRow("rate") << "rate";
        QTest::newRow("position") << "position";
    }
    void aSpaceMouse() {
        QFETCH(QString, mode);
        hid::DeviceInfo info;
        info.vendor = 0x256f;
        info.product = 0xc62e;
        info.usagePage = 1;
        info.usage = 8;
        auto owned = std::make_unique<ScriptedBus>();
        const std::shared_ptr<Wire> wire = owned->plug(info);
        const auto driver = spacemouse::makeDriver(std::move(owned));
        auto made = driver->make("256f:c62e", mode.toStdString());
        QVERIFY(made);
        auto& stylus = *std::get<std::unique_ptr<Stylus>>(*made);
        QVERIFY(stylus.open());
        QTemporaryDir folder;
        Session session(folder);
        {
            // The cap's frame has y towards the user and z down: it is pressed down first, then pushed in a circle.
            const Mover mover([&, sent = -1](double time) mutable {
                const int due = static_cast<int>(time * 62.5);
                if (due == sent) return;
                sent = due;
                const auto counts = [](double share) { return static_cast<std::int16_t>(350.0 * share); };
                const std::int16_t axes[] = {counts(0.7 * std::sin(9.0 * time)),
                                             counts(0.7 * std::cos(9.0 * time)),
                                             counts(time < 0.6 ? 0.9 : 0.55),
                                             counts(0.3 * std::sin(5.0 * time)),
                                             counts(0.2),
                                             counts(-0.2)};
                Wire::Report report{0x01};
                for (const std::int16_t axis : axes) {
                    const auto bits = static_cast<std::uint16_t>(axis);
                    report.push_back(static_cast<std::uint8_t>(bits & 0xffU));
                    report.push_back(static_cast<std::uint8_t>(bits >> 8U));
                }
                wire->send(report);
                if (due % 20 == 10) wire->send({0x03, static_cast<std::uint8_t>(due % 40 == 10 ? 1 : 0), 0x00});
            });
            session.run(stylus);
        }
        stylus.close();
        QVERIFY2(session.difference.empty(), session.difference.c_str());
        QVERIFY2(session.events.cut > 50 && session.events.held > 20 && session.events.guided > 20,
                 qPrintable(
                     QString("%1 %2 %3").arg(session.events.cut).arg(session.events.held).arg(session.events.guided)));
        QCOMPARE(session.events.felt, 0); // it has no motors
    }

    void theSimulatedStylus() {
        SimulatedStylus stylus({0.0, 0.0, 0.2}); // it follows the whole stroke, from where the spindle turns
        QVERIFY(stylus.open());
        QTemporaryDir folder;
        Session session(folder);
        {
            const Mover mover([&](double time) {
                StylusTarget target;
                target.tip = stroke(time);
                target.cutting = true;
                target.clearHeight = 0.0;
                stylus.request(target);
            });
            session.run(stylus);
        }
        QVERIFY2(session.difference.empty(), session.difference.c_str());
        QVERIFY2(session.events.cut > 50 && session.events.held > 20 && session.events.guided > 20,
                 qPrintable(
                     QString("%1 %2 %3").arg(session.events.cut).arg(session.events.held).arg(session.events.guided)));
    }
};

BURIN_TEST(TestReplayedDevices, QCoreApplication)

} // namespace burin::tst_replayed_devices

#include "tst_replayed_devices.moc"
