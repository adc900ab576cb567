// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"
#include "core/path/hand_interval.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/scene/camera_view.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_path {

using namespace burin::testing;

namespace {

/// Makes a path of one straight groove along X, 1 mm deep.
bool makePath(WindowDriver& driver) {
    return makeReady(driver) && recordLine(driver, {-15, 0}, {15, 0}) && newPath(driver);
}

bool evaluatedAgain(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    return driver.waitFor(
        [&] { return !workbench.path.busy() && !workbench.path.outdated() && !workbench.path.problem(); });
}

/// The recorded cutting point nearest to a point in program coordinates, seen from above.
const PathPoint& pointNear(const Workbench& workbench, const glm::dvec2& place) {
    const std::vector<PathPoint>& points = workbench.path.evaluated()->path.points;
    const glm::dvec2 zero(workbench.workpiece.milling()->setup.workOffset);
    return *std::ranges::min_element(points, {}, [&](const PathPoint& point) {
        const bool cuts = point.kind == MoveKind::cut && point.sample >= 0;
        return cuts ? glm::distance(glm::dvec2(point.pose.tip) - zero, place) : 1e9;
    });
}

/// The distance from a point in the setup frame to the nearest move of the path, mm; arcs as chords.
double distanceToPath(const Workbench& workbench, const glm::dvec3& place) {
    const std::vector<PathPoint>& points = workbench.path.evaluated()->path.points;
    double nearest = 1e9;
    for (std::size_t i = 1; i < points.size(); ++i) {
        std::vector<glm::dvec3> way;
        const glm::dvec3& from = points[i - 1].pose.tip;
        if (points[i].arc)
            flatten({from, points[i].pose.tip, points[i].arc->centre, points[i].arc->axis, points[i].arc->clockwise},
                    0.01, way);
        else
            way.push_back(points[i].pose.tip);
        glm::dvec3 at = from;
        for (const glm::dvec3& to : way) {
            const glm::dvec3 along = to - at;
            const double square = glm::dot(along, along);
            const double share = square > 0.0 ? glm::clamp(glm::dot(place - at, along) / square, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, glm::distance(place, at + share * along));
            at = to;
        }
    }
    return nearest;
}

/// The length of the path on which the tool cuts, mm.
double cuttingLength(const Workbench& workbench) {
    const std::vector<PathPoint>& points = workbench.path.evaluated()->path.points;
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].kind == MoveKind::cut) length += glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
    return length;
}

/// Drags with the left button from corner to corner.
void drawAlong(WindowDriver& driver, Viewport& viewport, const std::vector<glm::dvec3>& corners, const char* picture) {
    QTest::mousePress(&viewport, Qt::LeftButton, {}, viewport.project(corners.front()).toPoint());
    for (std::size_t side = 1; side < corners.size(); ++side)
        for (int i = 1; i <= 20; ++i)
            QTest::mouseMove(&viewport,
                             viewport.project(glm::mix(corners[side - 1], corners[side], i / 20.0)).toPoint(), 5);
    driver.shoot(picture);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, viewport.project(corners.back()).toPoint());
}

std::vector<std::string> editsOf(const Workbench& workbench) {
    std::vector<std::string> ids;
    for (const Edit& edit : workbench.path.stored()->edits) ids.emplace_back(idOf(edit.parameters));
    return ids;
}

std::size_t placeOf(const Workbench& workbench, const char* id) {
    const std::vector<std::string> ids = editsOf(workbench);
    return static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin());
}

void drag(Viewport& viewport, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&viewport, from + (to - from) * i / 8, 10);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, to);
}

bool show(WindowDriver& driver, const QString& name) {
    auto* area = driver.visible<QScrollArea>("pathPage");
    auto* widget = driver.window().findChild<QWidget*>(name);
    if (area == nullptr || widget == nullptr) return false;
    area->ensureWidgetVisible(widget);
    QCoreApplication::processEvents();
    return true;
}

} // namespace

