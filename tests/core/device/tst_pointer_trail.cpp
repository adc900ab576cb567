// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Strokes of a pointer that reports whole pixels only, and the motions that the simulated stylus makes of them.
#include "core/device/simulated_stylus.h"
#include "tests/test_program.h"

#include <QTest>

#include <functional>

namespace burin::tst_pointer_trail {

namespace {

constexpr double period = 0.001; // s, of the loop
constexpr double limit = 200.0;  // mm/s, of the tool
constexpr double level = -2.0;   // mm, z of the strokes
constexpr double pi = 3.14159265358979323846;

/// Position of the pointer after a number of millimetres of hand movement.
using Shape = std::function<glm::dvec2(double)>;

struct Pointer {
    double pixel = 0.15; ///< mm
    int rate = 1000;     ///< reports per second
    double speed = 0.0;  ///< mm/s
};

struct Stroke {
    std::vector<glm::dvec3> goals;
    std::vector<glm::dvec3> tool; ///< position at each tick from when the tool was down until it came to the end
};

glm::dvec2 heading(double degrees) {
    return {std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0)};
}

glm::dvec3 reported(const glm::dvec2& place, double pixel) {
    return {pixel * std::floor(place.x / pixel), pixel * std::floor(place.y / pixel), level};
}

/// A complete stroke: down, along the shape as the pointer reports it, to its end.
Stroke draw(const Shape& shape, double length, const Pointer& pointer) {
    SimulatedStylus stylus({0.0, 0.0, 20.0});
    (void)stylus.open();
    Stroke stroke{{reported(shape(0.0), pointer.pixel)}, {}};
    StylusTarget target{
        .tip = stroke.goals.front(), .maximumSpeed = limit, .cutting = true, .grain = std::sqrt(2.0) * pointer.pixel};
    stylus.request(target);
    double time = 0.0;
    for (int tick = 0; tick < 2000; ++tick) (void)stylus.read(time += period);
    const double begun = time;
    int reports = 0;
    bool released = false;
    while (!released || stylus.strokeUnderWay()) {
        for (; !released && reports <= (time - begun) * pointer.rate; ++reports) {
            const double way = std::min(length, pointer.speed * reports / pointer.rate);
            target.tip = reported(shape(way), pointer.pixel);
            if (target.tip != stroke.goals.back()) {
                stylus.request(target);
                stroke.goals.push_back(target.tip);
            }
            released = way >= length;
            if (released) stylus.request({.tip = target.tip + glm::dvec3(0.0, 0.0, 20.0), .finishStroke = true});
        }
        const StylusState state = stylus.read(time += period);
        if ((state.buttons & 1U) != 0) stroke.tool.push_back(state.pose.position);
    }
    return stroke;
}

double distanceTo(const glm::dvec3& place, const std::vector<glm::dvec3>& line) {
    double nearest = glm::distance(place, line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const glm::dvec3 way = line[i] - line[i - 1];
        const double share = glm::clamp(glm::dot(place - line[i - 1], way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(place, line[i - 1] + share * way));
    }
    return nearest;
}

double farthestFrom(const std::vector<glm::dvec3>& line, const Stroke& stroke) {
    double farthest = 0.0;
    for (const glm::dvec3& tip : stroke.tool) farthest = std::max(farthest, distanceTo(tip, line));
    return farthest;
}

void checkBounds(const Stroke& stroke) {
    glm::dvec3 before(0.0);
    for (std::size_t i = 1; i < stroke.tool.size(); ++i) {
        const glm::dvec3 velocity = (stroke.tool[i] - stroke.tool[i - 1]) / period;
        QVERIFY2(glm::length(velocity) <= limit * 1.000001, qPrintable(QString::number(glm::length(velocity))));
        const double change = glm::length(velocity - before);
        QVERIFY2(change <= SimulatedStylus::acceleration * period + 0.6, qPrintable(QString::number(change)));
        before = velocity;
    }
}

void addPointers() {
    QTest::addColumn<double>("pixel");
    QTest::addColumn<int>("rate");
    for (const double pixel : {0.02, 0.05, 0.15, 0.3})
        for (const int rate : {125, 500, 1000}) QTest::addRow("%g mm at %d Hz", pixel, rate) << pixel << rate;
}

} // namespace

class TestPointerTrail : public QObject {
    Q_OBJECT

private slots:
    /// If the pointer is faster than the tool may be, the tool moves at its speed limit, whatever the heading.
    void aSlantedSweepGoesAtTheLimit_data() { addPointers(); }
    void aSlantedSweepGoesAtTheLimit() {
        QFETCH(double, pixel);
        QFETCH(int, rate);
        for (double degrees = 0.0; degrees < 360.0; degrees += 13.3) {
            const glm::dvec2 along = heading(degrees);
            const glm::dvec2 from(0.013, 0.027); // offset from a pixel's corner
            const Stroke stroke =
                draw([&](double way) { return from + way * along; }, 80.0, {pixel, rate, 1.3 * limit});
            const auto progress = [&](const glm::dvec3& tip) { return glm::dot(glm::dvec2(tip) - from, along); };
            double slowest = limit;
            std::size_t entered = 0, left = 0;
            for (std::size_t i = 1; i < stroke.tool.size(); ++i) {
                const double step = progress(stroke.tool[i]) - progress(stroke.tool[i - 1]);
                QVERIFY2(step >= -1e-9, qPrintable(QString("back by %1 mm at %2°").arg(-step).arg(degrees)));
                if (progress(stroke.tool[i]) < 15.0 || progress(stroke.tool[i]) > 65.0) continue;
                slowest = std::min(slowest, step / period);
                if (entered == 0) entered = i;
                left = i;
            }
            const double mean = (progress(stroke.tool[left]) - progress(stroke.tool[entered])) /
                                (period * static_cast<double>(left - entered));
            const QString figures = QString("%1 mm/s, at least %2 mm/s, at %3°").arg(mean).arg(slowest).arg(degrees);
            QVERIFY2(mean >= 0.9 * limit && slowest >= 0.8 * limit, qPrintable(figures));
            const double off = farthestFrom(stroke.goals, stroke);
            QVERIFY2(off <= pixel, qPrintable(QString("%1 mm off at %2°").arg(off).arg(degrees)));
            QVERIFY(glm::distance(stroke.tool.back(), stroke.goals.back()) < 1e-9);
            checkBounds(stroke);
        }
    }

