// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Points of a path are moved by a device and by the mouse as stylus: the part holds the tool meanwhile.
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/own_stylus.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAction>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <mutex>

namespace burin::tst_window_stylus_edit {

using namespace burin::testing;

namespace {

/// A hand that moves a device towards a position at 60 mm/s. Thread-safe.
class Hand {
public:
    void goTo(const glm::dvec3& place) {
        const std::lock_guard lock(mutex_);
        goal_ = place;
    }
    bool arrived() const {
        const std::lock_guard lock(mutex_);
        return glm::distance(at_, goal_) < 1e-6;
    }
    StylusState read(double time) {
        const std::lock_guard lock(mutex_);
        const glm::dvec3 rest = goal_ - at_;
        const double most = 60.0 * std::clamp(time - time_, 0.0, 0.005), distance = glm::length(rest);
        at_ += distance > most ? rest * (most / distance) : rest;
        time_ = time;
        StylusState state;
        state.time = time;
        state.pose.position = at_;
        state.buttons = button ? 1U : 0U;
        state.valid = true;
        return state;
    }
    std::atomic<bool> button{false};

private:
    mutable std::mutex mutex_;
    glm::dvec3 at_{0.0, 0.0, 30.0}, goal_{0.0, 0.0, 30.0};
    double time_ = 0.0;
};

class Pens final : public DeviceDriver {
public:
    explicit Pens(Hand& hand, int buttons) : hand_(hand), buttons_(buttons) {}
    std::vector<FoundDevice> find() override { return {{"one", "Pen", {}}}; }
    Result<AnyStylus> make(const std::string&, const std::string&) override {
        StylusDescription description = test::desktopStylus();
        description.name = "Pen";
        description.buttons = buttons_;
        description.rate = {1000.0, "made up"};
        return AnyStylus(std::unique_ptr<SelfPacedStylus>(std::make_unique<test::OwnStylus>(
            description, [&hand = hand_](double time, int) { return hand.read(time); })));
    }

private:
    Hand& hand_;
    int buttons_;
};

/// Makes a path of one straight groove along X, 1 mm deep.
bool makePath(WindowDriver& driver) {
    return makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0}) && newPath(driver);
}

/// Makes the pen the chosen stylus and begins to edit.
bool takeInHand(WindowDriver& driver, Hand& hand, int buttons) {
    Workbench& workbench = driver.window().workbench();
    auto registry = std::make_shared<DeviceRegistry>(std::filesystem::path("none"));
    registry->add("pens", std::make_unique<Pens>(hand, buttons));
    workbench.styluses.start(registry);
    const auto pen = [&] {
        return std::ranges::find(workbench.styluses.choices(), std::string("pens:one"), &StylusController::Choice::id);
    };
    if (!driver.waitFor([&] { return pen() != workbench.styluses.choices().end(); })) return false;
    workbench.styluses.choose(static_cast<std::size_t>(pen() - workbench.styluses.choices().begin()));
    driver.key(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    return true;
}

const PathPoint& middleOf(const Workbench& workbench) {
    const std::vector<PathPoint>& points = workbench.path.evaluated()->path.points;
    const glm::dvec3 zero = workbench.workpiece.milling()->setup.workOffset;
    return *std::ranges::min_element(points, {}, [&](const PathPoint& point) {
        return point.kind == MoveKind::cut && point.sample >= 0 ? std::abs(point.pose.tip.x - zero.x) : 1e9;
    });
}

std::vector<MovePoints> movesOf(const Workbench& workbench) {
    std::vector<MovePoints> moves;
    for (const Edit& edit : workbench.path.stored()->edits)
        if (const auto* found = std::get_if<MovePoints>(&edit.parameters)) moves.push_back(*found);
    return moves;
}

bool upToDate(WindowDriver& driver) {
    const PathController& path = driver.window().workbench().path;
    return driver.waitFor([&] { return !path.busy() && !path.outdated() && !path.problem(); });
}

} // namespace

class TestWindowStylusEdit : public QObject {
    Q_OBJECT
private slots:
    void aDeviceMovesAPointAndThePartHoldsIt();
    BURIN_ONLY_IN_LONG_RUNS void thePointerLeadsTheTool();
    void aDeviceWithoutAButtonIsRefused();
};