class TestWindowPath : public QObject {
    Q_OBJECT
private slots:
    void placesAreDraggedIntervalsDrawnAndEditsOrdered();
    BURIN_ONLY_IN_LONG_RUNS void anAreaIsDrawnAndEmptied();
    BURIN_ONLY_IN_LONG_RUNS void theMirrorsPlaneIsDrawn();
    void theWorstPlaceOfAnEditIsShown();
    BURIN_ONLY_IN_LONG_RUNS void aPointIsInsertedAndDragged();
};

void TestWindowPath::placesAreDraggedIntervalsDrawnAndEditsOrdered() {
    WindowDriver driver(QSize(1280, 920)); // as high a resolution as without the timeline
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(viewport != nullptr);
    const std::vector<std::string> before = editsOf(workbench);
    driver.shoot("23-path");

    // The creation of the path itself can be undone, and redo restores the same path.
    const std::int64_t made = workbench.path.stored()->id;
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return workbench.path.stored() == nullptr; }));
    QVERIFY(driver.waitFor([&] { return driver.visible<QAbstractButton>("newPathButton") != nullptr; }));
    driver.shoot("23-path-undone");
    driver.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(driver.waitFor([&] { return workbench.path.stored() != nullptr; }));
    QCOMPARE(workbench.path.stored()->id, made);
    QCOMPARE(editsOf(workbench), before);
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    QVERIFY(evaluatedAgain(driver));
    QVERIFY(driver.settle());

    // A point in the middle of the groove is dragged sideways by 4 mm, at its height.
    const PathPoint middle = pointNear(workbench, {0.0, 0.0});
    const glm::dvec3 aside = middle.pose.tip + glm::dvec3(0.0, 4.0, 0.0);
    drag(*viewport, viewport->project(middle.pose.tip).toPoint(), viewport->project(aside).toPoint());
    QVERIFY(driver.waitFor([&] { return placeOf(workbench, "move-points") < workbench.path.stored()->edits.size(); }));
    QVERIFY(placeOf(workbench, "move-points") < placeOf(workbench, "hold-out"));
    QVERIFY(evaluatedAgain(driver));
    const glm::dvec2 zero(workbench.workpiece.milling()->setup.workOffset);
    // Both ends of the drag are rounded to whole pixels, by half a pixel at most; the rest of the deviation is due to
    // smoothing.
    const QPointF pixels =
        viewport->project(middle.pose.tip + glm::dvec3(0.0, 1.0, 0.0)) - viewport->project(middle.pose.tip);
    const double pixel = 1.0 / std::hypot(pixels.x(), pixels.y()), missed = distanceToPath(workbench, aside);
    QVERIFY2(missed < pixel + 0.03, qPrintable(QStringLiteral("%1 mm, a pixel is %2 mm").arg(missed).arg(pixel)));
    const PathPoint& end = pointNear(workbench, {-14.0, 0.0}); // farther along the path than the falloff
    QVERIFY(std::abs(end.pose.tip.y - middle.pose.tip.y) < 0.5);
    driver.shoot("24-dragged");
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return editsOf(workbench) == before; }));
    QVERIFY(evaluatedAgain(driver));
    QVERIFY(std::abs(pointNear(workbench, {0.0, 0.0}).pose.tip.y - middle.pose.tip.y) < 0.05);

    const double straight = cuttingLength(workbench);

    QVERIFY(driver.settle()); // the pointer has the new points
    // Part of the path is chosen by two clicks and replaced by a stroke that goes round it.
    const PathPoint from = pointNear(workbench, {-6.0, 0.0}), to = pointNear(workbench, {6.0, 0.0});
    QTest::mouseClick(viewport, Qt::LeftButton, {}, viewport->project(from.pose.tip).toPoint());
    QVERIFY(workbench.path.selection() && workbench.path.selection()->first == workbench.path.selection()->last);
    const QPoint dot = viewport->mapTo(&driver.window(), viewport->project(from.pose.tip).toPoint());
    const auto isMarked = [&] { return driver.window().grab().toImage().pixelColor(dot).green() > 215; };
    QVERIFY(driver.waitFor(isMarked)); // yellow; the line is orange
    driver.shoot("25-chosen-place");
    // A moment nearby whose own point was removed by simplification can be chosen as well.
    const std::vector<PathPoint>& left = workbench.path.evaluated()->path.points;
    const Moment leftOut{from.source, from.sample + 5};
    QVERIFY(std::ranges::find(left, leftOut.tick, &PathPoint::sample) == left.end());
    workbench.path.clearSelection();
    QVERIFY(driver.waitFor([&] { return !isMarked(); }));
    workbench.path.select(leftOut);
    QVERIFY(driver.waitFor(isMarked));
    workbench.path.select({from.source, from.sample});
    QTest::mouseClick(viewport, Qt::LeftButton, Qt::ShiftModifier, viewport->project(to.pose.tip).toPoint());
    QVERIFY(workbench.path.selection()->last > workbench.path.selection()->first + 20);
    QVERIFY(driver.waitFor([&] { return driver.visible<QPushButton>("drawStretchButton")->isEnabled(); }));
    QVERIFY(driver.clickOn("drawStretchButton"));
    std::vector<glm::dvec3> corners{from.pose.tip, from.pose.tip + glm::dvec3(0.0, 5.0, 0.0),
                                    to.pose.tip + glm::dvec3(0.0, 5.0, 0.0), to.pose.tip};
    const auto replaced = [&] { return placeOf(workbench, "replace-stretch") < workbench.path.stored()->edits.size(); };
    drawAlong(driver, *viewport, corners, "25-drawing");
    QVERIFY(driver.waitFor(replaced));
    QVERIFY(evaluatedAgain(driver));
    const double length = cuttingLength(workbench);
    QVERIFY2(std::abs(length - straight - 10.0) < 1.0, qPrintable(QString::number(length - straight)));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return !replaced(); }));
    QVERIFY(evaluatedAgain(driver));
    // Drawn against the direction of the recording, it contains no segment twice.
    QVERIFY(driver.waitFor([&] { return driver.visible<QPushButton>("drawStretchButton")->isEnabled(); }));
    QVERIFY(driver.clickOn("drawStretchButton"));
    std::ranges::reverse(corners);
    drawAlong(driver, *viewport, corners, "25-drawing-back");
    QVERIFY(driver.waitFor(replaced));
    QVERIFY(evaluatedAgain(driver));
    QVERIFY2(std::abs(cuttingLength(workbench) - length) < 1.0,
             qPrintable(QString::number(cuttingLength(workbench) - length)));
    const glm::dvec3 along = glm::mix(corners[1], corners[2], 0.5);
    const PathPoint& drawn = pointNear(workbench, glm::dvec2(along) - zero);
    QVERIFY2(std::abs(drawn.pose.tip.y - along.y) < 0.3, qPrintable(QString::number(drawn.pose.tip.y - along.y)));
    driver.key(Qt::Key_Escape);

    // Edits are added from the menu, moved and removed; a wrong order is refused with one sentence.
    auto* add = driver.window().findChild<QAction*>("add-lead-in");
    QVERIFY(add != nullptr);
    add->trigger();
    QVERIFY(driver.waitFor([&] { return placeOf(workbench, "lead-in") < workbench.path.stored()->edits.size(); }));
    QVERIFY(placeOf(workbench, "lead-in") > placeOf(workbench, "fit-arcs") &&
            placeOf(workbench, "lead-in") < placeOf(workbench, "link"));
    QVERIFY(evaluatedAgain(driver));
    // The new edit is visible and has the focus.
    const QString card = QStringLiteral("edit%1Switch").arg(placeOf(workbench, "lead-in"));
    QVERIFY(driver.waitFor([&] { return driver.window().focusWidget() == driver.window().findChild<QWidget*>(card); }));
    driver.shoot("26-added");
    QVERIFY(!driver.window().focusWidget()->visibleRegion().isEmpty());
    const std::vector<std::string> ordered = editsOf(workbench);
    const QString later = QStringLiteral("edit%1Later").arg(placeOf(workbench, "lead-in"));
    QVERIFY(driver.waitFor([&] { return show(driver, later); }));
    QVERIFY(driver.clickOn(qPrintable(later)));
    QVERIFY(driver.waitFor([&] { return workbench.path.problem().has_value(); }));
    driver.shoot("26-wrong-order");
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return editsOf(workbench) == ordered && !workbench.path.problem(); }));
    QVERIFY(evaluatedAgain(driver));
    const QString remove = QStringLiteral("edit%1Remove").arg(placeOf(workbench, "replace-stretch"));
    QVERIFY(driver.waitFor([&] { return show(driver, remove); }));
    QVERIFY(driver.clickOn(qPrintable(remove)));
    QVERIFY(
        driver.waitFor([&] { return placeOf(workbench, "replace-stretch") == workbench.path.stored()->edits.size(); }));
    QVERIFY(evaluatedAgain(driver));

    // Edits that a new path replaces are not lost.
    const std::vector<std::string> kept = editsOf(workbench);
    QVERIFY(kept != before);
    workbench.path.makeNew();
    QVERIFY(driver.waitFor([&] { return editsOf(workbench) == before; }));
    QVERIFY(evaluatedAgain(driver));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return editsOf(workbench) == kept; }));
    QVERIFY(evaluatedAgain(driver));
}

