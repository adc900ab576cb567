// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/simulated_stylus.h"
#include "core/haptics/trace/session_trace.h"
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/milling.h"
#include "tests/core/haptics/own_stylus.h"
#include "tests/core/job/session_stage.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace burin::tst_device_session {

using namespace burin::test;

namespace {

/// A self-paced device, held by a hand that mills circles in the block with its button down.
struct Device {
    OwnStylus stylus{description(), [this](double time, int) { return reading(time); },
                     [this](const Wrench& wrench) { force = glm::length(wrench.force); }, [this] { ++cuts; }};
    std::atomic<bool> unplugged{false};
    std::atomic<double> heat{0.0}; ///< of its motors
    std::atomic<double> hang{0.0}; ///< s, duration of the next reading
    std::atomic<double> force{0.0};
    std::atomic<int> cuts{0};

    static StylusDescription description() {
        StylusDescription description = desktopStylus();
        description.name = "pacer";
        description.buttons = 1;
        description.rate = {500.0, "made up"};
        return description;
    }
    void unplug() {
        unplugged = true;
        stylus.faults.raise(DeviceFault::unplugged);
    }

private:
    StylusState reading(double time) {
        if (const double seconds = hang.exchange(0.0); seconds > 0.0)
            std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        StylusState state;
        state.time = time;
        state.pose.position = {0.5 * side + 6.0 * std::cos(6.0 * time), 0.5 * side + 6.0 * std::sin(6.0 * time),
                               top - 1.0};
        state.buttons = 1;
        state.valid = !unplugged;
        state.motorHeat = heat;
        return state;
    }
};

SessionRequest liveRequest() {
    SessionRequest request = handRequest();
    request.takeName = "take";
    return request;
}

struct Live {
    explicit Live(const QTemporaryDir& folder, SessionRequest request = liveRequest())
        : stage(folder.filePath("p.burin").toStdString()) {
        auto begun = MillingSession::begin(stage.project, stage.milling, ToolBounds::borrowing(*stage.field),
                                           device.stylus, stage.strokes, request);
        if (begun) session = std::move(*begun);
    }
    bool sees(const std::function<bool()>& holds) {
        return await([&] { return session->newest(state), holds(); });
    }
    std::optional<Error> fault() {
        std::optional<Error> found;
        await([&] { return (found = session->takeFault()).has_value(); });
        return found;
    }
    Device device;
    Stage stage;
    std::unique_ptr<MillingSession> session;
    SessionState state;
};

} // namespace

/// A session with a self-paced device: milling, figures, faults, traces.
class TestDeviceSession : public QObject {
    Q_OBJECT
private slots:
    void itMillsAtTheDevicesOwnRate() {
        QTemporaryDir folder;
        Live live(folder);
        QVERIFY(live.session);
        QVERIFY(live.sees([&] { return live.state.ticks > 300 && live.state.rateHz > 0.0; }));
        QVERIFY(live.state.intervalP999 >= 2000.0 / 1.05); // µs: 500 Hz, and never faster
        QVERIFY(live.state.cutting);
        QVERIFY(live.session->health().connected);
        const auto statistics = live.session->end();
        QVERIFY(statistics);
        const Take take = *live.stage.project.take(live.session->take());
        QCOMPARE(take.info.tickPeriod, 0.002);
        QCOMPARE(take.info.stylus, std::string("pacer"));
        QVERIFY(contiguous(take));
        QVERIFY(removedUnits(take) > 0);
        QCOMPARE(live.device.force.load(), 0.0);
    }

