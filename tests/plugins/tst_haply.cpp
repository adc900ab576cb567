// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/stylus_handle.h"
#include "plugins/devices/haply/driver.h"
#include "plugins/devices/haply/inventory.h"
#include "plugins/devices/haply/inverse_stylus.h"
#include "plugins/devices/haply/messages.h"
#include "plugins/devices/haply/state_scanner.h"
#include "tests/oracles/allocation_count.h"
#include "tests/plugins/inverse_service.h"
#include "tests/plugins/through_driver.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_haply {

using namespace burin::test;
using burin::haply::ForceKey;
using burin::haply::ForceMessage;
using burin::haply::InverseStylus;
using burin::haply::scanState;
using burin::haply::ServiceState;
using burin::testing::InverseArm;
using burin::testing::InverseService;

namespace {

class Client final : public StylusClient {
public:
    Wrench tick(const StylusState& given) noexcept override {
        const std::lock_guard lock(mutex);
        state = given;
        valid += given.valid ? 1 : 0;
        ++ticks;
        return answer;
    }
    StylusState seen() {
        const std::lock_guard lock(mutex);
        return state;
    }
    std::mutex mutex;
    StylusState state;
    Wrench answer;
    std::atomic<int> ticks{0}, valid{0};
};

std::unique_ptr<SelfPacedStylus> connectTo(const InverseService& service) {
    qputenv("HAPLY_INVERSE_SERVICE", service.address());
    auto made = haply::makeDriver()->make("04BA", {});
    if (!made) return nullptr;
    return std::move(std::get<std::unique_ptr<SelfPacedStylus>>(*made));
}

/// Whether a fault was reported; the fault is kept.
bool heard(StylusDevice& stylus, std::optional<Error>& fault) {
    if (!fault) fault = stylus.takeFault();
    return fault.has_value();
}

glm::dvec3 forceOf(InverseService& service) {
    const std::lock_guard lock(service.mutex);
    return {service.arm.force[0], service.arm.force[1], service.arm.force[2]};
}

} // namespace

/// The driver for Haply's Inverse3, over a real WebSocket to a stand-in for Haply's service. No real device was
/// available.
class TestHaply : public QObject {
    Q_OBJECT
private slots:
    void messagesAreScannedAsAParserReadsThem() {
        QVERIFY(rc::check([] {
            const auto number = [] { return *rc::gen::inRange(-1'000'000, 1'000'000) / 4096.0; };
            const double x = number(), y = number(), z = number(), w = number();
            const int button = *rc::gen::inRange(0, 3);
            nlohmann::json told;
            told["extra"] = {{"deep", {1, 2, {{"a", "b\"c"}}}}, {"text", "x\\\"y"}};
            nlohmann::json arm{{"device_id", "arm \"1\""},
                               {"config", {{"preset", "x"}}},
                               {"state", {{"cursor_position", {{"z", z}, {"y", y}, {"x", x}}}}}};
            nlohmann::json grip{{"state",
                                 {{"orientation", {{"w", w}, {"x", x}, {"y", y}, {"z", z}}},
                                  {"buttons", {{"a", button == 0}, {"b", button == 1}, {"c", button == 2}}}}}};
            told["inverse3"] = {
                {{"device_id", "other"}, {"state", {{"cursor_position", {{"x", 1}, {"y", 1}, {"z", 1}}}}}}, arm};
            told["verse_grip"] = {grip};
            const std::string text = told.dump(*rc::gen::inRange(-1, 3));
            // The ID as in the text, including escapes.
            const auto said = scanState(text, R"(arm \"1\")");
            RC_ASSERT(said.has_value());
            RC_ASSERT(said->cursor == glm::dvec3(x, y, z));
            RC_ASSERT(said->grip->w == w && said->grip->z == z);
            RC_ASSERT(said->buttons == 1U << static_cast<unsigned>(button));
            const std::size_t cut = *rc::gen::inRange<std::size_t>(0, text.size());
            RC_ASSERT(!scanState(std::string_view(text).substr(0, cut), "other"));
        }));
    }

    void nonsenseIsNoMessage() {
        for (const char* text : {"", "[]", "5", "{", "{\"a\"}", "{\"a\":}", "{\"a\":tru}", "{\"a\":1,}", "{\"a\":\"",
                                 "{a:1}", "{\"a\":[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]}"})
            QVERIFY2(!scanState(text, "x"), text);
        const auto none = scanState("{}", "x");
        QVERIFY(none && !none->cursor && !none->grip);
        const auto half = scanState(R"({"inverse3":[{"device_id":"x","state":{"cursor_position":{"x":1}}}]})", "x");
        QVERIFY(half && half->cursor && !isFinite(*half->cursor)); // not a valid reading
        QVERIFY(haply::armsOf("nonsense").empty() && haply::armsOf("{\"inverse3\":[1,{\"device_id\":2}]}").empty());
        QCOMPARE(haply::armsOf(R"({"inverse3":[{"device_id":"a"},{"device_id":"b"}]})").size(), std::size_t{2});
    }