    /// Between straight legs, slow and fast: a change of direction that pixels cannot explain must not be cut short.
    void cornersAreKept_data() { addPointers(); }
    void cornersAreKept() {
        QFETCH(double, pixel);
        QFETCH(int, rate);
        for (const double speed : {10.0, 40.0, 150.0, 400.0})
            for (double degrees = 3.0; degrees < 360.0; degrees += 47.0)
                for (const double turn : {40.0, -60.0, 90.0, 120.0, -150.0, 180.0}) {
                    const double leg = std::min(20.0, speed);
                    const glm::dvec2 in = heading(degrees), out = heading(degrees + turn), corner = leg * in;
                    const Shape shape = [&](double way) { return way < leg ? way * in : corner + (way - leg) * out; };
                    const Stroke stroke = draw(shape, 2.0 * leg, {pixel, rate, speed});
                    const double off = farthestFrom(stroke.goals, stroke);
                    const glm::dvec3 tip = *std::ranges::max_element(stroke.goals, {}, [&](const glm::dvec3& goal) {
                        return glm::dot(glm::dvec2(goal) - corner, in - out); // the goal that protrudes most
                    });
                    const double before = distanceTo(tip, stroke.tool);
                    const QString where = QString("%1 mm off, %2 mm before the corner at %3°, turn %4°, %5 mm/s")
                                              .arg(off)
                                              .arg(before)
                                              .arg(degrees)
                                              .arg(turn)
                                              .arg(speed);
                    QVERIFY2(off <= std::max(pixel, TrailFollower::tolerance + 0.005), qPrintable(where));
                    if (std::abs(turn) > 45.0)
                        QVERIFY2(before <= std::max(pixel, 2.0 * TrailFollower::tolerance), qPrintable(where));
                    checkBounds(stroke);
                }
    }

    /// At the speed of a hand on a circle the path becomes round: within a pixel of the reported one.
    void aCircleStaysWhereItIs_data() { addPointers(); }
    void aCircleStaysWhereItIs() {
        QFETCH(double, pixel);
        QFETCH(int, rate);
        for (const double radius : {2.0, 5.0, 15.0, 40.0}) {
            const Shape circle = [&](double way) {
                return radius * glm::dvec2(std::cos(way / radius), std::sin(way / radius));
            };
            const Stroke stroke = draw(circle, 2.0 * pi * radius, {pixel, rate, 300.0});
            const double off = farthestFrom(stroke.goals, stroke);
            const QString figures = QString("radius %1 mm: %2 mm off").arg(radius).arg(off);
            QVERIFY2(off <= std::max(pixel, TrailFollower::tolerance), qPrintable(figures));
            const double time = period * static_cast<double>(stroke.tool.size());
            if (radius > 30.0) QVERIFY(2.0 * pi * radius / time > 0.6 * limit); // including acceleration and braking
            checkBounds(stroke);
        }
    }
};

BURIN_TEST(TestPointerTrail, NoApplication)

} // namespace burin::tst_pointer_trail

#include "tst_pointer_trail.moc"