    /// Unplugged in the middle of a stroke: a message names the record, the force is zero, and the session continues.
    void unpluggedItSaysSoAndGoesOn() {
        QTemporaryDir folder;
        Live live(folder);
        QVERIFY(live.sees([&] { return live.state.ticks > 100; }));
        live.device.unplug();
        const auto fault = live.fault();
        QVERIFY(fault);
        // A busy machine may have made the loop late before: that is reported as well.
        const auto unplugged = fault->code == ErrorCode::deviceUnplugged ? fault : live.fault();
        QVERIFY(unplugged);
        QCOMPARE(unplugged->code, ErrorCode::deviceUnplugged);
        QVERIFY2(QFile::exists(QString::fromStdString(unplugged->place)), unplugged->place.c_str());
        QVERIFY(unplugged->place.starts_with(folder.filePath("p.flights").toStdString()));
        QVERIFY(live.sees([&] { return (live.state.sample.flags & sampleStylusInvalid) != 0; }));
        QCOMPARE(live.device.force.load(), 0.0);
        const std::uint64_t then = live.state.ticks;
        QVERIFY(live.sees([&] { return live.state.ticks > then + 50; })); // its guards continue
        live.device.unplugged = false;
        QVERIFY(live.sees([&] { return (live.state.sample.flags & sampleStylusInvalid) == 0 && live.state.cutting; }));
        QVERIFY(live.session->end());
        const Take take = *live.stage.project.take(live.session->take());
        QVERIFY(contiguous(take));
    }

    /// A loop that is prevented from running leaves a record too, and its motors are cut by another thread.
    void aLoopThatHangsIsTold() {
        QTemporaryDir folder;
        SessionRequest request = liveRequest();
        request.flights = folder.filePath("elsewhere").toStdString();
        Live live(folder, request);
        QVERIFY(live.sees([&] { return live.state.ticks > 100; }));
        const int cuts = live.device.cuts;
        live.device.hang = 0.4;
        QVERIFY(await([&] { return live.device.cuts > cuts; }));
        std::optional<Error> fault;
        bool dead = false;
        for (int i = 0; i < 5 && !dead; ++i) {
            fault = live.fault();
            dead = fault && fault->detail.find("did not respond") != std::string::npos;
        }
        QVERIFY(dead);
        QCOMPARE(fault->code, ErrorCode::deviceStopped);
        QVERIFY(fault->place.starts_with(request.flights.string()));
        QVERIFY(live.sees([&] { return live.state.cutting; }));
        const auto statistics = live.session->end();
        QVERIFY(statistics);
        QVERIFY(statistics->cuts >= 1);
        QVERIFY(statistics->late >= 1);
    }

    /// A timing problem that a simulated stylus would not feel is no fault, and leaves no record.
    void aSimulatedStylusHasNoFlights() {
        QTemporaryDir folder;
        Stage stage(folder.filePath("p.burin").toStdString());
        SimulatedStylus mouse({0.5 * side, 0.5 * side, top + 5.0});
        auto session = MillingSession::begin(stage.project, stage.milling, ToolBounds::borrowing(*stage.field), mouse,
                                             stage.strokes, handRequest());
        QVERIFY(session);
        SessionState state;
        QVERIFY(await([&] { return (*session)->newest(state), state.ticks > 50; }));
        QVERIFY(!(*session)->takeFault());
        QVERIFY((*session)->end());
        QVERIFY(!QDir(folder.path()).exists("p.flights"));
    }

    /// Motors that become hot are reported once, with the reduced force; the session continues.
    void hotMotorsAreTold() {
        QTemporaryDir folder;
        Live live(folder);
        QVERIFY(live.sees([&] { return live.state.ticks > 100; }));
        QVERIFY((live.state.sample.flags & sampleMotorsHot) == 0);
        live.device.heat = 0.9;
        std::optional<Error> fault;
        for (int i = 0; i < 5 && !(fault && fault->code == ErrorCode::deviceHot); ++i) fault = live.fault();
        QVERIFY(fault);
        QCOMPARE(fault->code, ErrorCode::deviceHot); // a busy machine may have made the loop late before
        QCOMPARE(fault->subject, std::string("pacer"));
        QVERIFY(live.sees([&] { return (live.state.sample.flags & sampleMotorsHot) != 0 && live.state.cutting; }));
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
        while (std::chrono::steady_clock::now() < end) {
            const auto again = live.session->takeFault();
            QVERIFY(!again || again->code != ErrorCode::deviceHot);
        }
        QVERIFY(live.session->end());
    }

