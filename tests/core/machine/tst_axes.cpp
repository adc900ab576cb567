// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/axis_travel.h"
#include "core/machine/kinematics.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_axes {

namespace {

constexpr double rounding = 1e-9; // mm: for positions up to 1000 mm

double anyNumber() {
    return *rc::gen::inRange(-1'000'000, 1'000'001) / 1000.0;
}
glm::dvec3 anyPlace() {
    return {anyNumber(), anyNumber(), anyNumber()};
}
Axis anyAxis() {
    return static_cast<Axis>(*rc::gen::inRange<int>(0, static_cast<int>(axisCount)));
}
/// A direction inclined from +Z by an angle, rad.
glm::dvec3 leaning(double angle) {
    const double round = anyNumber();
    return {std::sin(angle) * std::cos(round), std::sin(angle) * std::sin(round), std::cos(angle)};
}

MachineProfile mill() {
    MachineProfile machine;
    machine.travel = {300.0, 200.0, 100.0};
    return machine;
}

} // namespace

class TestAxes : public QObject {
    Q_OBJECT
private slots:
    void anAxisIsNamedByItsLetter() {
        QCOMPARE(axisOfLetter('Y'), std::optional(Axis::y));
        QCOMPARE(axisOfLetter('A'), std::optional(Axis::a));
        QCOMPARE(axisOfLetter('W'), std::optional(Axis::w));
        QVERIFY(!axisOfLetter('I') && !axisOfLetter('x'));
        for (const Axis axis : allAxes) QCOMPARE(axisOfLetter(letterOf(axis)), std::optional(axis));
        QVERIFY(isRotary(Axis::a) && isRotary(Axis::b) && isRotary(Axis::c));
        QVERIFY(!isRotary(Axis::x) && !isRotary(Axis::z) && !isRotary(Axis::u) && !isRotary(Axis::w));
    }

    /// Compared with nine numbers in an array; different axes must not share a value.
    void valuesAreTheirOwnAndStandByAxis() {
        QVERIFY(rc::check("nine numbers in a row", [] {
            std::array<double, axisCount> wanted{};
            AxisValues values;
            const int changes = *rc::gen::inRange(0, 12);
            for (int i = 0; i < changes; ++i) {
                const AxisValues before = values;
                const std::array<double, axisCount> stood = wanted;
                const Axis axis = anyAxis();
                const double value = *rc::gen::arbitrary<bool>() ? anyNumber() : 0.0;
                values.set(axis, value);
                wanted[static_cast<std::size_t>(axis)] = value;
                for (const Axis each : allAxes) {
                    RC_ASSERT(values[each] == wanted[static_cast<std::size_t>(each)]);
                    RC_ASSERT(before[each] == stood[static_cast<std::size_t>(each)]);
                }
                RC_ASSERT((values == before) == (wanted == stood));
                RC_ASSERT(values.onlyLinear() ==
                          std::all_of(wanted.begin() + 3, wanted.end(), [](double one) { return one == 0.0; }));
            }
            AxisValues copy;
            copy.set(Axis::c, 5.0);
            copy = values;
            RC_ASSERT(copy == values);
            const AxisValues sum = values + copy, middle = between(values, AxisValues(), 0.25);
            for (const Axis each : allAxes) {
                RC_ASSERT(sum[each] == 2.0 * values[each]);
                RC_ASSERT(std::abs(middle[each] - 0.75 * values[each]) <= rounding);
            }
        }));
    }

    void threeAxesCarryTheTipFromProgramZero() {
        QVERIFY(rc::check("the tip, counted from zero", [] {
            const glm::dvec3 zero = anyPlace(), tip = anyPlace();
            const auto kinematics = kinematicsOf(mill(), zero);
            RC_ASSERT(kinematics->axes() == linearAxes);
            const Result<AxisValues> values = kinematics->axesOf(ToolPose{tip});
            RC_ASSERT(bool(values));
            RC_ASSERT(*values == AxisValues(tip - zero));
            const ToolPose back = kinematics->poseOf(*values);
            RC_ASSERT(glm::distance(back.tip, tip) <= rounding);
            RC_ASSERT(back.axis == glm::dvec3(0.0, 0.0, 1.0));
        }));
    }

