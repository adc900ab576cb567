// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/axis_travel.h"
#include "core/machine/kinematics.h"
#include "tests/test_program.h"

#include <glm/gtc/matrix_transform.hpp>

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

/// A machine with these rotary axes, in order from the workpiece.
MachineProfile tilting(std::vector<RotaryAxis> axes) {
    MachineProfile machine = mill();
    machine.rotaryAxes = std::move(axes);
    return machine;
}
RotaryAxis about(Axis axis, bool reversed = false) {
    RotaryAxis rotary;
    rotary.axis = axis;
    rotary.reversed = reversed;
    return rotary;
}
/// The tool's direction by matrices of GLM: Z turned about the last axis first.
glm::dvec3 directionBy(const std::vector<RotaryAxis>& axes, const AxisValues& values) {
    glm::dmat4 turn(1.0);
    for (const RotaryAxis& axis : axes) {
        glm::dvec3 of(0.0);
        of[static_cast<int>(axis.axis) - 3] = 1.0;
        turn = glm::rotate(turn, (axis.reversed ? -1.0 : 1.0) * values[axis.axis] * pi / 180.0, of);
    }
    return glm::dvec3(turn * glm::dvec4(0.0, 0.0, 1.0, 0.0));
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

    /// Angles of trunnions as LinuxCNC's kinematics have them (trtfuncs.c), of heads as its 5axiskins: the table or
    /// head turns by these for a tool along a direction.
    void rotaryAxesHaveTheValuesOfLinuxCnc() {
        struct Case {
            std::vector<RotaryAxis> axes;
            glm::dvec3 direction;
            double first, second; // degrees
        };
        const auto table = [](Axis tilt) { return std::vector{about(Axis::c, true), about(tilt, true)}; };
        const auto head = std::vector{about(Axis::c), about(Axis::b)};
        const glm::dvec3 v1(0.5, 0.0, std::sqrt(0.75)), v2 = glm::normalize(glm::dvec3(1.0)), v3(-0.36, 0.48, 0.8);
        for (const Case& each :
             {Case{table(Axis::a), v1, 90.0, 30.0}, Case{table(Axis::a), v2, 45.0, 54.735610317245346},
              Case{table(Axis::a), v3, -36.86989764584402, 36.86989764584402}, Case{table(Axis::b), v1, 0.0, -30.0},
              Case{table(Axis::b), v2, -45.0, -54.735610317245346}, Case{head, v1, 0.0, 30.0},
              Case{head, v3, -53.13010235415598, -36.86989764584402}}) {
            const auto kinematics = kinematicsOf(tilting(each.axes), {});
            AxisValues near; // of both solutions the one that is listed
            near.set(each.axes[0].axis, each.first);
            near.set(each.axes[1].axis, each.second);
            const Result<AxisValues> values = kinematics->axesNear({{}, each.direction}, near);
            QVERIFY(values);
            QVERIFY2(std::abs((*values)[each.axes[0].axis] - each.first) < 1e-9,
                     qPrintable(QString::number((*values)[each.axes[0].axis])));
            QVERIFY(std::abs((*values)[each.axes[1].axis] - each.second) < 1e-9);
        }
    }

    /// Whatever axes a machine has: their values give the tool's direction, by matrices, and no axis turns by more than
    /// half a turn from where it was.
    void rotaryAxesReachAPoseFromWhereTheyAre() {
        const std::vector<std::vector<RotaryAxis>> machines{{about(Axis::c, true), about(Axis::a, true)},
                                                            {about(Axis::c), about(Axis::b)},
                                                            {about(Axis::a), about(Axis::b, true)},
                                                            {about(Axis::b), about(Axis::a)},
                                                            {about(Axis::c, true), about(Axis::b)}};
        QVERIFY(rc::check("a direction and back", [&] {
            const std::vector<RotaryAxis>& axes = machines[*rc::gen::inRange<std::size_t>(0, machines.size())];
            const glm::dvec3 zero = anyPlace();
            const ToolPose pose{anyPlace(), leaning(*rc::gen::inRange(0, 1'790'000) / 1e6 * 0.5 * pi)};
            AxisValues before;
            for (const RotaryAxis& axis : axes) before.set(axis.axis, anyNumber());
            const auto kinematics = kinematicsOf(tilting(axes), zero);
            const Result<AxisValues> values = kinematics->axesNear(pose, before);
            RC_ASSERT(bool(values));
            RC_ASSERT(glm::distance(values->linear(), pose.tip - zero) <= rounding);
            RC_ASSERT(glm::distance(directionBy(axes, *values), pose.axis) < 2e-6);
            RC_ASSERT(glm::distance(kinematics->poseOf(*values).axis, directionBy(axes, *values)) < 1e-9);
            double way = 0.0;
            for (const RotaryAxis& axis : axes) {
                RC_ASSERT(std::abs((*values)[axis.axis] - before[axis.axis]) <= 180.0 + 1e-6);
                way += std::abs((*values)[axis.axis] - before[axis.axis]);
            }
            RC_ASSERT(way <= 270.0 + 1e-6);
        }));
    }

    void aSingleRotaryAxisTiltsInItsPlane() {
        const auto kinematics = kinematicsOf(tilting({about(Axis::a)}), {});
        const double angle = 25.0 * pi / 180.0;
        const auto values = kinematics->axesOf({{}, {0.0, -std::sin(angle), std::cos(angle)}});
        QVERIFY(values && std::abs((*values)[Axis::a] - 25.0) < 1e-9);
        const auto across = kinematics->axesOf({{}, {std::sin(angle), 0.0, std::cos(angle)}});
        QCOMPARE(across.error().code, ErrorCode::programLimit);
    }

    void limitsOfRotaryAxesChooseTheSolution() {
        RotaryAxis tilt = about(Axis::a);
        tilt.low = -10.0;
        tilt.high = 100.0;
        const auto kinematics = kinematicsOf(tilting({about(Axis::c), tilt}), {});
        const double angle = 40.0 * pi / 180.0;
        AxisValues near;
        near.set(Axis::a, -40.0); // the solution that is nearer is beyond the limit
        const auto values = kinematics->axesNear({{}, {0.0, std::sin(angle), std::cos(angle)}}, near);
        QVERIFY(values);
        QVERIFY(std::abs((*values)[Axis::a] - 40.0) < 1e-9 && std::abs(std::abs((*values)[Axis::c]) - 180.0) < 1e-9);
        tilt.high = 30.0;
        const auto narrow = kinematicsOf(tilting({about(Axis::c), tilt}), {});
        QCOMPARE(narrow->axesOf({{}, {0.0, std::sin(angle), std::cos(angle)}}).error().code, ErrorCode::programLimit);
    }

    /// An upright tool leaves C free: it turns in the last rapid before it is needed, not while the tool tilts in a
    /// cut.
    void aFreeAxisTurnsInTheRapidBefore() {
        const auto kinematics = kinematicsOf(tilting({about(Axis::c), about(Axis::b)}), {});
        using By = CoursePose::By;
        const auto leans = [](double degrees) {
            const double angle = degrees * pi / 180.0;
            return glm::dvec3(0.0, std::sin(angle), std::cos(angle));
        };
        const std::vector<CoursePose> poses{{{{0, 0, 9}}, By::rapid},
                                            {{{5, 0, 9}}, By::rapid},
                                            {{{5, 0, 0}}, By::line},
                                            {{{6, 0, 0}, leans(10.0)}, By::line},
                                            {{{7, 0, 0}, leans(0.0)}, By::line},
                                            {{{8, 0, 0}, leans(-20.0)}, By::line}};
        const auto values = axesAlong(*kinematics, poses, AxisValues());
        QVERIFY(values);
        const auto c = [&](std::size_t i) { return (*values)[i][Axis::c]; };
        QCOMPARE(c(0), 0.0);
        for (std::size_t i = 1; i < 4; ++i) QVERIFY(std::abs(c(i) - 90.0) < 1e-9);
        QVERIFY(std::abs((*values)[5][Axis::b] + 20.0) < 1e-9 && std::abs(c(5) - 90.0) < 1e-9); // through upright
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