    /// Replaying the trace of a session gives the same workpiece, whatever its owner requested meanwhile.
    void itsTraceMillsTheSame() {
        QTemporaryDir folder;
        SessionRequest request = liveRequest();
        request.trace = folder.filePath("trace.csv").toStdString();
        request.mapping.origin = {0.125, -0.25, 0.0};
        request.allowance = 0.1;
        Live live(folder, request);
        QVERIFY(live.sees([&] { return live.state.ticks > 100; }));
        GuideSettings guides;
        guides.guides[0].kind = GuideKind::levels;
        guides.guides[0].on = true;
        guides.guides[0].distance = 0.8;
        QVERIFY(live.session->setGuides(guides));
        QVERIFY(live.sees([&] { return live.state.ticks > 200; }));
        live.session->stepGuides(-1);
        live.session->setAllowance(0.3);
        live.device.heat = 0.85;
        QVERIFY(live.sees([&] { return live.state.ticks > 300; }));
        WorkspaceSettings workspace;
        workspace.scale = 1.1;
        workspace.clutched = true;
        live.session->setWorkspace(workspace);
        QVERIFY(live.sees([&] { return live.state.clutched; }));
        workspace.clutched = false;
        live.session->setWorkspace(workspace);
        QVERIFY(live.sees([&] { return live.state.ticks > 600; }));
        QVERIFY(live.session->end());
        const Take original = *live.stage.project.take(live.session->take());

        const auto trace = readSessionTrace(request.trace);
        QVERIFY(trace && trace->began);
        QVERIFY(trace->changes.size() >= 6);
        QCOMPARE(trace->began->stylus.name, std::string("pacer"));
        TraceStylus again(trace->readings, trace->began->stylus);
        Stage second(folder.filePath("q.burin").toStdString());
        TakeRequest played;
        played.name = "again";
        played.replayed = &*trace;
        played.mapping = trace->began->mapping;
        played.allowance = trace->began->allowance;
        played.period = trace->began->period;
        played.cutsOnButton = trace->began->cutsOnButton;
        const std::atomic<bool> stop{false};
        const auto outcome =
            recordTake(second.project, second.milling, ToolBounds::borrowing(*second.field), again, played, stop);
        QVERIFY(outcome);
        const Take take = *second.project.take(outcome->take);
        QCOMPARE(take.samples.size(), original.samples.size());
        for (std::size_t i = 0; i < take.samples.size(); ++i) {
            QCOMPARE(take.samples[i].proxy.tip, original.samples[i].proxy.tip);
            QCOMPARE(take.samples[i].cuttingForce, original.samples[i].cuttingForce);
            if ((original.samples[i].flags & sampleForceLate) == 0) {
                QCOMPARE(take.samples[i].force, original.samples[i].force);
                QCOMPARE(take.samples[i].flags, original.samples[i].flags);
            }
            QVERIFY(std::ranges::equal(take.samples[i].removed, original.samples[i].removed,
                                       [](const RemovedMaterial& a, const RemovedMaterial& b) {
                                           return a.units == b.units && a.property == b.property;
                                       }));
        }
        QVERIFY(removedUnits(take) > 0);
        QVERIFY(linesOf(second.milling.embedded.workpiece) == linesOf(live.stage.milling.embedded.workpiece));
    }

    void aTraceThatCannotBeWrittenIsRefused() {
        QTemporaryDir folder;
        SessionRequest request = liveRequest();
        request.trace = folder.filePath("no/such/folder.csv").toStdString();
        Stage stage(folder.filePath("p.burin").toStdString());
        Device device;
        const auto session = MillingSession::begin(stage.project, stage.milling, ToolBounds::borrowing(*stage.field),
                                                   device.stylus, stage.strokes, request);
        QVERIFY(!session);
        QCOMPARE(session.error().code, ErrorCode::fileNotWritable);
    }
};

BURIN_TEST(TestDeviceSession, QCoreApplication)

} // namespace burin::tst_device_session

#include "tst_device_session.moc"