void TestWindowPath::anAreaIsDrawnAndEmptied() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(viewport != nullptr);
    const double height = pointNear(workbench, {0.0, 0.0}).pose.tip.z;
    const glm::dvec2 zero(workbench.workpiece.milling()->setup.workOffset);

    // The new edit asks for its outline at once: a loop round the groove's right half, which the drawing does not
    // close.
    driver.window().findChild<QAction*>("add-remove-area")->trigger();
    const std::string outline =
        QStringLiteral("edit%1_outline_mm").arg(placeOf(workbench, "remove-area")).toStdString();
    QVERIFY(driver.waitFor([&] {
        auto* draw = driver.window().findChild<QAbstractButton*>(QString::fromStdString(outline + "_draw"));
        return draw != nullptr && draw->isChecked();
    }));
    QVERIFY(driver.settle());
    QVERIFY(viewport->hasFocus()); // Esc is handled by the drawing
    const std::vector<glm::dvec2> corners{{2.0, -6.0}, {20.0, -6.0}, {20.0, 6.0}, {2.0, 6.0}};
    const auto at = [&](const glm::dvec2& corner) {
        return viewport->project(glm::dvec3(zero + corner, height)).toPoint();
    };
    QTest::mousePress(viewport, Qt::LeftButton, {}, at(corners.front()));
    for (std::size_t side = 0; side + 1 < corners.size(); ++side)
        for (int i = 1; i <= 20; ++i)
            QTest::mouseMove(viewport, at(glm::mix(corners[side], corners[side + 1], i / 20.0)), 5);
    driver.shoot("27-area");
    QTest::mouseRelease(viewport, Qt::LeftButton, {}, at(corners.back()));
    QVERIFY(driver.waitFor([&] {
        const auto& area =
            std::get<RemoveArea>(workbench.path.stored()->edits[placeOf(workbench, "remove-area")].parameters);
        return area.outline.size() > 10;
    }));
    QVERIFY(evaluatedAgain(driver));
    double farthest = -1e9, nearest = 1e9;
    for (const PathPoint& point : workbench.path.evaluated()->path.points)
        if (point.kind == MoveKind::cut || point.kind == MoveKind::plunge) { // a ramp ends where the stroke begins
            farthest = std::max(farthest, point.pose.tip.x - zero.x);
            nearest = std::min(nearest, point.pose.tip.x - zero.x);
        }
    QVERIFY2(farthest > 1.5 && farthest < 2.5, qPrintable(QString::number(farthest)));
    QVERIFY(nearest < -14.0);
    driver.shoot("28-area-emptied");
    driver.key(Qt::Key_Z, Qt::ControlModifier); // the outline
    driver.key(Qt::Key_Z, Qt::ControlModifier); // the edit
    QVERIFY(driver.waitFor([&] { return placeOf(workbench, "remove-area") == workbench.path.stored()->edits.size(); }));
    QVERIFY(evaluatedAgain(driver));
}

