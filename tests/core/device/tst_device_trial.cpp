// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_trial.h"
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/own_stylus.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_device_trial {

using namespace burin::test;

namespace {

/// A hand that moves back and forth by 0.5 mm per reading, and holds the button in the middle of the trial.
class MovedStylus final : public Stylus {
public:
    StylusDescription description() const override { return told; }
    Result<void> open() override {
        if (refuses) return errorOf(DeviceFault::notCalibrated, "desktop");
        ++opened;
        return {};
    }
    void close() noexcept override { ++closed; }
    std::optional<Error> takeFault() override { return std::exchange(fault, std::nullopt); }
    StylusState read(double time) noexcept override {
        StylusState state;
        state.time = time;
        state.pose.position = {0.5 * (readings % 100), -3.0, 7.0};
        state.valid = ++readings % 10 != 0;
        state.buttons = time > 0.2 && time < 0.8 ? 5U : 0U;
        held = state.valid && state.buttons != 0;
        return state;
    }
    void write(const Wrench& wrench) noexcept override {
        forces.push_back(wrench.force);
        assists.push_back(wrench.assist);
        if (!held && (wrench.force != glm::dvec3(0.0) || wrench.assist.ceiling > 0.0)) pushedUnheld = true;
    }

    StylusDescription told = desktopStylus();
    std::optional<Error> fault;
    std::vector<glm::dvec3> forces;
    std::vector<Assist> assists;
    bool refuses = false, held = false, pushedUnheld = false;
    int opened = 0, closed = 0, readings = 0;
};

} // namespace

class TestDeviceTrial : public QObject {
    Q_OBJECT
private slots:
    void aStylusThatTheLoopCallsIsMeasured() {
        MovedStylus stylus;
        stylus.told.buttons = 3;
        stylus.fault = errorOf(DeviceFault::overheated, "desktop");
        Progress progress;
        TrialSettings settings;
        settings.seconds = 1.0;
        int told = 0;
        settings.report = [&](const TrialFigures&) { ++told; };
        const Result<TrialFigures> figures = tryDevice(StylusHandle(stylus), settings, progress);
        QVERIFY(figures);
        // One interval less than readings; no reading is requested too early, however high the machine's load.
        QVERIFY(std::abs(figures->rate * figures->seconds - (stylus.readings - 1)) < 1e-6);
        QVERIFY2(figures->rate < 1010.0, qPrintable(QString::number(figures->rate)));
        QVERIFY(figures->medianInterval > 0.0 && figures->medianInterval <= figures->maximumInterval + 1e-5);
        QCOMPARE(static_cast<int>(figures->readings + figures->invalid), stylus.readings);
        QCOMPARE(static_cast<int>(figures->invalid), stylus.readings / 10);
        QCOMPARE(figures->lowest, glm::dvec3(0.0, -3.0, 7.0));
        QVERIFY(figures->highest.x <= 49.5 && figures->highest.x > 48.0);
        QCOMPARE(figures->smallestStep, 0.5);
        QCOMPARE(figures->buttons, 5U);
        QCOMPARE(figures->maximumForce, 0.0);
        QCOMPARE(figures->faults.size(), std::size_t{1});
        QVERIFY(told >= 5);
        QVERIFY(stylus.opened == 1 && stylus.closed == 1);
        for (const glm::dvec3& force : stylus.forces) QCOMPARE(force, glm::dvec3(0.0));
    }

    void theForceIsThereOnlyWhileTheButtonIsHeldAndFadesIn() {
        MovedStylus stylus;
        stylus.told.buttons = 3;
        Progress progress;
        TrialSettings settings;
        settings.seconds = 1.2;
        settings.force = 0.8; // a fifth of 4 N
        const Result<TrialFigures> figures = tryDevice(StylusHandle(stylus), settings, progress);
        QVERIFY(figures);
        QVERIFY(!stylus.pushedUnheld);
        double before = 0.0;
        for (const glm::dvec3& force : stylus.forces) {
            QVERIFY(force.x == 0.0 && force.y == 0.0 && force.z >= 0.0 && force.z <= 0.6 * 0.8 + 0.05);
            // A pause of the machine causes a longer step; otherwise the step is a thousandth per reading.
            QVERIFY(force.z - before <= 0.8 * (figures->maximumInterval + 0.002));
            before = force.z;
        }
        QCOMPARE(stylus.forces.back(), glm::dvec3(0.0));
    }

    void aDeviceThatAssistsIsTestedWhileTheButtonIsHeld() {
        MovedStylus stylus;
        stylus.told.buttons = 1;
        stylus.told.actuated = {};
        stylus.told.assist.forceAxes = 2;
        Progress progress;
        TrialSettings settings;
        settings.seconds = 1.2;
        settings.assist = 0.5;
        const Result<TrialFigures> figures = tryDevice(StylusHandle(stylus), settings, progress);
        QVERIFY(figures && !stylus.pushedUnheld);
        double most = 0.0;
        for (const Assist& assist : stylus.assists) most = std::max(most, assist.force.x);
        // A gap at every tenth reading lets the strength rise anew; otherwise it would reach 0.3 in the 0.6 s.
        QCOMPARE(figures->maximumAssist, most);
        QVERIFY(most > 0.0 && most <= 0.5 * (0.6 + figures->maximumInterval));
        for (const double refused : {-0.1, 1.1, std::nan("")}) {
            settings.assist = refused;
            QCOMPARE(tryDevice(StylusHandle(stylus), settings, progress).error().code, ErrorCode::argumentInvalid);
        }
        stylus.told.assist.permitted = false;
        settings.assist = 0.1;
        QCOMPARE(tryDevice(StylusHandle(stylus), settings, progress).error().code, ErrorCode::argumentInvalid);
    }

    void theEffectsOfATrialTakeTurns() {
        const auto at = [](double seconds) { return trialAssist(seconds, 0.8); };
        QCOMPARE(at(0.0).force, glm::dvec3(0.0));
        QCOMPARE(at(0.5).force, glm::dvec3(0.4, 0.0, 0.0));
        QCOMPARE(at(1.25).force, glm::dvec3(0.0, 0.2, 0.0));
        QCOMPARE(at(2.5).force, glm::dvec3(-0.4, 0.0, 0.0));
        QCOMPARE(at(3.5).force, glm::dvec3(0.0, -0.4, 0.0));
        QCOMPARE(at(4.5).force, glm::dvec3(0.4, 0.0, 0.0));
        QVERIFY(at(0.5).contact == 0.4 && at(0.5).load == 0.0);
        QVERIFY(at(1.5).contact == 0.0 && at(1.5).load == 0.4);
        QCOMPARE(at(7.75).ceiling, 0.8);
        QVERIFY(glm::length(at(1e9 + 0.5).force) <= 0.8);
    }

    void aForceThatItMayNotHaveIsRefused_data() {
        QTest::addColumn<double>("force");
        QTest::addColumn<int>("buttons");
        QTest::addColumn<int>("axes");
        QTest::newRow("too much") << 0.81 << 1 << 3;
        QTest::newRow("below nothing") << -0.1 << 1 << 3;
        QTest::newRow("no number") << std::nan("") << 1 << 3;
        QTest::newRow("nothing to hold") << 0.5 << 0 << 3;
        QTest::newRow("no motors") << 0.5 << 1 << 0;
    }
    void aForceThatItMayNotHaveIsRefused() {
        QFETCH(double, force);
        QFETCH(int, buttons);
        QFETCH(int, axes);
        MovedStylus stylus;
        stylus.told.buttons = buttons;
        stylus.told.actuated = {axes, 0};
        Progress progress;
        TrialSettings settings;
        settings.force = force;
        const Result<TrialFigures> figures = tryDevice(StylusHandle(stylus), settings, progress);
        QVERIFY(!figures);
        QCOMPARE(figures.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(stylus.opened, 0);
    }

    void theContinuousForceIsALimitToo() {
        StylusDescription stylus = desktopStylus();
        QCOMPARE(trialForceLimit(stylus), 0.8);
        stylus.continuousForce = {0.3, "made up"};
        QCOMPARE(trialForceLimit(stylus), 0.3);
    }

    void aStylusWithItsOwnClockIsMeasured() {
        StylusDescription description = desktopStylus();
        description.rate = {250.0, "made up"};
        OwnStylus stylus(description, [](double time, int reading) {
            StylusState state;
            state.time = time;
            state.pose.position.z = 0.25 * (reading % 2);
            state.pose.rotation = glm::angleAxis(0.1 * std::min(reading, 5), glm::dvec3(0, 0, 1));
            state.valid = true;
            return state;
        });
        Progress progress;
        TrialSettings settings;
        settings.seconds = 1.0;
        const Result<TrialFigures> figures = tryDevice(StylusHandle(stylus), settings, progress);
        QVERIFY(figures);
        QVERIFY2(figures->rate > 0.0 && figures->rate < 255.0, qPrintable(QString::number(figures->rate)));
        QCOMPARE(figures->smallestStep, 0.25);
        QVERIFY(std::abs(figures->maximumRotation - 0.5) < 1e-9);
    }

    void itCanBeCancelledAndRefused() {
        MovedStylus stylus;
        Progress progress;
        TrialSettings settings;
        settings.seconds = 3600.0;
        settings.report = [&](const TrialFigures&) { progress.cancel(); };
        QCOMPARE(tryDevice(StylusHandle(stylus), settings, progress).error().code, ErrorCode::cancelled);
        QCOMPARE(stylus.closed, 1);
        stylus.refuses = true;
        Progress again;
        settings.report = {};
        QVERIFY(!tryDevice(StylusHandle(stylus), settings, again));
        settings.seconds = 0.0;
        QCOMPARE(tryDevice(StylusHandle(stylus), settings, again).error().code, ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestDeviceTrial, QCoreApplication)

} // namespace burin::tst_device_trial

#include "tst_device_trial.moc"
