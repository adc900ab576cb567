// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The pointer on lines and arcs of a path, tested against the formulas of circle and helix.
#include "tests/test_program.h"
#include "ui/input/path_hand.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace burin::tst_path_hand {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double radius = 30.0;              // mm
constexpr glm::dvec3 centre(5.0, -3.0, 2.0); // mm

/// The point at an angle of the circle about +Z, raised by `rise`.
glm::dvec3 onCircle(double angle, double rise = 0.0, double atRadius = radius) {
    return centre + glm::dvec3(atRadius * std::cos(angle), atRadius * std::sin(angle), rise);
}

/// Projection at ten pixels per millimetre, straight from above.
QPointF fromAbove(const glm::dvec3& place) {
    return {10.0 * place.x, -10.0 * place.y};
}

/// Projection of a pinhole camera at the front left, 300 mm away.
QPointF fromAside(const glm::dvec3& place) {
    const glm::dvec3 eye(-120.0, -220.0, 160.0), ahead = glm::normalize(centre - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, {0.0, 0.0, 1.0})), up = glm::cross(right, ahead);
    const glm::dvec3 way = place - eye;
    const double scale = 1200.0 / glm::dot(way, ahead);
    return {600.0 + scale * glm::dot(way, right), 400.0 - scale * glm::dot(way, up)};
}

/// An arc from the angle `start`, anticlockwise for a positive sweep, rising linearly.
std::vector<HandPoint> arcPath(double start, double sweep, double rise) {
    const glm::dvec3 from = onCircle(start), to = onCircle(start + sweep, rise);
    return {{from, true, {}}, {to, true, Arc{from, to, centre, 2, sweep < 0.0}}};
}

ViewportEvent at(const QPointF& pointer, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ViewportEvent event;
    event.position = pointer;
    event.button = Qt::LeftButton;
    event.buttons = Qt::LeftButton;
    event.modifiers = modifiers;
    event.rayOrigin = {0.1 * pointer.x(), -0.1 * pointer.y(), 500.0};
    event.rayDirection = {0.0, 0.0, -1.0};
    event.parallel = true;
    return event;
}

/// What a click chooses; nullopt if it chooses nothing.
std::optional<PathPlace> chosenBy(PathHand& hand, const QPointF& pointer) {
    std::optional<PathPlace> chosen;
    const auto connection =
        QObject::connect(&hand, &PathHand::chosen, [&](const PathPlace& place, bool) { chosen = place; });
    hand.press(at(pointer));
    hand.release(at(pointer));
    QObject::disconnect(connection);
    return chosen;
}

} // namespace

class TestPathHand : public QObject {
    Q_OBJECT

private slots:
    /// From above, the point nearest to a pointer inside or outside a circle is where the pointer's radius meets the
    /// circle.
    void onACircleTheNearestPlaceLiesOnThePointersRadius_data() {
        QTest::addColumn<double>("sweep");
        for (const double sweep : {0.3, -0.9, 2.4, -3.1, 4.0, 2.0 * pi}) QTest::addRow("%g rad", sweep) << sweep;
    }
    void onACircleTheNearestPlaceLiesOnThePointersRadius() {
        QFETCH(double, sweep);
        for (const double start : {0.2, 1.9, -2.5}) {
            PathHand hand(fromAbove);
            hand.setPoints(arcPath(start, sweep, 0.0));
            for (const double share : {0.02, 0.31, 0.5, 0.77, 0.98})
                for (const double off : {-0.6, 0.0, 0.7}) { // mm; the pointer's reach is 0.8
                    const auto place = chosenBy(hand, fromAbove(onCircle(start + share * sweep, 0.0, radius + off)));
                    QVERIFY(place);
                    QCOMPARE(place->piece, std::size_t{0});
                    QVERIFY2(std::abs(place->share - share) < 1e-5, qPrintable(QString::number(place->share)));
                }
        }
    }

    /// In any view: a click on a drawn helix chooses that point, at its share of the turn.
    void onAHelixThePlaceUnderThePointerIsChosen() {
        for (const double sweep : {0.4, -1.3, 2.8, -3.0})
            for (const double rise : {0.0, 4.0, -9.0}) {
                PathHand hand(fromAside);
                hand.setPoints(arcPath(0.7, sweep, rise));
                for (const double share : {0.03, 0.29, 0.64, 0.97}) {
                    const glm::dvec3 meant = onCircle(0.7 + share * sweep, share * rise);
                    const auto place = chosenBy(hand, fromAside(meant));
                    QVERIFY(place);
                    QVERIFY2(std::abs(place->share - share) < 1e-4, qPrintable(QString::number(place->share)));
                }
            }
    }

    /// No line is drawn along the chord of an arc, so it cannot be picked.
    void theChordOfAnArcIsNotPicked() {
        PathHand hand(fromAbove);
        const std::vector<HandPoint> path = arcPath(0.0, 2.0, 0.0);
        hand.setPoints(path);
        for (const double share : {0.3, 0.5, 0.7})
            QVERIFY(!chosenBy(hand, fromAbove(glm::mix(path[0].place, path[1].place, share))));
    }

    /// Where a line and an arc are close to each other, the nearer one is chosen.
    void ofALineAndAnArcTheNearerIsChosen() {
        PathHand hand(fromAbove);
        std::vector<HandPoint> path = arcPath(0.5 * pi, -pi, 0.0); // from the top, past the right, to the bottom
        path.push_back({onCircle(-0.5 * pi) + glm::dvec3(-10.0, 0.0, 0.0), true, {}});
        hand.setPoints(path);
        QCOMPARE(chosenBy(hand, fromAbove(onCircle(-0.2)))->piece, std::size_t{0});
        const auto place = chosenBy(hand, fromAbove(onCircle(-0.5 * pi) + glm::dvec3(-4.0, 0.3, 0.0)));
        QCOMPARE(place->piece, std::size_t{1});
        QVERIFY(std::abs(place->share - 0.4) < 1e-5);
    }