void TestWindowPath::theMirrorsPlaneIsDrawn() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    auto* viewport = driver.visible<Viewport>("viewport");
    QVERIFY(viewport != nullptr);
    driver.window().findChild<QAction*>("add-mirror")->trigger();
    QVERIFY(driver.waitFor([&] { return placeOf(workbench, "mirror") < workbench.path.stored()->edits.size(); }));
    QVERIFY(evaluatedAgain(driver));
    const auto mirror = [&] {
        return std::get<Mirror>(workbench.path.stored()->edits[placeOf(workbench, "mirror")].parameters);
    };
    const glm::dvec3 zero = workbench.workpiece.milling()->setup.workOffset;
    QCOMPARE(mirror().at, workbench.workpiece.milling()->setup.stock.centre().x); // until the user changes it
    const auto drawLine = [&](const glm::dvec2& from, const glm::dvec2& to) {
        const double height = pointNear(workbench, {0.0, 0.0}).pose.tip.z;
        const auto at = [&](const glm::dvec2& place) {
            return viewport->project(glm::dvec3(glm::dvec2(zero) + place, height)).toPoint();
        };
        drag(*viewport, at(from), at(to));
    };
    const auto rightEnd = [&] {
        double farthest = -1e9;
        for (const PathPoint& point : workbench.path.evaluated()->path.points)
            if (point.kind == MoveKind::cut) farthest = std::max(farthest, point.pose.tip.x - zero.x);
        return farthest;
    };
    const double before = rightEnd();

    // By the shortcut: a line roughly along Y makes a plane across X.
    driver.key(Qt::Key_D, Qt::ControlModifier | Qt::AltModifier);
    const QString button = QStringLiteral("edit%1_at_mm_draw").arg(placeOf(workbench, "mirror"));
    auto* draw = driver.window().findChild<QAbstractButton*>(button);
    QVERIFY(draw != nullptr && !draw->toolTip().isEmpty());
    QVERIFY(driver.waitFor([&] { return draw->isChecked(); }));
    drawLine({3.5, -8.0}, {4.5, 8.0});
    QVERIFY(driver.waitFor([&] { return std::abs(mirror().at - zero.x - 4.0) < 0.3; }));
    QVERIFY(mirror().across == Mirror::Across::x);
    QVERIFY(evaluatedAgain(driver));
    QVERIFY2(std::abs(rightEnd() - before - 8.0) < 0.7, qPrintable(QString::number(rightEnd() - before)));
    driver.shoot("31-mirror");

    // By its button: a line along X makes a plane across Y. Esc leaves everything as it is.
    const QString again = QStringLiteral("edit%1_at_mm_draw").arg(placeOf(workbench, "mirror"));
    QVERIFY(driver.waitFor([&] { return show(driver, again); }));
    QVERIFY(driver.clickOn(qPrintable(again)));
    driver.key(Qt::Key_Escape);
    QVERIFY(driver.waitFor([&] { return !driver.window().findChild<QAbstractButton*>(again)->isChecked(); }));
    QVERIFY(mirror().across == Mirror::Across::x);
    QVERIFY(driver.clickOn(qPrintable(again)));
    drawLine({-10.0, 5.0}, {10.0, 5.0});
    QVERIFY(driver.waitFor([&] { return mirror().across == Mirror::Across::y; }));
    QVERIFY(std::abs(mirror().at - zero.y - 5.0) < 0.3);
    QVERIFY(evaluatedAgain(driver));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver.waitFor([&] { return mirror().across == Mirror::Across::x; }));
    QVERIFY(std::abs(mirror().at - zero.x - 4.0) < 0.3);
    QVERIFY(evaluatedAgain(driver));
}

