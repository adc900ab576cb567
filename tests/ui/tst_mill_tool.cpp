// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/input/mill_geometry.h"
#include "ui/input/mill_tool.h"
#include "ui/input/press_preview.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

namespace burin::tst_mill_tool {

namespace {

constexpr double edge = 0.25;                                          // mm
const Box block{{-20.0, -20.0, 0.0}, {20.0, 20.0, 30.0}};              // of the grid
constexpr double top = 10.0, towerTop = 26.0, towerLow = 12.0;         // mm; the tower fills x >= towerLow
constexpr double pitLow = -16.0, pitHigh = -8.0, pitFloor = 4.0;       // x; a slot along y
constexpr double plateauLow = -5.0, plateauHigh = 5.0, plateauZ = 6.0; // the protected part, |x|, |y| <= 5

/// A block of stock with a slot, a tower and a protected plateau inside.
VolumeSnapshot workpiece() {
    static RunVolume volume = [] {
        const Grid grid = Grid::make(block.low, edge, glm::ivec3(glm::round(block.size() / edge))).value();
        PropertyList properties;
        Property stock, part;
        stock.id = "stock";
        part.id = "part";
        part.machinability = Machinability::isProtected;
        const PropertyIndex s = properties.add(stock).value(), p = properties.add(part).value();
        RunVolume made = RunVolume::make(grid, properties).value();
        for (int v = 0; v < grid.lineCountV(); ++v)
            for (int u = 0; u < grid.lineCountU(); ++u) {
                const glm::dvec2 c = grid.lineCentre({u, v});
                const double height = c.x >= towerLow ? towerTop : c.x > pitLow && c.x < pitHigh ? pitFloor : top;
                made.fillSpan({u, v}, 0, grid.toRunPosition(height), s);
                if (c.x > plateauLow && c.x < plateauHigh && c.y > plateauLow && c.y < plateauHigh)
                    made.fillSpan({u, v}, 0, grid.toRunPosition(plateauZ), p);
            }
        return made;
    }();
    static const VolumeSnapshot shown = volume.snapshot();
    return shown;
}

/// The pointer over a point in the setup frame, seen by an eye at the front left, so that the tower hides nothing.
const glm::dvec3 eye(-60.0, -200.0, 260.0);
ViewportEvent over(const glm::dvec3& place, Qt::MouseButtons buttons = Qt::NoButton,
                   Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ViewportEvent event;
    event.rayOrigin = eye;
    event.rayDirection = glm::normalize(place - eye);
    event.buttons = buttons;
    event.modifiers = modifiers;
    return event;
}
ViewportEvent left(const glm::dvec3& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ViewportEvent event = over(place, Qt::LeftButton, modifiers);
    event.button = Qt::LeftButton;
    return event;
}

/// A pen's tip going down or up at a point, or moving while it is down.
ViewportEvent pen(const glm::dvec3& place, double pressure) {
    ViewportEvent event = left(place);
    event.pen = PenState{.pressure = pressure};
    return event;
}
ViewportEvent penMoved(const glm::dvec3& place, double pressure) {
    ViewportEvent event = over(place, Qt::LeftButton);
    event.pen = PenState{.pressure = pressure};
    return event;
}

Tool slimTool() { // flutes 2 mm in radius and 6 mm long, shank 3 mm, holder 8 mm from 20 mm up
    Tool tool = fixture::ballTool();
    tool.cutter = {CutterType::flat, 4.0, 0.0, 6.0, 6.0, 20.0, {{16.0, 16.0, 20.0}}};
    return tool;
}

/// Distance of a tool from the tower and the block, calculated with boxes and cylinders; negative where they intersect.
double clearance(const Cutter& cutter, const glm::dvec3& tip) {
    double least = 1e9;
    for (const RevolvedPiece& piece : pieces(cutter)) {
        const double radius = std::max(piece.bottomRadius, piece.topRadius), low = tip.z + piece.bottom;
        if (tip.x + radius > towerLow) least = std::min(least, low - towerTop);
        least = std::min(least, low - top);
    }
    return least;
}

} // namespace

class TestMillTool : public QObject {
    Q_OBJECT

private slots:
    void init() {
        stylus_ = std::make_unique<SimulatedStylus>(glm::dvec3(0.0, 0.0, 40.0));
        (void)stylus_->open();
        tool_ = std::make_unique<MillTool>(*stylus_, slimTool(), [] { return workpiece(); });
        time_ = 0.0;
        cutting_ = false;
        rest(); // so that the newest tip is known
    }