    void valuesGoToAPoseAndBack() {
        QVERIFY(rc::check("the same values", [] {
            const auto kinematics = kinematicsOf(mill(), anyPlace());
            const AxisValues values(anyPlace());
            AxisValues more = values;
            more.set(Axis::a, 30.0); // an axis that the machine doesn't have
            const Result<AxisValues> back = kinematics->axesOf(kinematics->poseOf(values));
            RC_ASSERT(bool(back));
            RC_ASSERT(glm::distance(back->linear(), values.linear()) <= rounding);
            RC_ASSERT(kinematics->poseOf(more).tip == kinematics->poseOf(values).tip);
        }));
    }

    void aTiltedToolIsRefusedWithItsTilt() {
        QVERIFY(rc::check("refused, with its angle", [] {
            const double degrees = *rc::gen::inRange(1, 180'001) / 1000.0;
            const Result<AxisValues> values = ThreeAxes().axesOf({anyPlace(), leaning(degrees * pi / 180.0)});
            RC_ASSERT(!values);
            RC_ASSERT(values.error().code == ErrorCode::programLimit);
            RC_ASSERT(values.error().subject == "tilt of the tool axis");
            const QString place = QString::fromStdString(values.error().place);
            RC_ASSERT(std::abs(place.section(QChar(0xB0), 0, 0).toDouble() - degrees) < 1e-5);
            RC_ASSERT(place.endsWith(QString("%1, limit 0%1").arg(QChar(0xB0))));
        }));
    }
    void whatRoundingTurnsAToolByIsNoTilt() {
        QVERIFY(rc::check("upright", [] {
            const double angle = *rc::gen::inRange(0, 1000) * 1e-12; // rad
            RC_ASSERT(bool(ThreeAxes().axesOf({anyPlace(), leaning(angle)})));
        }));
        QVERIFY(!ThreeAxes().axesOf({glm::dvec3(0.0), glm::dvec3(std::nan(""))}));
    }

    /// Compared with the box of all positions; whole numbers, so that some are at the ends, which belong to the travel.
    void axesHaveTheirTravelAndNoMore() {
        QVERIFY(rc::check("as the box of all places says", [] {
            const MachineProfile machine = mill();
            const glm::dvec3 low(*rc::gen::inRange(-200, 50), *rc::gen::inRange(-200, 50), *rc::gen::inRange(-100, 50));
            const bool stands = *rc::gen::arbitrary<bool>();
            AxisTravel travel(machine, stands ? Box{low, low + machine.travel} : Box{});
            for (const Axis axis : allAxes) RC_ASSERT(!travel.wayBeyond(axis)); // no axis is moved
            Box reach;
            for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
                const glm::dvec3 place(*rc::gen::inRange(-200, 301), *rc::gen::inRange(-100, 201),
                                       *rc::gen::inRange(-100, 101));
                AxisValues values(place);
                values.set(Axis::c, 1e6); // rotates without limit
                travel.goTo(allAxes, values);
                reach.include(place);
                RC_ASSERT(!travel.wayBeyond(Axis::c));
                for (int k = 0; k < 3; ++k) {
                    const double way = reach.size()[k], length = machine.travel[k];
                    const double off = std::max(low[k] - place[k], place[k] - (low[k] + length)); // beyond an end
                    double needed = way > length ? way : 0.0;
                    if (stands && off > 0.0) needed = std::max(needed, length + off);
                    const std::optional<double> beyond = travel.wayBeyond(linearAxis(k));
                    RC_ASSERT(beyond.has_value() == (needed > 0.0));
                    if (beyond) RC_ASSERT(*beyond == needed);
                }
            }
        }));
    }
};

BURIN_TEST(TestAxes, NoApplication)

} // namespace burin::tst_axes

#include "tst_axes.moc"