/// The eye button on an edit's card centres the picture on the point of the edit's largest error.
void TestWindowPath::theWorstPlaceOfAnEditIsShown() {
    WindowDriver driver(QSize(1280, 920));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    QVERIFY(driver.settle());
    auto* viewport = driver.visible<Viewport>("viewport");
    const std::vector<EditReport>& reports = workbench.path.evaluated()->reports; // one for each edit: all are on
    std::size_t shown = 0;
    double found = 0.0; // mm from the worst points, at most
    for (std::size_t i = 0; i < reports.size(); ++i) {
        auto* eye = driver.window().findChild<QAbstractButton*>(QStringLiteral("edit%1Worst").arg(i));
        QVERIFY(eye != nullptr);
        QCOMPARE(eye->isEnabled(), reports[i].largestDeviation > 0.0);
        if (!(reports[i].largestDeviation > 0.0)) continue;
        eye->click();
        QVERIFY(glm::distance(viewport->cameraView().focus, reports[i].worstPlace) < 1e-9);
        // The timeline marks when it was milled, and the selection stays.
        QVERIFY(workbench.path.pointsElsewhere() && !workbench.path.selection());
        const std::optional<SourceInterval>& pointed = workbench.path.pointed();
        const auto point = pointAt(workbench.path.evaluated()->path, {pointed->source, pointed->first});
        if (point) found = std::max(found, glm::distance(point->pose.tip, reports[i].worstPlace));
        ++shown;
    }
    QVERIFY(shown > 0);
    QVERIFY2(found > 0.0 && found < 0.5, qPrintable(QString::number(found)));
}