    void aSightMeetsALevel() {
        const Sight sight{{0.0, 0.0, 10.0}, glm::normalize(glm::dvec3(3.0, 0.0, -4.0))};
        QVERIFY(glm::distance(onLevel(sight, 2.0).value(), glm::dvec3(6.0, 0.0, 2.0)) < 1e-12);
        QVERIFY(!onLevel(sight, 11.0));
        QVERIFY(!onLevel({{0.0, 0.0, 10.0}, {1.0, 0.0, 0.0}}, 2.0));
    }

    void hoversTwoMillimetresOverWhatIsUnderThePointer() {
        tool_->move(over({0.0, 10.0, top}));
        const glm::dvec3 tip = rest();
        QVERIFY(std::abs(tip.x) < 1e-6 && std::abs(tip.y - 10.0) < 1e-6);
        QCOMPARE(tip.z, top + hoverClearance);
        QVERIFY(!cutting_);
    }

    /// Next to the tower the shank (3 mm in radius, from 6 mm up) and the holder (8 mm, from 20 mm up) reach over it.
    void hoverHeightCountsShankAndHolder() {
        tool_->move(over({towerLow - 2.5, 10.0, top}));
        QCOMPARE(rest().z, towerTop - 6.0 + hoverClearance);
        tool_->move(over({towerLow - 6.0, 10.0, top}));
        QCOMPARE(rest().z, towerTop - 6.0 + hoverClearance); // the tool has to get there first
        QTRY_COMPARE_WITH_TIMEOUT(rest(100).z, std::max(top, towerTop - 20.0) + hoverClearance, 30000);
        const Cutter cutter = slimTool().cutter;
        QCOMPARE(clearTipHeight(workpiece(), cutter, {16.0, 0.0}, {16.0, 0.0}), towerTop + hoverClearance);
    }

    void noHoverTouchesAnythingOnItsWay() {
        const Cutter cutter = slimTool().cutter;
        tool_->move(over({-2.0, 12.0, top}));
        rest();
        for (const double x : {17.0, -2.0, 14.0, 0.0, 19.0, 3.0}) { // to the tower and back, at full speed
            tool_->move(over({x, 12.0, x >= towerLow ? towerTop : top}));
            for (int tick = 0; tick < 400; ++tick) QVERIFY(clearance(cutter, read()) > 0.3);
        }
    }

    void levelStrokeStaysOnItsPlane() {
        tool_->setSettings({.rule = DepthRule::level, .depthOfCut = 1.5, .speed = 60.0});
        tool_->move(over({0.0, 12.0, top}));
        rest();
        QSignalSpy begins(tool_.get(), &MillTool::strokeBegins), ends(tool_.get(), &MillTool::strokeEnds);
        QVERIFY(tool_->press(left({0.0, 12.0, top})));
        QCOMPARE(begins.count(), 1);
        rest();
        QVERIFY(cutting_);
        // Over the slot and back: deeper surfaces under the pointer don't matter. The pointer draws on the level where
        // it pressed, the top.
        for (const glm::dvec3& place : {glm::dvec3(-12.0, 12.0, top - 1.5), glm::dvec3(4.0, 15.0, top - 1.5)}) {
            tool_->move(over({place.x, place.y, top}, Qt::LeftButton));
            glm::dvec3 before = rest(1);
            for (int tick = 0; tick < 900; ++tick) {
                const glm::dvec3 tip = read();
                QVERIFY(std::abs(tip.z - (top - 1.5)) < 1e-6);
                QVERIFY(glm::distance(tip, before) <= 60.0 * 0.001 * 1.000001);
                before = tip;
            }
            QVERIFY(glm::distance(before, place) < 1e-6);
        }
        QVERIFY(tool_->release(left({4.0, 15.0, top})));
        QCOMPARE(ends.count(), 1);
        QVERIFY(rest().z >= top + hoverClearance - 1e-9);
        QVERIFY(!cutting_);
    }