    void aTickAllocatesNothing() {
        ForceMessage message("04BA");
        const std::string state =
            R"({"inverse3":[{"device_id":"04BA","state":{"cursor_position":{"x":1,"y":2,"z":3}}}]})";
        const std::size_t before = allocationCount.load();
        std::size_t length = 0;
        for (int i = 0; i < 100; ++i) {
            length += message.write({0.1 * i, -3.25, 1e-9}, i % 2 == 0 ? ForceKey::vector : ForceKey::values).size();
            length += scanState(state, "04BA")->cursor ? 1U : 0U;
        }
        QCOMPARE(allocationCount.load(), before);
        QVERIFY(length > 1000);
        // Whatever force is requested, the message stays valid.
        const std::string longId(3000, '"');
        ForceMessage longest(longId);
        for (const glm::dvec3& force : {glm::dvec3(NAN, 1e300, -1e300), glm::dvec3(INFINITY)}) {
            const auto sent = nlohmann::json::parse(longest.write(force, ForceKey::values));
            QCOMPARE(sent["inverse3"][0]["device_id"].get<std::string>(), longId);
            for (const auto& component : sent["inverse3"][0]["commands"]["set_cursor_force"]["values"])
                QVERIFY(std::abs(component.get<double>()) <= ForceMessage::largest);
        }
        QCOMPARE(message.write({1.0, -2.5, 0.0}, ForceKey::vector),
                 std::string_view(R"({"inverse3":[{"device_id":"04BA","commands":{"set_cursor_force":{"vector":)"
                                  R"({"x":1.00000,"y":-2.50000,"z":0.00000}}}}]})"));
    }