/// By the menu of a right click, then dragged at its mark, also a second time; each step is undone. By the key at the
/// selection.
void TestWindowPath::aPointIsInsertedAndDragged() {
    WindowDriver driver(QSize(1280, 920));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makePath(driver));
    QVERIFY(evaluatedAgain(driver));
    QVERIFY(driver.settle());
    auto* viewport = driver.visible<Viewport>("viewport");
    const std::vector<std::string> before = editsOf(workbench);
    const glm::dvec3 middle = pointNear(workbench, {0.0, 0.0}).pose.tip;
    const auto edit = [&] {
        const std::size_t place = placeOf(workbench, "insert-point");
        const std::vector<Edit>& edits = workbench.path.stored()->edits;
        return place < edits.size() ? std::get_if<InsertPoint>(&edits[place].parameters) : nullptr;
    };
    QTest::mouseClick(viewport, Qt::RightButton, {}, viewport->project(middle).toPoint());
    QMenu* menu = nullptr;
    QVERIFY(driver.waitFor([&] { return (menu = driver.window().findChild<QMenu*>("pathPointMenu")) != nullptr; }));
    driver.shoot("27-point-menu");
    QTest::mouseClick(menu, Qt::LeftButton, {},
                      menu->actionGeometry(menu->findChild<QAction*>("insertPointHere")).center());
    QVERIFY(driver.waitFor([&] { return edit() != nullptr; }));
    QVERIFY(placeOf(workbench, "insert-point") < placeOf(workbench, "hold-out"));
    QVERIFY(workbench.path.selection() && workbench.path.selection()->first == edit()->at.tick);
    QVERIFY(evaluatedAgain(driver));
    const auto inserted = [&] {
        return workbench.path.evaluated()->reports[placeOf(workbench, "insert-point")].inserted.front();
    };
    QVERIFY(glm::distance(inserted(), middle) < 0.3); // a pixel, and the smoothing
    QVERIFY(driver.settle());

    glm::dvec3 wanted = inserted();
    for (const glm::dvec3& by : {glm::dvec3(0, 4, 0), glm::dvec3(2, 1, 0)}) {
        wanted += by;
        drag(*viewport, viewport->project(inserted()).toPoint(), viewport->project(inserted() + by).toPoint());
        QVERIFY(evaluatedAgain(driver));
        QVERIFY(driver.settle());
        QCOMPARE(editsOf(workbench).size(), before.size() + 1); // the same edit
        QVERIFY2(glm::distance(inserted(), wanted) < 0.4, qPrintable(QString::number(edit()->by.y)));
        QVERIFY(distanceToPath(workbench, inserted()) < 0.1);
    }
    driver.shoot("27-point-dragged");
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(edit() != nullptr && edit()->by == glm::dvec3(0.0));
    driver.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(editsOf(workbench) == before);
    QVERIFY(evaluatedAgain(driver));
    QVERIFY(driver.settle());

    QTest::mouseClick(viewport, Qt::LeftButton, {}, viewport->project(middle).toPoint());
    QVERIFY(driver.waitFor([&] { return menuAction(driver, "insertPointAction")->isEnabled(); }));
    viewport->setFocus();
    driver.key(Qt::Key_Insert);
    QVERIFY(driver.waitFor([&] { return edit() != nullptr; }));
    QVERIFY(evaluatedAgain(driver));
    QVERIFY(glm::distance(inserted(), middle) < 0.3);
}

BURIN_TEST(TestWindowPath, QApplication)

} // namespace burin::tst_window_path

#include "tst_window_path.moc"
