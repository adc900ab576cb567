// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/resampled_stylus.h"

#include <QtTest>

using namespace burin;

namespace {

/// A self-paced stylus whose device's thread is the test's.
class HandWound final : public SelfPacedStylus {
public:
    StylusDescription description() const override {
        StylusDescription description;
        description.name = "hand-wound";
        description.rate = {500.0, "made up"};
        description.delay = {0.0005, "made up"};
        description.workspaceRadius = {50.0, "made up"};
        return description;
    }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    Result<void> start(StylusClient& client) override {
        client_ = &client;
        return {};
    }
    void stop() noexcept override { client_ = nullptr; }
    void cutMotors() noexcept override { ++cuts; }

    Wrench tick(double time, double x, bool valid = true) {
        StylusState state;
        state.time = time;
        state.pose.position.x = x;
        state.valid = valid;
        return client_->tick(state);
    }
    bool started() const { return client_ != nullptr; }
    int cuts = 0;

private:
    StylusClient* client_ = nullptr;
};

struct Fixture {
    Fixture() {
        auto made = std::make_unique<HandWound>();
        device = made.get();
        stylus = calledByLoop(AnyStylus(std::unique_ptr<SelfPacedStylus>(std::move(made))));
        if (!stylus->open()) std::abort(); // the test's own set-up
    }
    HandWound* device;
    std::unique_ptr<Stylus> stylus;
};

} // namespace

class TestResampledStylus : public QObject {
    Q_OBJECT
private slots:
    void theNewestReadingIsRead() {
        Fixture test;
        QVERIFY(!test.stylus->read(0.0).valid); // nothing yet
        test.device->tick(0.001, 1.0);
        test.device->tick(0.002, 2.0);
        const StylusState state = test.stylus->read(0.1);
        QVERIFY(state.valid);
        QCOMPARE(state.pose.position.x, 2.0);
        QCOMPARE(state.time, 0.1); // the session's, not the device's
    }

    void theNewestWrenchIsRendered() {
        Fixture test;
        QCOMPARE(test.device->tick(0.001, 0.0).force, glm::dvec3(0.0));
        test.stylus->write({{1.0, 0.0, 0.0}, {}});
        test.stylus->write({{2.0, 0.0, 0.0}, {0.0, 3.0, 0.0}});
        QCOMPARE(test.device->tick(0.002, 0.0).force.x, 2.0);
        QCOMPARE(test.device->tick(0.004, 0.0).torque.y, 3.0);
    }

    void aLoopThatStandsLeavesNoForceOnTheDevice() {
        Fixture test;
        test.stylus->write({{2.0, 0.0, 0.0}, {}});
        for (const double time : {0.001, 0.010, 0.020}) QCOMPARE(test.device->tick(time, 0.0).force.x, 2.0);
        QCOMPARE(test.device->tick(0.022, 0.0).force, glm::dvec3(0.0));
        test.stylus->write({{1.0, 0.0, 0.0}, {}});
        QCOMPARE(test.device->tick(0.024, 0.0).force.x, 1.0);
    }

    void aDeviceThatStandsGivesNoValidReading() {
        Fixture test;
        test.device->tick(0.001, 1.0);
        QVERIFY(test.stylus->read(1.000).valid);
        QVERIFY(test.stylus->read(1.019).valid);
        QVERIFY(!test.stylus->read(1.021).valid);
        test.device->tick(0.022, 1.0);
        QVERIFY(test.stylus->read(1.022).valid);
        test.device->tick(0.023, 1.0, false); // the device's own word
        QVERIFY(!test.stylus->read(1.023).valid);
    }

    void whatWasWrittenBeforeACutIsNotRendered() {
        Fixture test;
        test.stylus->write({{2.0, 0.0, 0.0}, {}});
        QCOMPARE(test.device->tick(0.001, 0.0).force.x, 2.0);
        test.stylus->write({{3.0, 0.0, 0.0}, {}}); // on its way
        test.stylus->cutMotors();
        QCOMPARE(test.device->cuts, 1);
        for (const double time : {0.002, 0.003}) QCOMPARE(test.device->tick(time, 0.0).force, glm::dvec3(0.0));
        test.stylus->write({{1.0, 0.0, 0.0}, {}});
        QCOMPARE(test.device->tick(0.004, 0.0).force.x, 1.0);
    }

    void theDelayOfTwoClocksIsStated() {
        Fixture test;
        const StylusDescription description = test.stylus->description();
        QCOMPARE(description.delay.value, 0.0005 + 1.0 / 500.0);
        QVERIFY(checkDescription(description));
    }

    void anotherSessionKnowsNothingOfTheLast() {
        Fixture test;
        test.device->tick(0.001, 1.0);
        test.stylus->write({{2.0, 0.0, 0.0}, {}});
        test.stylus->close();
        QVERIFY(!test.device->started());
        QVERIFY(test.stylus->open());
        QVERIFY(!test.stylus->read(0.0).valid);
        QCOMPARE(test.device->tick(0.001, 0.0).force, glm::dvec3(0.0));
    }
};

QTEST_APPLESS_MAIN(TestResampledStylus)
#include "tst_resampled_stylus.moc"
