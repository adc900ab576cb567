// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/own_stylus.h"
#include "ui/workbench/workbench.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <mutex>

using namespace burin;
using burin::test::OwnStylus;

namespace {

/// What a test's devices are doing. Any thread.
struct Hand {
    std::atomic<bool> pluggedIn{true}, button{false};
    std::atomic<OwnStylus*> stylus{nullptr};
};

StylusDescription description() {
    StylusDescription description = test::desktopStylus();
    description.name = "Arm";
    description.buttons = 1;
    description.rate = {1000.0, "made up"};
    return description;
}

class Arms final : public DeviceDriver {
public:
    explicit Arms(Hand& hand) : hand_(hand) {}
    std::vector<FoundDevice> find() override {
        const std::lock_guard lock(mutex_);
        return devices_;
    }
    void put(std::vector<FoundDevice> devices) {
        const std::lock_guard lock(mutex_);
        devices_ = std::move(devices);
    }
    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        madeMode = mode;
        if (id != "one") return Error{ErrorCode::deviceNotAllowed, id, "/dev/none", {}};
        auto stylus = std::make_unique<OwnStylus>(description(), [&hand = hand_](double time, int) {
            StylusState state;
            state.time = time;
            state.pose.position = {20.0 * std::sin(3.0 * time), 5.0 * std::cos(3.0 * time), -8.0};
            state.buttons = hand.button ? 1U : 0U;
            state.valid = hand.pluggedIn;
            return state;
        });
        hand_.stylus = stylus.get();
        return AnyStylus(std::unique_ptr<SelfPacedStylus>(std::move(stylus)));
    }
    std::string madeMode;

private:
    Hand& hand_;
    std::mutex mutex_;
    std::vector<FoundDevice> devices_;
};

struct Shelf {
    Shelf() {
        auto made = std::make_unique<Arms>(hand);
        arms = made.get();
        registry->add("arms", std::move(made));
    }
    QTemporaryDir folder;
    Hand hand;
    std::shared_ptr<DeviceRegistry> registry =
        std::make_shared<DeviceRegistry>(std::filesystem::path(folder.path().toStdString()) / "none");
    Arms* arms;
};

QStringList namesOf(const StylusController& styluses) {
    QStringList names;
    for (const StylusController::Choice& choice : styluses.choices())
        names << choice.name + (choice.there ? "" : " (away)");
    return names;
}

} // namespace

/// Which stylus the window mills with, and that a device does.
class TestStyluses : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", folder_->path().toUtf8());
        QCoreApplication::setApplicationName("Burin");
    }

    void devicesComeAndGo() {
        Shelf shelf;
        Workbench bench;
        StylusController& styluses = bench.styluses;
        QCOMPARE(namesOf(styluses), QStringList{"Mouse"});
        styluses.start(shelf.registry);
        const DeviceMode fast{"fast", BURIN_TEXT("Device", "quick")}, slow{"slow", BURIN_TEXT("Device", "calm")};
        shelf.arms->put({{"one", "Arm", {}}, {"two", "Cap", {fast, slow}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: quick", "Cap: calm"}));
        QVERIFY(styluses.mouse());
        styluses.choose(3);
        QCOMPARE(styluses.chosenName(), QString("Cap: calm"));
        styluses.choose(9); // there is none
        QCOMPARE(styluses.chosen(), std::size_t{3});
        shelf.arms->put({{"one", "Arm", {}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: calm (away)"}));
        QCOMPARE(styluses.chosen(), std::size_t{2}); // it stays chosen
        shelf.arms->put({{"one", "Arm", {}}, {"two", "Cap", {fast, slow}}});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Arm", "Cap: quick", "Cap: calm"}));
        QCOMPARE(styluses.chosenName(), QString("Cap: calm"));
        shelf.arms->put({});
        QTRY_COMPARE(namesOf(styluses), (QStringList{"Mouse", "Cap: calm (away)"}));
        styluses.choose(0);
        QCOMPARE(namesOf(styluses), QStringList{"Mouse"});
    }

    void aDeviceThatCannotBeUsedSaysSo() {
        Shelf shelf;
        Workbench bench;
        bench.styluses.start(shelf.registry);
        shelf.arms->put({{"two", "Cap", {}}});
        QTRY_COMPARE(bench.styluses.choices().size(), std::size_t{2});
        bench.styluses.choose(1);
        QSignalSpy failed(&bench, &Workbench::failed);
        bool told = false;
        bench.styluses.connectDevice([&](std::unique_ptr<AnyStylus> stylus) { told = stylus == nullptr; });
        QTRY_VERIFY(told);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(qvariant_cast<Error>(failed[0][0]).code, ErrorCode::deviceNotAllowed);
    }

    /// Its button begins a stroke and its recording; unplugged it says so, and goes on when it is back.
    void aDeviceMills() {
        Shelf shelf;
        shelf.arms->put({{"one", "Arm", {}}});
        Workbench bench;
        bench.document.createNew(false, [&](bool made) {
            QVERIFY(made);
            bench.importPart(BURIN_FIXTURES "/models/cube.brep", false);
        });
        QTRY_VERIFY_WITH_TIMEOUT(bench.setup.usable(), 60000);
        Setup coarse = bench.setup.setup();
        coarse.voxel = 1.0; // mm: soon embedded
        bench.setup.edit(coarse);
        bench.bench.embed();
        QTRY_VERIFY_WITH_TIMEOUT(bench.bench.ready(), 60000);
        bench.styluses.start(shelf.registry);
        QTRY_COMPARE(bench.styluses.choices().size(), std::size_t{2});
        bench.styluses.choose(1);
        QSignalSpy failed(&bench, &Workbench::failed);
        bench.mill.enter();
        QTRY_VERIFY(bench.mill.active());
        QVERIFY(!bench.mill.stylus()); // no pointer leads it
        QTRY_VERIFY(bench.session.state().ticks > 50);
        QVERIFY(!bench.mill.recording());
        shelf.hand.button = true;
        QTRY_VERIFY(bench.mill.recording());
        QTRY_VERIFY(bench.session.state().cutting);

        shelf.hand.pluggedIn = false;
        shelf.hand.stylus.load()->faults.raise(DeviceFault::unplugged);
        const auto unplugged = [&failed] {
            return std::ranges::any_of(failed, [](const QVariantList& told) {
                return qvariant_cast<Error>(told[0]).code == ErrorCode::deviceUnplugged;
            });
        };
        QTRY_VERIFY(unplugged());
        QTRY_VERIFY((bench.session.state().sample.flags & sampleStylusInvalid) != 0);
        QCOMPARE(bench.session.state().sample.force, glm::dvec3(0.0));
        QVERIFY(bench.mill.active());
        shelf.hand.pluggedIn = true;
        QTRY_VERIFY((bench.session.state().sample.flags & sampleStylusInvalid) == 0);
        QTRY_VERIFY(bench.session.state().cutting);

        bench.mill.stopRecording();
        QTRY_VERIFY(!bench.mill.recording());
        QTest::qWait(100);
        QVERIFY(!bench.mill.recording()); // a button that is still held begins nothing
        bench.mill.leave();
        QTRY_VERIFY(!bench.mill.active());
        QTRY_COMPARE(bench.mill.takes().size(), std::size_t{1});
        QCOMPARE(bench.mill.takes()[0].stylus, std::string("Arm"));
        QVERIFY(bench.mill.takes()[0].sampleCount > 0);
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestStyluses)
#include "tst_styluses.moc"
