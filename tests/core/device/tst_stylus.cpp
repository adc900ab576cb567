// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <set>
#include <thread>

namespace burin::tst_stylus {

namespace {

StylusDescription whole() {
    StylusDescription stylus;
    stylus.name = "whole";
    stylus.actuated = {3, 3};
    stylus.maximumForce = {3.0, "measured"};
    stylus.maximumTorque = {90.0, "measured"};
    stylus.maximumStiffness = {400.0, "measured"};
    stylus.workspaceRadius = {75.0, "measured"};
    return stylus;
}

using Change = void (*)(StylusDescription&);

} // namespace

class TestStylus : public QObject {
    Q_OBJECT
private slots:
    void aWholeDescriptionIsTaken() {
        QVERIFY(checkDescription(whole()));
        StylusDescription passive;
        passive.name = "mouse";
        passive.workspaceRadius = {10.0, "measured"};
        QVERIFY(checkDescription(passive));
        QVERIFY(!passive.hasMotors());
    }

    void figuresCarryTheirUnit() {
        QCOMPARE(decltype(StylusDescription::maximumForce)::unit, std::string_view("N"));
        QCOMPARE(decltype(StylusDescription::maximumDamping)::unit, std::string_view("N·s/m"));
        static_assert(
            !std::is_same_v<decltype(StylusDescription::maximumForce), decltype(StylusDescription::maximumTorque)>);
    }

    void aDescriptionThatBreaksARuleIsRefused_data() {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* name, const char* named, Change change) {
            QTest::newRow(name) << change << QString::fromLatin1(named);
        };
        row("no name", "name", [](StylusDescription& s) { s.name.clear(); });
        row("four translations", "degrees of freedom", [](StylusDescription& s) { s.sensed.translations = 4; });
        row("fewer than none", "degrees of freedom", [](StylusDescription& s) { s.actuated.rotations = -1; });
        row("33 buttons", "buttons", [](StylusDescription& s) { s.buttons = 33; });
        row("a force without source", "maximum force", [](StylusDescription& s) { s.maximumForce.source.clear(); });
        row("a force that is not finite", "maximum force",
            [](StylusDescription& s) { s.maximumForce.value = std::nan(""); });
        row("endless stiffness", "maximum stiffness",
            [](StylusDescription& s) { s.maximumStiffness.value = std::numeric_limits<double>::infinity(); });
        row("negative damping", "maximum damping", [](StylusDescription& s) { s.maximumDamping = {-1.0, "measured"}; });
        row("a rate without source", "rate", [](StylusDescription& s) { s.rate.value = 1000.0; });
        row("a delay without source", "delay", [](StylusDescription& s) { s.delay.value = 0.001; });
        row("a step without source", "position step", [](StylusDescription& s) { s.positionStep.value = 0.02; });
        row("a turn step without source", "rotation step", [](StylusDescription& s) { s.rotationStep.value = 1e-3; });
        row("no workspace", "workspace radius", [](StylusDescription& s) { s.workspaceRadius = {}; });
        row("no speed", "maximum speed", [](StylusDescription& s) { s.maximumSpeed = {}; });
        row("a mass that nobody states", "handle mass", [](StylusDescription& s) { s.handleMass.value = 0.05; });
        row("motors without force", "maximum force and stiffness", [](StylusDescription& s) { s.maximumForce = {}; });
        row("motors without stiffness", "maximum force and stiffness",
            [](StylusDescription& s) { s.maximumStiffness = {}; });
        row("turning motors without torque", "maximum torque", [](StylusDescription& s) { s.maximumTorque = {}; });
    }
    void aDescriptionThatBreaksARuleIsRefused() {
        QFETCH(Change, change);
        QFETCH(QString, named);
        StylusDescription description = whole();
        change(description);
        const Result<void> checked = checkDescription(description);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(QString::fromStdString(checked.error().place), named);
    }

    void eachFaultHasAMessageOfItsOwn() {
        std::set<std::string> told;
        for (std::size_t i = 0; i < deviceFaultCount; ++i) {
            const Error error = errorOf(static_cast<DeviceFault>(i), "mine");
            QCOMPARE(error.subject, std::string("mine"));
            QVERIFY(told.insert(std::to_string(static_cast<int>(error.code)) + error.detail).second);
        }
        QCOMPARE(errorOf(DeviceFault::unplugged, "mine").code, ErrorCode::deviceUnplugged);
    }

    void aFaultIsTakenOnce() {
        FaultBox box;
        QVERIFY(!box.take());
        box.raise(DeviceFault::stopped);
        box.raise(DeviceFault::unplugged);
        box.raise(DeviceFault::stopped);
        QVERIFY(box.take() == DeviceFault::unplugged);
        QVERIFY(box.take() == DeviceFault::stopped);
        QVERIFY(!box.take());
    }

    void noFaultIsLostBetweenThreads() {
        FaultBox box;
        std::atomic<bool> done{false};
        int taken = 0;
        std::thread device([&] {
            for (int i = 0; i < 20000; ++i) box.raise(DeviceFault::silent);
            box.raise(DeviceFault::mechanism);
            done = true;
        });
        bool mechanism = false;
        while (!done.load())
            while (const auto fault = box.take()) {
                ++taken;
                mechanism = mechanism || fault == DeviceFault::mechanism;
            }
        device.join();
        while (const auto fault = box.take()) mechanism = mechanism || fault == DeviceFault::mechanism;
        QVERIFY(mechanism);
        QVERIFY(taken <= 20001);
    }
};

BURIN_TEST(TestStylus, NoApplication)

} // namespace burin::tst_stylus

#include "tst_stylus.moc"
