// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "plugins/devices/input_events/pen_mapping.h"
#include "plugins/devices/input_events/tablet_reader.h"
#include "tests/plugins/virtual_input.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

#include <cmath>

namespace burin::tst_tablet {

using namespace burin::test;
using burin::input_events::Pen;
using burin::input_events::PenMapping;
using burin::input_events::TabletReader;

namespace {

/// A current tablet: 224 by 148 mm in steps of 0.01 mm, 8192 steps of pressure, tilt of -64 to 63 degrees.
auto tablet(int tiltResolution = 0) {
    return virtualInput({{ABS_X, 0, 22400, 0, 100},
                         {ABS_Y, 0, 14800, 0, 100},
                         {ABS_PRESSURE, 0, 8191},
                         {ABS_TILT_X, -64, 63, 0, tiltResolution},
                         {ABS_TILT_Y, -64, 63, 0, tiltResolution}},
                        {BTN_TOOL_PEN, BTN_TOUCH, BTN_STYLUS, BTN_STYLUS2});
}

/// Feeds one report. Returns true if it was complete.
bool tell(TabletReader& reader, std::initializer_list<input_event> events) {
    for (const input_event& event : events)
        if (reader.take(event)) return false;
    return reader.take(eventOf(EV_SYN, SYN_REPORT, 0));
}

} // namespace

/// Pen tablets: the state of the pen according to their events, and its effect on the tool.
class TestTablet : public QObject {
    Q_OBJECT
private slots:
    void aPenIsReadInMillimetres() {
        const auto device = tablet();
        TabletReader reader(*device);
        QVERIFY(reader.statesSize() && reader.leans());
        QCOMPARE(reader.width(), 224.0);
        QCOMPARE(reader.height(), 148.0);
        QVERIFY(tell(reader, {eventOf(EV_KEY, BTN_TOOL_PEN, 1), eventOf(EV_ABS, ABS_X, 22400),
                              eventOf(EV_ABS, ABS_Y, 0), eventOf(EV_KEY, BTN_TOUCH, 1), eventOf(EV_KEY, BTN_STYLUS2, 1),
                              eventOf(EV_ABS, ABS_PRESSURE, 8191), eventOf(EV_ABS, ABS_TILT_X, 30)}));
        const Pen& pen = reader.pen();
        QVERIFY(pen.near);
        QCOMPARE(pen.x, 112.0);
        QCOMPARE(pen.y, 74.0); // the far edge
        QCOMPARE(pen.pressure, 1.0);
        QCOMPARE(pen.buttons, 5U);
        QVERIFY(std::abs(pen.leanX - (30.5 * pi / 180.0)) < 1e-9); // the middle of -64 to 63 is -0.5
    }

    void aTiltThatStatesItsUnitIsTakenByIt() {
        const auto device = tablet(57); // a degree
        TabletReader reader(*device);
        (void)tell(reader, {eventOf(EV_KEY, BTN_TOOL_PEN, 1), eventOf(EV_ABS, ABS_TILT_Y, -64)});
        QVERIFY(std::abs(reader.pen().leanY - 63.5 / 57.0) < 1e-9);
    }

    void aReportCountsWhenItIsComplete() {
        const auto device = tablet();
        TabletReader reader(*device);
        (void)tell(reader, {eventOf(EV_KEY, BTN_TOOL_PEN, 1), eventOf(EV_ABS, ABS_X, 11200)});
        QCOMPARE(reader.pen().x, 0.0);
        QVERIFY(!reader.take(eventOf(EV_ABS, ABS_X, 0)));
        QCOMPARE(reader.pen().x, 0.0);
        QVERIFY(reader.take(eventOf(EV_SYN, SYN_REPORT, 0)));
        QCOMPARE(reader.pen().x, -112.0);
    }

    void aPenThatGoesTouchesNothing() {
        const auto device = tablet();
        TabletReader reader(*device);
        (void)tell(reader, {eventOf(EV_KEY, BTN_TOOL_PEN, 1), eventOf(EV_ABS, ABS_X, 5000),
                            eventOf(EV_KEY, BTN_TOUCH, 1), eventOf(EV_ABS, ABS_PRESSURE, 4000)});
        QCOMPARE(reader.pen().buttons, 1U);
        (void)tell(reader, {eventOf(EV_KEY, BTN_TOOL_PEN, 0)}); // without any other event
        QVERIFY(!reader.pen().near);
        QCOMPARE(reader.pen().buttons, 0U);
        QCOMPARE(reader.pen().pressure, 0.0);
        QCOMPARE(reader.pen().x, 50.0 - 112.0);
    }

    void aTabletWithoutResolutionIsAssumedToBe200MillimetresWide() {
        const auto device = virtualInput({{ABS_X, 0, 4000}, {ABS_Y, 0, 3000}, {ABS_PRESSURE, 0, 1023}}, {BTN_TOOL_PEN});
        TabletReader reader(*device);
        QVERIFY(!reader.statesSize() && !reader.leans());
        QCOMPARE(reader.width(), 200.0);
        QCOMPARE(reader.height(), 150.0);
    }