    void aStrokeMayBeginBesideTheStock() {
        tool_->setSettings({.depthOfCut = 1.0});
        tool_->move(over({0.0, 12.0, top}));
        tool_->move(over({0.0, 24.0, top})); // beside the block: at the level that was last under the pointer
        rest();
        tool_->press(left({0.0, 24.0, top}));
        QVERIFY(glm::distance(rest(), glm::dvec3(0.0, 24.0, top - 1.0)) < 1e-6);
    }

    /// With any depth rule and view, a press moves the tool down along its axis from its hover position.
    void aPressDoesNotMoveTheToolAside_data() {
        QTest::addColumn<bool>("alongPart");
        QTest::newRow("level") << false;
        QTest::newRow("along the part") << true;
    }
    void aPressDoesNotMoveTheToolAside() {
        QFETCH(bool, alongPart);
        tool_->setSettings({.rule = alongPart ? DepthRule::part : DepthRule::level, .depthOfCut = 1.5});
        tool_->move(over({2.0, -3.0, top}));
        const glm::dvec3 hovering = rest();
        tool_->press(left({2.0, -3.0, top}));
        for (int tick = 0; tick < 2000; ++tick) {
            const glm::dvec3 tip = read();
            QVERIFY(std::hypot(tip.x - hovering.x, tip.y - hovering.y) < 1e-3);
        }
        QVERIFY(cutting_);
    }

    /// Fast round a corner, then released: the tool also goes round the corner, and up to the point of the release.
    void aFastStrokeIsFinishedAsItWasDrawn() {
        tool_->setSettings({.depthOfCut = 1.0, .speed = 80.0});
        tool_->move(over({-2.0, 12.0, top}));
        rest();
        tool_->press(left({-2.0, 12.0, top}));
        for (int i = 1; i <= 4; ++i) tool_->move(over({-2.0 + 2.0 * i, 12.0, top}, Qt::LeftButton));
        for (int i = 1; i <= 2; ++i) tool_->move(over({6.0, 12.0 - 4.0 * i, top}, Qt::LeftButton));
        QVERIFY(tool_->release(left({6.0, 4.0, top})));
        tool_->leave(); // to the panel, for example
        double toCorner = 1e9, toEnd = 1e9;
        for (int tick = 0; tick < 3000; ++tick) {
            const glm::dvec3 tip = read();
            if (!cutting_ || std::abs(tip.z - (top - 1.0)) > 1e-6) continue;
            toCorner = std::min(toCorner, glm::distance(tip, {6.0, 12.0, top - 1.0}));
            toEnd = std::min(toEnd, glm::distance(tip, {6.0, 4.0, top - 1.0}));
            QVERIFY(std::min(std::abs(tip.y - 12.0), std::abs(tip.x - 6.0)) < 0.1); // an L, not a diagonal
        }
        QVERIFY(toCorner < 0.1 && toEnd < 0.001);
        QVERIFY(!cutting_);
    }

    void wheelMovesAlongTheAxis() {
        QSignalSpy depth(tool_.get(), &MillTool::depthChanged);
        tool_->setSettings({.depthOfCut = 1.0});
        ViewportEvent wheel = over({0.0, 12.0, top});
        wheel.wheelSteps = -2.0;
        QVERIFY(tool_->wheel(wheel));
        QCOMPARE(depth.takeLast().at(0).toDouble(), -1.0);
        wheel.modifiers = Qt::ShiftModifier;
        tool_->wheel(wheel);
        QCOMPARE(depth.takeLast().at(0).toDouble(), -1.1);
        wheel.modifiers = Qt::ControlModifier; // for the camera
        QVERIFY(!tool_->wheel(wheel));
        tool_->press(left({0.0, 12.0, top}));
        QVERIFY(std::abs(rest().z - (top - 1.0 - 1.1)) < 1e-6);
        wheel.modifiers = Qt::NoModifier;
        wheel.wheelSteps = 1.0;
        tool_->wheel(wheel); // while the tool cuts
        QVERIFY(std::abs(rest().z - (top - 1.0 - 0.6)) < 1e-6);
    }

