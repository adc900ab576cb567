// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/speed_ramp.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_speed_ramp {

namespace {

struct Driven {
    double seconds = 0.0, way = 0.0;
};

/// From one speed to a higher one, with zero acceleration at both ends, simulated step by step: full jerk up as long as
/// the acceleration is below its limit and can still be reduced in time, then full jerk down.
Driven speedUp(double from, double to, double acceleration, double jerk) {
    Driven driven;
    const double step = 2e-5 * (2.0 * std::sqrt((to - from) / jerk) + (to - from) / acceleration + 1e-9);
    double speed = from, rate = 0.0;
    bool takesBack = false;
    while (!takesBack || rate > 0.0) {
        takesBack = takesBack || speed + 0.5 * rate * rate / jerk >= to;
        const double before = rate;
        rate = takesBack ? std::max(rate - jerk * step, 0.0) : std::min(rate + jerk * step, acceleration);
        const double gain = 0.5 * (before + rate) * step;
        driven.way += (speed + 0.5 * gain) * step;
        speed += gain;
        driven.seconds += step;
    }
    return driven;
}

} // namespace

class SpeedRampTest : public QObject {
    Q_OBJECT

private slots:
    void anSCurveIsWhatAnAxisDrives();
    void withoutALimitToJerkItIsATrapezoid();
};

/// Between any two speeds, neither of them zero except by chance, with room for a higher one between.
void SpeedRampTest::anSCurveIsWhatAnAxisDrives() {
    const auto number = [](double low, double high) { return low + (high - low) * 1e-4 * *rc::gen::inRange(0, 10001); };
    int cruising = 0, shorter = 0;
    QVERIFY(rc::check("time and greatest speed", [&] {
        const double from = number(0.0, 50.0), to = number(0.0, 50.0);
        const double acceleration = number(100.0, 3000.0), jerk = number(1000.0, 80000.0);
        const double peak = std::max(from, to) + number(0.5, 60.0), cruise = *rc::gen::element(0.0, 30.0);
        const Driven up = speedUp(from, peak, acceleration, jerk), down = speedUp(to, peak, acceleration, jerk);
        const double length = up.way + down.way + cruise;
        // Without a cruise phase only the length determines the highest speed: a higher one is requested.
        const RampTime ramp = sCurve(length, from, to, cruise > 0.0 ? peak : 2.0 * peak, acceleration, jerk);
        RC_ASSERT(std::abs(ramp.peak - peak) <= 2e-3 * peak);
        const double seconds = up.seconds + down.seconds + cruise / peak;
        RC_ASSERT(std::abs(ramp.seconds - seconds) <= 2e-3 * seconds);
        ++(cruise > 0.0 ? cruising : shorter);
    }));
    QVERIFY(cruising > 20 && shorter > 20);
}

void SpeedRampTest::withoutALimitToJerkItIsATrapezoid() {
    const RampTime with = sCurve(80.0, 10.0, 25.0, 60.0, 500.0, 1e12),
                   without = trapezoid(80.0, 10.0, 25.0, 60.0, 500.0);
    QVERIFY(std::abs(with.seconds - without.seconds) < 1e-6);
    QVERIFY(std::abs(with.peak - without.peak) < 1e-6);
    // 10 to 60 and 60 to 25 mm/s at 500 mm/s²: 3.5 mm and 2.975 mm, the rest at 60 mm/s.
    QVERIFY(std::abs(without.seconds - (0.1 + 0.07 + (80.0 - 3.5 - 2.975) / 60.0)) < 1e-12);
}

BURIN_TEST(SpeedRampTest, NoApplication)

} // namespace burin::tst_speed_ramp

#include "tst_speed_ramp.moc"