    /// Wherever the pen is put down, the tool moves there in a straight line, and not faster than allowed.
    void theToolFollowsNoFasterThanItMay() {
        QVERIFY(rc::check([] {
            PenMapping mapping;
            Pose before = mapping.advance({}, 0.0);
            Pen pen;
            pen.near = true;
            pen.x = *rc::gen::inRange(-200, 200);
            pen.y = *rc::gen::inRange(-200, 200);
            pen.pressure = *rc::gen::inRange(0, 1000) / 1000.0;
            pen.buttons = *rc::gen::inRange(0U, 2U);
            pen.leanX = *rc::gen::inRange(-80, 80) / 100.0;
            const int period = *rc::gen::inRange(1, 20); // ms
            for (int i = 0; i < 4000 / period; ++i) {
                const Pose now = mapping.advance(pen, 1e-3 * period);
                RC_ASSERT(glm::distance(now.position, before.position) <=
                          PenMapping::followSpeed * 1e-3 * period + 1e-9);
                before = now;
            }
            const double z = pen.buttons != 0 ? -10.0 * pen.pressure : 5.0;
            RC_ASSERT(glm::distance(before.position, glm::dvec3(pen.x, pen.y, z)) < 1e-3);
            const glm::dvec3 axis = before.rotation * glm::dvec3(0.0, 0.0, 1.0);
            RC_ASSERT(glm::distance(axis, glm::dvec3(std::sin(pen.leanX), 0.0, std::cos(pen.leanX))) < 1e-6);
        }));
    }

    /// With the usual assignment the map changes nothing; with another one, each axis does what it was given.
    void theAxesOfAPenAreAssigned() {
        const auto device = tablet();
        const TabletReader reader(*device);
        QVERIFY(rc::check([&] {
            Pen pen;
            pen.x = *rc::gen::inRange(-112, 113);
            pen.y = *rc::gen::inRange(-74, 75);
            pen.pressure = *rc::gen::inRange(0, 1001) / 1000.0;
            pen.leanX = *rc::gen::inRange(-100, 101) / 100.0;
            pen.leanY = *rc::gen::inRange(-100, 101) / 100.0;
            pen.buttons = *rc::gen::inRange(0U, 16U);
            const Pen same = mappedPen(pen, burin::input_events::penMap(), reader);
            RC_ASSERT(std::abs(same.x - pen.x) < 1e-9 && std::abs(same.y - pen.y) < 1e-9);
            RC_ASSERT(std::abs(same.pressure - pen.pressure) < 1e-9 && same.buttons == pen.buttons);
            RC_ASSERT(std::abs(same.leanX - pen.leanX) < 1e-9 && std::abs(same.leanY - pen.leanY) < 1e-9);
        }));
        AxisMap map = burin::input_events::penMap();
        map.axes[0].motion = AxisMotion::y; // the tablet is turned by a quarter
        map.axes[1] = {AxisMotion::x, true};
        map.axes[2].gain = 0.5;
        map.axes[3].motion = AxisMotion::none;
        map.buttons = {ButtonAction::none, ButtonAction::mill, ButtonAction::lift};
        Pen pen;
        pen.x = 56.0; // half of the half width
        pen.y = 74.0; // the far edge
        pen.pressure = 0.8;
        pen.leanX = 0.4;
        pen.buttons = 0b0011;
        Pen turned = mappedPen(pen, map, reader);
        QCOMPARE(turned.y, 37.0);
        QCOMPARE(turned.x, -112.0);
        QVERIFY(std::abs(turned.pressure - 0.4) < 1e-12);
        QCOMPARE(turned.leanX, 0.0);
        QCOMPARE(turned.buttons, 0b0011U); // the barrel's button mills; the tip has its bit
        pen.buttons = 0b0111;
        turned = mappedPen(pen, map, reader);
        QCOMPARE(turned.buttons & 1U, 0U); // lifted
    }

    void noEventMakesAPoseThatIsNone() {
        QVERIFY(rc::check([] {
            const auto device = tablet(*rc::gen::inRange(0, 3));
            TabletReader reader(*device);
            PenMapping mapping;
            for (int i = 0; i < 50; ++i) {
                (void)reader.take(eventOf(*rc::gen::element<unsigned int>(EV_SYN, EV_ABS, EV_KEY),
                                          *rc::gen::inRange(0U, 0x160U), *rc::gen::arbitrary<int>()));
                const Pose pose = mapping.advance(reader.pen(), 0.01);
                RC_ASSERT(std::isfinite(glm::length(pose.position)));
                RC_ASSERT(std::abs(glm::length(pose.rotation) - 1.0) < 1e-9);
                RC_ASSERT(pose.position.z >= -PenMapping::depth && pose.position.z <= PenMapping::lift + 1e-9);
                RC_ASSERT(reader.pen().buttons < 16U);
            }
        }));
    }
};

BURIN_TEST(TestTablet, NoApplication)

} // namespace burin::tst_tablet

#include "tst_tablet.moc"