void TestWindowStylusEdit::aDeviceMovesAPointAndThePartHoldsIt() {
    Hand hand;
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    const StylusEditor& editor = workbench.stylusEditor;
    QVERIFY(takeInHand(driver, hand, 1));
    QVERIFY(driver.waitFor([&] { return editor.active(); }));
    QVERIFY(menuAction(driver, "stylusEditAction")->isChecked());
    const WorkspaceMapping mapping = workbench.hand.device()->mapping;
    const PathPoint middle = middleOf(workbench);
    const auto lead = [&](const glm::dvec3& place) {
        hand.goTo(mapping.toDevice(place));
        return driver.waitFor([&] { return hand.arrived(); }) &&
               driver.waitFor([&] { return glm::distance(workbench.session.state().sample.stylusTip, place) < 0.01; });
    };
    // 5 mm above the path nothing is in reach of 3 mm, 2 mm beside it the nearest point is.
    QVERIFY(lead(middle.pose.tip + glm::dvec3(0.0, 0.0, 5.0)));
    QVERIFY(driver.waitFor([&] { return !editor.within(); }));
    QVERIFY(lead(middle.pose.tip + glm::dvec3(0.0, 2.0, 0.0)));
    QVERIFY(driver.waitFor([&] { return editor.within() && std::abs(editor.within()->at.distance - 2.0) < 0.05; }));
    QTest::qWait(100);
    driver.shoot("stylus-edit-1-reach");

    // A press alone selects the point, as a click does.
    hand.button = true;
    QVERIFY(driver.waitFor([&] { return editor.held().has_value(); }));
    hand.button = false;
    QVERIFY(driver.waitFor([&] { return workbench.path.selection().has_value(); }));
    QVERIFY(movesOf(workbench).empty());

    // Down into the part by 10 mm: the tool stops on it, and so does the point.
    const double partTop = workbench.workpiece.milling()->partModel->box().high.z;
    QVERIFY(middle.pose.tip.z - partTop > 0.5); // there is stock between them
    hand.button = true;
    QVERIFY(driver.waitFor([&] { return editor.held().has_value(); }));
    const glm::dvec3 from = editor.held()->at.place;
    QVERIFY(lead(from + glm::dvec3(0.0, 3.0, partTop - from.z - 10.0)));
    QVERIFY(driver.waitFor([&] { return (workbench.session.state().sample.flags & sampleOnBoundary) != 0; }));
    QVERIFY(workbench.session.state().sample.force.z > 0.1 || // forces fade in slowly on a busy machine
            driver.waitFor([&] { return workbench.session.state().sample.force.z > 0.1; }));
    driver.shoot("stylus-edit-2-held");
    const int entries = workbench.undo().count();
    hand.button = false;
    QVERIFY(driver.waitFor([&] { return movesOf(workbench).size() == 1; }));
    QCOMPARE(workbench.undo().count(), entries + 1);
    const MovePoints move = movesOf(workbench)[0];
    const double height = from.z + move.by.z - partTop;
    QVERIFY2(height > -0.005 && height < 0.5, qPrintable(QString::number(height)));
    QVERIFY(std::abs(from.y + move.by.y - (from.y + 3.0)) < 0.1);
    QCOMPARE(move.falloff, MovePoints{}.falloff);
    QVERIFY(move.along == MovePoints::Along::free);
    QVERIFY(upToDate(driver));
    QVERIFY(editor.active());                    // the next point can be taken
    QVERIFY(workbench.mill.takes().size() == 1); // nothing was recorded
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return movesOf(workbench).empty(); }));
    QVERIFY(upToDate(driver));

    // Esc leaves the point where it was, and then ends the work with the stylus.
    QVERIFY(lead(middle.pose.tip + glm::dvec3(0.0, 1.0, 0.0)));
    QVERIFY(driver.waitFor([&] { return editor.within().has_value(); }));
    hand.button = true;
    QVERIFY(driver.waitFor([&] { return editor.held().has_value(); }));
    QVERIFY(lead(middle.pose.tip + glm::dvec3(0.0, 6.0, 0.0)));
    driver.key(Qt::Key_Escape);
    QVERIFY(!editor.held());
    hand.button = false;
    QTest::qWait(200);
    QVERIFY(movesOf(workbench).empty());
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !editor.active() && !workbench.session.running(); }));
    QVERIFY(!workbench.hand.hasDevice());
}

void TestWindowStylusEdit::thePointerLeadsTheTool() {
    WindowDriver driver(QSize(1280, 920));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    const StylusEditor& editor = workbench.stylusEditor;
    QVERIFY(driver.clickOn("stylusEditButton"));
    QVERIFY(driver.waitFor([&] { return editor.usesMouse(); }));
    Viewport& viewport = driver.window().viewport();
    const PathPoint middle = middleOf(workbench);
    const glm::dvec3 aside = middle.pose.tip + glm::dvec3(0.0, 4.0, 0.0);
    const QPoint from = viewport.project(middle.pose.tip).toPoint(), to = viewport.project(aside).toPoint();
    const auto drag = [&] {
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 8; ++i) QTest::mouseMove(&viewport, from + (to - from) * i / 8, 10);
    };
    drag();
    QVERIFY(editor.held());
    QVERIFY(driver.waitFor([&] { return glm::length(editor.by()) > 3.5; }));
    driver.shoot("stylus-edit-3-pointer");
    driver.key(Qt::Key_Escape);
    QVERIFY(!editor.held());
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, to);
    QTest::qWait(300);
    QVERIFY(movesOf(workbench).empty());

    drag();
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, to); // the tool goes on to where the pointer led it
    QVERIFY(driver.waitFor([&] { return movesOf(workbench).size() == 1; }));
    const MovePoints move = movesOf(workbench)[0];
    const QPointF pixels = viewport.project(aside) - viewport.project(aside - glm::dvec3(0.0, 1.0, 0.0));
    const double pixel = 1.0 / std::hypot(pixels.x(), pixels.y());
    QVERIFY2(glm::distance(move.by, glm::dvec3(0.0, 4.0, 0.0)) < 2.0 * pixel + 0.05,
             qPrintable(QStringLiteral("%1 %2 %3").arg(move.by.x).arg(move.by.y).arg(move.by.z)));
    QVERIFY(upToDate(driver));
    QVERIFY(driver.step(JobStep::program)); // leaving the step puts the stylus down
    QVERIFY(driver.waitFor([&] { return !workbench.session.running(); }));
}

void TestWindowStylusEdit::aDeviceWithoutAButtonIsRefused() {
    Hand hand;
    WindowDriver driver;
    QVERIFY(makePath(driver));
    QVERIFY(takeInHand(driver, hand, 0));
    QVERIFY(driver.waitFor([&] { return driver.message().contains("“Pen” has no button"); }));
    QVERIFY(!driver.window().workbench().session.running());
}

BURIN_TEST(TestWindowStylusEdit, QApplication)

} // namespace burin::tst_window_stylus_edit

#include "tst_window_stylus_edit.moc"