    /// On a move of which only one end was recorded, that end is chosen.
    void whereNoHandWentTheEndOfTheHandIsChosen() {
        PathHand hand(fromAbove);
        std::vector<HandPoint> path = arcPath(0.0, 1.0, 0.0);
        path[0].usable = false;
        hand.setPoints(path);
        QCOMPARE(chosenBy(hand, fromAbove(onCircle(0.2)))->share, 1.0);
        path[1].usable = false;
        hand.setPoints(path);
        QVERIFY(!chosenBy(hand, fromAbove(onCircle(0.2))));
    }

    /// A handle is dragged instead of the path at the same position; a click there still selects the path.
    void handlesAreDraggedBeforeThePath() {
        PathHand hand(fromAbove);
        hand.setPoints({{{0, 0, 0}, true, {}}, {{40, 0, 0}, true, {}}});
        hand.setHandles({{10, 0, 0}, {20, 0, 0}});
        std::optional<std::size_t> dropped;
        glm::dvec3 by(0.0);
        connect(&hand, &PathHand::handleDropped, &hand, [&](std::size_t handle, const glm::dvec3& way) {
            dropped = handle;
            by = way;
        });
        QSignalSpy others(&hand, &PathHand::dropped);
        const auto drag = [&](const glm::dvec3& from, const glm::dvec3& to) {
            hand.press(at(fromAbove(from)));
            hand.move(at(fromAbove(to)));
            hand.release(at(fromAbove(to)));
        };
        drag({20.3, 0.2, 0}, {22.3, 3.2, 0});
        QCOMPARE(dropped, std::optional<std::size_t>(1));
        QVERIFY(glm::distance(by, {2.0, 3.0, 0.0}) < 1e-9);
        QCOMPARE(others.count(), 0);
        drag({15, 0, 0}, {15, 3, 0}); // between them: the path
        QCOMPARE(others.count(), 1);
        const auto place = chosenBy(hand, fromAbove({20.0, 0.2, 0}));
        QVERIFY(place && std::abs(place->share - 0.5) < 1e-5);
    }

    /// A right click asks for the menu of the point; a right drag is left to the camera.
    void aRightClickAsksForTheMenu() {
        PathHand hand(fromAbove);
        hand.setPoints({{{0, 0, 0}, true, {}}, {{40, 0, 0}, true, {}}});
        std::vector<double> asked;
        connect(&hand, &PathHand::menuRequested, &hand,
                [&](const PathPlace& place, const QPointF&) { asked.push_back(place.share); });
        const auto rightly = [&](const glm::dvec3& from, const glm::dvec3& to) {
            ViewportEvent press = at(fromAbove(from)), release = at(fromAbove(to));
            press.button = release.button = Qt::RightButton;
            press.buttons = Qt::RightButton;
            release.buttons = Qt::NoButton;
            return hand.press(press) || hand.release(release);
        };
        QVERIFY(!rightly({10, 0.3, 0}, {10, 0.3, 0}));
        QCOMPARE(asked.size(), std::size_t{1});
        QVERIFY(std::abs(asked.front() - 0.25) < 1e-5);
        QVERIFY(!rightly({10, 0.3, 0}, {13, 0.3, 0}));
        QVERIFY(!rightly({10, 9, 0}, {10, 9, 0})); // beside the path
        QCOMPARE(asked.size(), std::size_t{1});
    }

    /// In each state Esc does what the status line says; where it does nothing, the key is left to others.
    void escapeDoesWhatItSays() {
        PathHand hand(fromAbove);
        hand.setPoints(arcPath(0.0, 1.0, 0.0));
        QSignalSpy cleared(&hand, &PathHand::cleared), givenUp(&hand, &PathHand::givenUp),
            told(&hand, &PathHand::stateChanged);
        QCOMPARE(hand.escapeMeaning(), QString());
        QVERIFY(!hand.key(Qt::Key_Escape, Qt::NoModifier));
        QCOMPARE(cleared.count(), 0);

        hand.setChosen(true);
        QCOMPARE(told.count(), 1);
        QCOMPARE(hand.escapeMeaning(), QStringLiteral("Esc: clear the selection"));
        QVERIFY(hand.key(Qt::Key_Escape, Qt::NoModifier));
        QCOMPARE(cleared.count(), 1);

        hand.press(at(fromAbove(onCircle(0.5)))); // a drag takes precedence
        hand.move(at(fromAbove(onCircle(0.5)) + QPointF(20.0, 0.0)));
        QCOMPARE(hand.escapeMeaning(), QStringLiteral("Esc: cancel"));
        QVERIFY(told.count() > 1);
        QVERIFY(hand.key(Qt::Key_Escape, Qt::NoModifier));
        QCOMPARE(givenUp.count(), 1);
        QCOMPARE(cleared.count(), 1);

        hand.setChosen(false);
        hand.setDrawing(3.0);
        QCOMPARE(hand.escapeMeaning(), QStringLiteral("Esc: cancel drawing"));
        QVERIFY(hand.key(Qt::Key_Escape, Qt::NoModifier));
        QCOMPARE(cleared.count(), 2);
    }
};

BURIN_TEST(TestPathHand, QCoreApplication)

} // namespace burin::tst_path_hand

#include "tst_path_hand.moc"