    void devicesAreThoseOfTheService() {
        qputenv("HAPLY_INVERSE_SERVICE", "127.0.0.1:1"); // no service there
        const auto alone = haply::makeDriver();
        QVERIFY(alone->find().empty());
        QCOMPARE(alone->make("04BA", {}).error().code, ErrorCode::deviceNotFound);
        InverseService service;
        qputenv("HAPLY_INVERSE_SERVICE", service.address());
        const auto driver = haply::makeDriver();
        const auto found = driver->find();
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].id, std::string("04BA"));
        const int connections = service.connections;
        for (int i = 0; i < 5; ++i) QCOMPARE(driver->find().size(), std::size_t{2});
        QCOMPARE(service.connections.load(), connections); // not for each enumeration
        QCOMPARE(driver->make("none", {}).error().code, ErrorCode::deviceNotFound);
    }

    void somebodyWhoDoesNotAnswerIsLeftAlone() {
        InverseService service;
        service.deafToHello = true;
        qputenv("HAPLY_INVERSE_SERVICE", service.address());
        QElapsedTimer timer;
        timer.start();
        QVERIFY(haply::makeDriver()->find().empty());
        QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
        service.deafToHello = false;
    }

    void posesButtonsAndForcesAreOurs() {
        InverseService service;
        const auto pen = connectTo(service);
        QVERIFY(pen != nullptr);
        QVERIFY(checkDescription(pen->description()));
        QCOMPARE(pen->description().sensed.rotations, 3);
        Client client;
        client.answer.force = {0.5, -1.0, 1.5};
        QVERIFY(pen->start(client));
        {
            const std::lock_guard lock(service.mutex);
            service.arm.cursor = {0.010, -0.13, 0.195};
            service.arm.b = true;
            service.arm.grip = {std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0};
        }
        QTRY_VERIFY(client.seen().buttons == 2U);
        const StylusState state = client.seen();
        QVERIFY(state.valid);
        QVERIFY(glm::distance(state.pose.position, glm::dvec3(10.0, 20.0, -5.0)) < 1e-9); // from where it was connected
        QVERIFY(glm::distance(toolPose(state.pose).axis, glm::dvec3(0, -1, 0)) < 1e-9);
        QTRY_COMPARE(forceOf(service), glm::dvec3(0.5, -1.0, 1.5));
        QTRY_COMPARE(pen->health().batteryShare.value_or(0.0), 0.75);
        QElapsedTimer timer;
        timer.start();
        const int ticks = client.ticks;
        QTest::qWait(500);
        const int further = client.ticks - ticks;
        const double rate = further / (1e-9 * static_cast<double>(timer.nsecsElapsed()));
        QVERIFY2(rate < 1050.0, qPrintable(QString::number(rate))); // however the machine is loaded
        pen->stop();
        QTRY_COMPARE(forceOf(service), glm::dvec3(0.0));         // the last message may still be in transit
        QTRY_COMPARE(service.messages.load(), client.valid + 1); // one per reading, and the one without force
    }

    void bothNamesOfAForceAreSpoken() {
        for (const InverseService::Key key : {InverseService::Key::vector, InverseService::Key::values}) {
            InverseService service;
            service.key = key;
            const auto pen = connectTo(service);
            Client client;
            client.answer.force = {0.0, 0.0, 1.0};
            QVERIFY(pen->start(client));
            QTRY_COMPARE(forceOf(service).z, 1.0);
            QTest::qWait(100);
            QCOMPARE(forceOf(service).z, 1.0); // and it stays at that
            QVERIFY(!pen->takeFault());
        }
        InverseService service;
        service.key = InverseService::Key::none;
        const auto pen = connectTo(service);
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        QVERIFY(pen->start(client));
        std::optional<Error> fault;
        QTRY_VERIFY(heard(*pen, fault));
        QCOMPARE(fault->detail, std::string(deviceReasons[static_cast<std::size_t>(DeviceFault::deaf)].text));
    }

    void aServiceThatIsLateOrSilentTakesTheForceAway() {
        InverseService service;
        const auto pen = connectTo(service);
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        QVERIFY(pen->start(client));
        QTRY_VERIFY(client.valid > 20);
        service.mute = true;
        QTRY_VERIFY(!client.seen().valid);
        std::optional<Error> fault;
        QTRY_VERIFY(heard(*pen, fault));
        QCOMPARE(fault->detail, std::string(deviceReasons[static_cast<std::size_t>(DeviceFault::silent)].text));
        service.mute = false;
        QTRY_VERIFY(client.seen().valid);
        fault.reset();
        service.garbage = true;
        QTRY_VERIFY(heard(*pen, fault));
        QTRY_VERIFY(!client.seen().valid);
        service.garbage = false;
        QTRY_VERIFY(client.seen().valid);
        {
            const std::lock_guard lock(service.mutex);
            service.arm.calibrated = false;
        }
        QTRY_VERIFY(!client.seen().valid);
    }

    void aBrokenConnectionIsMadeAgain() {
        InverseService service;
        const auto pen = connectTo(service);
        Client client;
        client.answer.force = {0.0, 0.0, 1.0};
        QVERIFY(pen->start(client));
        QTRY_COMPARE(forceOf(service).z, 1.0);
        service.drop();
        QTRY_COMPARE(forceOf(service).z, 0.0);
        std::optional<Error> fault;
        QTRY_VERIFY(heard(*pen, fault));
        QCOMPARE(fault->code, ErrorCode::deviceUnplugged);
        QTRY_COMPARE(forceOf(service).z, 1.0);
        QVERIFY(pen->health().connected);
        // The loop's watchdog interrupts it as well, from another thread.
        std::thread([&] { pen->cutMotors(); }).join();
        QTRY_COMPARE(forceOf(service).z, 0.0);
        QTRY_COMPARE(forceOf(service).z, 1.0);
    }

    void aContactGivesNoEnergy() {
        const StylusDescription told = InverseStylus("04BA", nullptr, ServiceState{}).description();
        for (const SimulatedGrip& grip : {lightGrip, middleGrip, firmGrip}) {
            HapticSettings settings;
            settings.stylus = told;
            settings.rampSeconds = 0.0;
            Rig rig(settings, ballTool(), stockOnPart(0, false));
            StepClient client(rig.step);
            SimulatedMechanism mechanism;
            mechanism.mass = 0.15; // kg: an estimate, as Haply states none
            mechanism.encoder = 0.02;
            mechanism.delay = 1; // the message in transit
            ForceMessage message("04BA");
            double most = 0.0;
            // The felt force is the one that was sent: its text, read by another parser.
            const double energy = energyPerContact(grip, mechanism, [&](const glm::dvec3& reading, std::uint32_t) {
                StylusState state;
                state.pose.position = reading;
                state.valid = true;
                const auto sent = nlohmann::json::parse(message.write(client.tick(state).force, ForceKey::vector));
                const auto& force = sent["inverse3"][0]["commands"]["set_cursor_force"]["vector"];
                const glm::dvec3 felt(force["x"], force["y"], force["z"]);
                most = std::max(most, felt.z);
                return felt;
            });
            qInfo("%.4f mJ a contact, at most %.2f N", 1e3 * energy, most);
            QVERIFY2(1e3 * energy <= 0.02, qPrintable(QString::number(1e3 * energy)));
            QVERIFY(most > 0.1);
        }
    }

    void aSessionComesOutOfItsTrace() {
        InverseService service;
        const auto pen = connectTo(service);
        const QString said = sessionThroughDriver(*pen, [&](const glm::dvec3& place) {
            const std::lock_guard lock(service.mutex);
            service.arm.cursor = {0.001 * place.x, -0.15 + 0.001 * place.y, 0.2 + 0.001 * place.z};
        });
        QVERIFY2(said.isEmpty(), qPrintable(said));
    }
};

BURIN_TEST(TestHaply, QCoreApplication)

} // namespace burin::tst_haply

#include "tst_haply.moc"