    void partRulePressesIntoThePart() {
        tool_->setSettings({.rule = DepthRule::part, .press = 2.0});
        tool_->press(left({1.0, 2.0, top})); // only the hidden part below determines the depth
        QVERIFY(glm::distance(rest(), glm::dvec3(1.0, 2.0, plateauZ - 2.0)) < edge);
        QVERIFY(cutting_);
        tool_->move(over({-3.0, 4.0, top}, Qt::LeftButton));
        QVERIFY(glm::distance(rest(), glm::dvec3(-3.0, 4.0, plateauZ - 2.0)) < edge);
        // Beside the part the stroke goes on at its last height.
        tool_->move(over({-12.0, 8.0, top}, Qt::LeftButton));
        QVERIFY(glm::distance(rest(), glm::dvec3(-12.0, 8.0, plateauZ - 2.0)) < 2.0 * edge);
    }

    void shiftMakesThePointerFine() {
        tool_->setSettings({.depthOfCut = 1.0});
        tool_->press(left({0.0, 10.0, top - 1.0}));
        const glm::dvec3 start = rest();
        tool_->move(over({0.0, 10.0, top - 1.0}, Qt::LeftButton, Qt::ShiftModifier));
        tool_->move(over({6.0, 10.0, top - 1.0}, Qt::LeftButton, Qt::ShiftModifier));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(0.6, 0.0, 0.0)) < 0.02);
        // Without Shift the tool goes on from there, by as much as the pointer does.
        tool_->move(over({6.0, 10.0, top - 1.0}, Qt::LeftButton));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(0.6, 0.0, 0.0)) < 0.02);
        tool_->move(over({9.0, 10.0, top - 1.0}, Qt::LeftButton));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(3.6, 0.0, 0.0)) < 0.1);
    }

    /// Straight from above in a parallel view: each sight line starts above its own point.
    void shiftMakesThePointerFineInAParallelView() {
        const auto seen = [](double x, Qt::KeyboardModifiers modifiers) {
            ViewportEvent event = over({}, Qt::LeftButton, modifiers);
            event.rayOrigin = {x, 10.0, 1.0e5};
            event.rayDirection = {0.0, 0.0, -1.0};
            event.parallel = true;
            return event;
        };
        tool_->setSettings({.depthOfCut = 1.0});
        ViewportEvent pressed = seen(0.0, Qt::NoModifier);
        pressed.button = Qt::LeftButton;
        tool_->press(pressed);
        const glm::dvec3 start = rest();
        tool_->move(seen(0.0, Qt::ShiftModifier));
        tool_->move(seen(6.0, Qt::ShiftModifier));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(0.6, 0.0, 0.0)) < 1e-6);
        tool_->move(seen(6.0, Qt::NoModifier));
        tool_->move(seen(9.0, Qt::NoModifier));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(3.6, 0.0, 0.0)) < 1e-6);
    }

    /// A press leads to the position that was shown before it.
    void aPressLeadsToWhereItWasAimed() {
        for (const DepthRule rule : {DepthRule::level, DepthRule::part}) {
            init();
            tool_->setSettings({.rule = rule, .depthOfCut = 1.5, .press = 2.0});
            std::optional<glm::dvec3> aimed;
            connect(tool_.get(), &MillTool::pressAimed, this,
                    [&](const std::optional<glm::dvec3>& tip) { aimed = tip; });
            tool_->move(over({2.0, 3.0, top}));
            QVERIFY(aimed.has_value());
            const glm::dvec3 shown = *aimed;
            tool_->press(left({2.0, 3.0, top}));
            QVERIFY(!aimed); // nothing is aimed at any longer
            QVERIFY(glm::distance(rest(), shown) < 1e-6);
            tool_->release(left({2.0, 3.0, top}));
            tool_->move(over({4.0, 3.0, top}));
            QVERIFY(aimed.has_value());
            tool_->leave();
            QVERIFY(!aimed);
        }
    }

    /// The plateau is flat: while the tip is still beside it, the cutter's edge, 2 mm from the axis, already touches
    /// it.
    void thePressedPlaceIsToldFromThePart() {
        const Cutter cutter = slimTool().cutter;
        const glm::dvec3 up(0.0, 0.0, 1.0), middle(0.0, 0.0, plateauZ - 2.0);
        const auto on = pressPreview(workpiece(), cutter, middle, up, 0.25);
        QVERIFY(on && on->contact);
        QVERIFY(std::abs(on->tip.z - (plateauZ + 0.25)) < 1e-9); // the allowance is respected
        QVERIFY(std::abs(on->contact->z - plateauZ) < 1e-9);
        QVERIFY(std::abs(on->depth - (top - plateauZ - 0.25)) < 1e-9);
        for (const double beside : {1.0, 3.0}) { // mm from the plateau's border
            const glm::dvec3 tip(0.0, plateauHigh + beside, plateauZ - 2.0);
            const auto seen = pressPreview(workpiece(), cutter, tip, up, 0.0);
            QVERIFY(seen);
            QCOMPARE(seen->contact.has_value(), beside < cutter.radius());
            QVERIFY(std::abs(seen->tip.z - (beside < cutter.radius() ? plateauZ : plateauZ - 2.0)) < 1e-9);
        }
        QVERIFY(!pressPreview(workpiece(), cutter, {500.0, 0.0, 0.0}, up, 0.0));
    }

    void leavesTheOtherButtonsToTheCamera() {
        for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
            ViewportEvent event = over({0.0, 0.0, top}, button);
            event.button = button;
            QVERIFY(!tool_->press(event));
            QVERIFY(!tool_->release(event));
        }
    }

    /// A dialog opened or another program came to the front while the button was down, so its release is never
    /// received.
    void aReleaseThatWentElsewhereEndsTheStroke() {
        QSignalSpy ends(tool_.get(), &MillTool::strokeEnds);
        tool_->press(left({0.0, 12.0, top}));
        tool_->move(over({6.0, 12.0, top}, Qt::LeftButton));
        rest();
        QVERIFY(cutting_);
        tool_->move(over({-9.0, 15.0, top})); // the pointer comes back without a button down
        QCOMPARE(ends.count(), 1);
        for (int tick = 0; tick < 2000; ++tick) {
            const glm::dvec3 tip = read();
            QVERIFY(!cutting_ || (std::abs(tip.y - 12.0) < 1e-6 && tip.x > -1e-6));
        }
        QVERIFY(!cutting_);
        tool_->setSettings({.drag = DragRule::raster});
        tool_->press(left({0.0, 12.0, top}));
        tool_->move(over({6.0, 16.0, top}, Qt::LeftButton));
        tool_->move(over({-9.0, 15.0, top}));
        tool_->release(left({-9.0, 15.0, top}));
        rest();
        QCOMPARE(ends.count(), 1); // a rectangle whose button was never released is not milled
    }

    /// After an undo, the last stroke is the one before: lines continue from it, and it is the one that is repeated.
    void afterAnUndoLinesGoOnFromTheStrokeBefore() {
        tool_->setSettings({.depthOfCut = 1.0, .stepOver = 3.0});
        const auto draw = [this](double y) {
            tool_->press(left({-4.0, y, top}));
            tool_->move(over({4.0, y, top}, Qt::LeftButton));
            tool_->release(left({4.0, y, top}));
            rest();
        };
        draw(12.0);
        draw(16.0);
        tool_->strokeTakenBack(true);
        QVERIFY(tool_->repeat(MillTool::Repetition::left).isEmpty()); // of the first: to +Y, as it goes to +X
        bool cut = false;
        for (int tick = 0; tick < 3000; ++tick) {
            const glm::dvec3 tip = read();
            if (cutting_) QVERIFY2(std::abs(tip.y - 15.0) < 0.03, qPrintable(QString::number(tip.y)));
            cut = cut || cutting_;
        }
        QVERIFY(cut);
        tool_->strokeTakenBack(true);
        tool_->strokeTakenBack(true);
        QVERIFY(!tool_->canRepeat());
        tool_->strokeTakenBack(false);
        QVERIFY(tool_->canRepeat());
    }

    /// A stroke that is cancelled on the way to its start cut nothing: the stroke before it is still the last one, and
    /// what was undone before can still be redone.
    void aStrokeThatNeverTurnedTheSpindleIsNone() {
        tool_->setSettings({.depthOfCut = 1.0, .speed = 20.0, .stepOver = 3.0});
        const auto draw = [this](double y, bool giveUp) {
            tool_->press(left({-4.0, y, top}));
            if (giveUp) rest(20);
            tool_->move(over({4.0, y, top}, Qt::LeftButton));
            if (giveUp) tool_->key(Qt::Key_Escape, Qt::NoModifier);
            tool_->release(left({4.0, y, top}));
        };
        const auto isRepeatedAt = [this](double y) {
            if (!tool_->repeat(MillTool::Repetition::left).isEmpty()) return false; // towards +Y, as it goes to +X
            bool cut = false, there = true;
            for (int tick = 0; tick < 3000; ++tick) {
                const glm::dvec3 tip = read();
                there = there && (!cutting_ || std::abs(tip.y - y) < 0.03);
                cut = cut || cutting_;
            }
            return cut && there;
        };
        draw(12.0, false);
        rest();
        draw(-16.0, true);
        QVERIFY(!cutting_ && tool_->canRepeat());
        rest();
        QVERIFY(isRepeatedAt(15.0));
        tool_->strokeTakenBack(true);
        tool_->strokeTakenBack(true);
        QVERIFY(!tool_->canRepeat());
        draw(-16.0, true);
        QVERIFY(!tool_->canRepeat());
        rest();
        tool_->strokeTakenBack(false);
        QVERIFY(isRepeatedAt(15.0));
        // Strokes that wait for another one to be cut have not turned the spindle.
        draw(9.0, false);
        for (int tick = 0; tick < 1000 || !cutting_; ++tick) read();
        draw(-16.0, false);
        draw(-12.0, true);
        rest();
        QVERIFY(isRepeatedAt(12.0));
    }

    /// Waiting strokes are drawn as strokes: no line is drawn where the tool moves from one to the next.
    void strokesThatWaitAreSeenEachByItself() {
        tool_->setSettings({.depthOfCut = 1.0, .speed = 20.0});
        const auto draw = [this](double y) {
            tool_->press(left({-4.0, y, top}));
            for (int i = 1; i <= 4; ++i) tool_->move(over({-4.0 + 2.0 * i, y, top}, Qt::LeftButton));
            tool_->release(left({4.0, y, top}));
        };
        draw(12.0);
        for (int tick = 0; tick < 1000 || !cutting_; ++tick) read();
        draw(16.0);
        draw(9.0);
        rest(10);
        const PlaceChains plans = tool_->plans();
        QCOMPARE(plans.size(), std::size_t{3});
        const double rows[] = {12.0, 16.0, 9.0};
        for (std::size_t i = 0; i < plans.size(); ++i) {
            QVERIFY(plans[i].size() > 1);
            for (const glm::dvec3& place : plans[i]) QVERIFY(std::abs(place.y - rows[i]) < 0.05);
            QVERIFY(std::abs(plans[i].back().x - 4.0) < 1e-6);
        }
        rest(12000);
        QVERIFY(tool_->plans().empty());
    }

    void escapeAndLeavingEndTheStrokeSafely_data() {
        QTest::addColumn<bool>("escape");
        QTest::newRow("Esc") << true;
        QTest::newRow("pointer left") << false;
    }
    void escapeAndLeavingEndTheStrokeSafely() {
        QFETCH(bool, escape);
        QSignalSpy ends(tool_.get(), &MillTool::strokeEnds), leaves(tool_.get(), &MillTool::leaveRequested);
        tool_->press(left({0.0, 12.0, top}));
        const glm::dvec3 where = rest();
        QVERIFY(cutting_);
        QVERIFY(tool_->escapeMeaning().contains(QStringLiteral("drop what it has not milled yet")));
        if (escape)
            QVERIFY(tool_->key(Qt::Key_Escape, Qt::NoModifier));
        else
            tool_->leave();
        QCOMPARE(ends.count(), 1);
        read();
        QVERIFY(!cutting_);
        QCOMPARE(leaves.count(), 0); // only the stroke was ended
        const glm::dvec3 lifted = rest();
        QVERIFY(std::hypot(lifted.x - where.x, lifted.y - where.y) < 1e-6);
        QCOMPARE(lifted.z, top + hoverClearance);
        QCOMPARE(tool_->escapeMeaning(), QStringLiteral("Esc: stop milling"));
        tool_->move(over({5.0, 12.0, top}, Qt::LeftButton)); // the button is still down, but does not begin a stroke
        rest();
        QVERIFY(!cutting_);
        tool_->key(Qt::Key_Escape, Qt::NoModifier);
        QCOMPARE(leaves.count(), 1);
    }

    void theKeyboardAloneMills() {
        tool_->move(over({0.0, 12.0, top})); // the eye is at the front: Up leads to the back, +y
        const glm::dvec3 start = rest();
        QVERIFY(tool_->key(Qt::Key_Right, Qt::NoModifier));
        QVERIFY(tool_->key(Qt::Key_Up, Qt::ControlModifier));
        QVERIFY(glm::distance(rest(), start + glm::dvec3(edge, 10.0 * edge, 0.0)) < 1e-6);
        QSignalSpy begins(tool_.get(), &MillTool::strokeBegins), ends(tool_.get(), &MillTool::strokeEnds);
        QVERIFY(tool_->key(Qt::Key_Space, Qt::NoModifier));
        QCOMPARE(begins.count(), 1);
        for (int i = 0; i < 12; ++i) tool_->key(Qt::Key_PageDown, Qt::NoModifier);
        const glm::dvec3 deep = rest();
        QVERIFY(cutting_);
        QVERIFY(std::abs(deep.z - (start.z - 12.0 * edge)) < 1e-6);
        tool_->key(Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(glm::distance(rest(), deep - glm::dvec3(0.1 * edge, 0.0, 0.0)) < 1e-6);
        tool_->move(over({9.0, 9.0, top})); // the pointer has no effect meanwhile
        QVERIFY(glm::distance(rest(), deep - glm::dvec3(0.1 * edge, 0.0, 0.0)) < 1e-6);
        tool_->key(Qt::Key_Space, Qt::NoModifier);
        QCOMPARE(ends.count(), 1);
        QVERIFY(rest().z >= top + hoverClearance - 1e-9);
        QVERIFY(!cutting_);
    }

    /// Depth of the stroke for each pressure, below the top or into the plateau.
    void aPenPressesAsDeepAsItsPressure_data() {
        QTest::addColumn<double>("pressure");
        for (const double pressure : {0.1, 0.25, 0.5, 1.0}) QTest::addRow("%g", pressure) << pressure;
    }
    void aPenPressesAsDeepAsItsPressure() {
        QFETCH(double, pressure);
        tool_->setSettings({.depthOfCut = 1.6, .press = 2.0});
        tool_->press(pen({0.0, 12.0, top}, pressure));
        QCOMPARE(rest().z, top - 1.6 * pressure);
        tool_->move(penMoved({2.0, 12.0, top}, 0.5 * pressure)); // less pressure on the way
        QVERIFY(std::abs(rest().z - (top - 0.8 * pressure)) < 1e-6);
        tool_->release(pen({2.0, 12.0, top}, 0.0));
        QVERIFY(rest().z >= top + hoverClearance - 1e-9); // the release, without pressure, cut nothing
        tool_->setSettings({.rule = DepthRule::part, .depthOfCut = 1.6, .press = 2.0});
        tool_->press(pen({0.0, 0.0, top}, pressure));
        QVERIFY(std::abs(rest().z - (plateauZ - 2.0 * pressure)) < 1e-6);
        tool_->release(pen({0.0, 0.0, top}, 0.0));
        // A mouse still mills at full depth.
        rest();
        tool_->setSettings({.depthOfCut = 1.6});
        tool_->press(left({0.0, 12.0, top}));
        QCOMPARE(rest().z, top - 1.6);
    }

    /// 20 mm/s at full pressure: half of it sinks 10 mm/s, down to the depth of cut, without any further event.
    void aPenSinksTheTool() {
        tool_->setSettings({.depthOfCut = 3.0, .pen = PenRule::sink, .sinkSpeed = 20.0});
        QElapsedTimer clock;
        clock.start();
        tool_->press(pen({0.0, 12.0, top}, 0.5));
        QVERIFY(std::abs(rest().z - top) < 1e-6); // no time has passed for the window
        QTest::qWait(150);
        const double passed = 1e-3 * static_cast<double>(clock.elapsed());
        const double sunk = top - rest().z;
        QVERIFY2(sunk > 0.3 && sunk <= 10.0 * passed + 1e-6, qPrintable(QString::number(sunk)));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(rest(200).z - (top - 3.0)) < 1e-6, 30000);
        QTest::qWait(50);
        QCOMPARE(rest().z, top - 3.0); // and no deeper
    }

    void aPenLeansTheStrokeAndItsRepetition() {
        tool_->setSettings({.depthOfCut = 1.0, .stepOver = 3.0});
        const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.2, 1.0));
        ViewportEvent event = pen({0.0, 12.0, top}, 1.0);
        event.pen->axis = axis;
        tool_->press(event);
        rest();
        QVERIFY(glm::distance(axis_, axis) < 1e-6);
        QVERIFY(tool_->penLeans());
        event = penMoved({6.0, 12.0, top}, 1.0);
        event.pen->axis = axis;
        tool_->move(event);
        rest();
        tool_->release(pen({6.0, 12.0, top}, 0.0));
        rest();
        QCOMPARE(axis_, glm::dvec3(0.0, 0.0, 1.0)); // upright between strokes
        QVERIFY(tool_->repeat(MillTool::Repetition::right).isEmpty());
        glm::dvec3 farthest(0.0, 0.0, 1.0);
        for (int tick = 0; tick < 4000; ++tick) {
            read();
            if (cutting_ && axis_.z < farthest.z) farthest = axis_;
        }
        QVERIFY(glm::distance(farthest, axis) < 1e-3);
    }

    void theEraserEndsTheStrokeAboveTheWorkpiece() {
        QSignalSpy ends(tool_.get(), &MillTool::strokeEnds);
        tool_->press(pen({0.0, 12.0, top}, 1.0));
        rest();
        QVERIFY(cutting_);
        ViewportEvent event = penMoved({0.0, 12.0, top}, 0.0);
        event.pen->eraser = true;
        tool_->move(event);
        QCOMPARE(ends.count(), 1);
        QVERIFY(std::abs(rest().z - (block.high.z + hoverClearance)) <
                1e-6); // above the grid, not just the stock below
        QVERIFY(!cutting_);
        event.button = Qt::LeftButton;
        tool_->press(event);
        rest();
        QVERIFY(!cutting_);
        tool_->move(over({0.0, 12.0, top}));
        QCOMPARE(rest().z, top + hoverClearance);
    }

    void arrowsFollowTheView() {
        QCOMPARE(keyStep(Qt::Key_Up, {0.0, 1.0, 0.0}), glm::dvec3(0.0, 1.0, 0.0));
        QCOMPARE(keyStep(Qt::Key_Right, {0.0, 1.0, 0.0}), glm::dvec3(1.0, 0.0, 0.0));
        QCOMPARE(keyStep(Qt::Key_Up, {-0.9, 0.1, -0.4}), glm::dvec3(-1.0, 0.0, 0.0)); // seen from the right
        QCOMPARE(keyStep(Qt::Key_Right, {-0.9, 0.1, -0.4}), glm::dvec3(0.0, 1.0, 0.0));
        QCOMPARE(keyStep(Qt::Key_Left, {0.0, 0.0, -1.0}), glm::dvec3(-1.0, 0.0, 0.0)); // from above
        QCOMPARE(keyStep(Qt::Key_A, {0.0, 1.0, 0.0}), glm::dvec3(0.0));
    }

private:
    glm::dvec3 read() {
        const StylusState state = stylus_->read(time_ += 0.001);
        cutting_ = (state.buttons & 1U) != 0;
        axis_ = state.pose.rotation * glm::dvec3(0.0, 0.0, 1.0);
        return state.pose.position;
    }
    glm::dvec3 rest(int ticks = 3000) {
        glm::dvec3 tip(0.0);
        for (int i = 0; i < ticks; ++i) tip = read();
        return tip;
    }

    std::unique_ptr<SimulatedStylus> stylus_;
    std::unique_ptr<MillTool> tool_;
    double time_ = 0.0;
    bool cutting_ = false;
    glm::dvec3 axis_{0.0, 0.0, 1.0};
};

BURIN_TEST(TestMillTool, QCoreApplication)

} // namespace burin::tst_mill_tool

#include "tst_mill_tool.moc"
