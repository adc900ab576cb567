// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/recording/tip_smoothness.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <complex>
#include <random>

namespace burin::tst_tip_smoothness {

namespace {

constexpr double tick = 0.001; // s

/// Position of a minimum-jerk movement, as a share of its length (Flash and Hogan 1985).
double minimumJerk(double share) {
    return share * share * share * (10.0 + share * (-15.0 + 6.0 * share));
}

/// Makes consecutive movements along x, with tremor in any direction, and rests.
class MovingTip {
public:
    void move(double length, double seconds, const glm::dvec3& tremor = {}) {
        const auto count = static_cast<int>(std::lround(seconds / tick));
        for (int i = 1; i <= count; ++i)
            put({x_ + length * minimumJerk(static_cast<double>(i) / count), 0.0, 0.0},
                tremor * std::sin(2.0 * pi * 8.0 * i * tick));
        x_ += length;
    }
    void rest(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / tick)); ++i) put({x_, 0.0, 0.0}, {});
    }
    double smoothness() const {
        TipSmoothness smoothness(tick);
        for (const Sample& sample : samples_) smoothness.add(sample);
        smoothness.interrupt();
        return smoothness.mean().value_or(std::nan(""));
    }
    std::vector<Sample>& samples() { return samples_; }

private:
    void put(const glm::dvec3& place, const glm::dvec3& aside) {
        Sample sample;
        sample.tick = samples_.size();
        sample.proxy.tip = place + aside;
        samples_.push_back(sample);
    }
    std::vector<Sample> samples_{Sample{}};
    double x_ = 0.0;
};

double oneMove(double length, double seconds, const glm::dvec3& tremor = {}) {
    MovingTip tip;
    tip.move(length, seconds, tremor);
    return tip.smoothness();
}

/// The arc length of the spectrum of a minimum-jerk speed, which is (1/4 - u²)² about the middle: 15 j2(a) / a² with
/// a = π f T, from 0 to the last frequency at which that is 0.05.
double ofMinimumJerk() {
    const auto magnitude = [](double a) { return a == 0.0 ? 1.0 : std::abs(15.0 * std::sph_bessel(2, a) / (a * a)); };
    constexpr double step = 1e-4;
    int last = 0;
    for (int i = 0; i < 500000; ++i)
        if (magnitude(i * step) >= 0.05) last = i;
    double length = 0.0;
    for (int i = 1; i <= last; ++i) length += std::hypot(1.0 / last, magnitude(i * step) - magnitude((i - 1) * step));
    return -length;
}

bool within(double value, double wanted, double share) {
    return std::abs(value - wanted) <= share * std::abs(wanted);
}

} // namespace

class TipSmoothnessTest final : public QObject {
    Q_OBJECT

private slots:
    /// A minimum-jerk movement has the value of its closed-form spectrum, whatever its length and duration.
    void aMinimumJerkMovementHasItsClosedValue() {
        const double wanted = ofMinimumJerk();
        QVERIFY2(within(wanted, -1.41, 0.01), qPrintable(QString::number(wanted)));
        for (const auto& [length, seconds] : {std::pair{60.0, 2.0}, {20.0, 1.0}, {300.0, 6.0}, {15.0, 0.5}}) {
            const double value = oneMove(length, seconds);
            QVERIFY2(within(value, wanted, 0.01), qPrintable(QString("%1 mm: %2").arg(length).arg(value)));
        }
    }

    /// A tremor of 8 Hz lowers it, the more the greater its amplitude, along the movement and across it.
    void tremorLowersIt() {
        const double smooth = oneMove(60.0, 2.0);
        double before = smooth;
        for (const double amplitude : {0.1, 0.2, 0.4}) {
            const double trembling = oneMove(60.0, 2.0, {amplitude, 0.0, 0.0});
            QVERIFY2(trembling < before - 0.05, qPrintable(QString("%1 mm: %2").arg(amplitude).arg(trembling)));
            before = trembling;
        }
        QVERIFY(oneMove(60.0, 2.0, {0.0, 0.6, 0.0}) < smooth - 0.05);
    }

    /// Rests before, between and after movements change nothing; each movement is weighted by its duration.
    void pausesAreIgnored() {
        MovingTip tip;
        tip.rest(1.3);
        tip.move(60.0, 1.0);
        tip.rest(0.7);
        tip.move(60.0, 3.0, {0.4, 0.0, 0.0});
        tip.rest(2.0);
        const double wanted = (1.0 * oneMove(60.0, 1.0) + 3.0 * oneMove(60.0, 3.0, {0.4, 0.0, 0.0})) / 4.0;
        QVERIFY2(within(tip.smoothness(), wanted, 0.01),
                 qPrintable(QString("%1, not %2").arg(tip.smoothness()).arg(wanted)));
        MovingTip still;
        still.rest(3.0);
        QVERIFY(std::isnan(still.smoothness()));
    }

    /// A few missed ticks make a longer interval; many end the movement instead of appearing as a jump.
    void missedTicksAreNoLeap() {
        MovingTip tip;
        tip.move(60.0, 2.0);
        std::vector<Sample>& samples = tip.samples();
        samples.erase(samples.begin() + 900, samples.begin() + 925);
        QVERIFY2(within(tip.smoothness(), ofMinimumJerk(), 0.02), qPrintable(QString::number(tip.smoothness())));
        const auto leaping = [](double leap, std::uint64_t missed) {
            MovingTip apart;
            apart.move(60.0, 2.0);
            for (Sample& sample : apart.samples()) {
                if (sample.tick <= 1000) continue;
                sample.tick += missed;
                sample.proxy.tip.x += leap;
            }
            return apart.smoothness();
        };
        QVERIFY(leaping(5.0, 0) < oneMove(60.0, 2.0) - 0.1);
        QVERIFY(within(leaping(5.0, 400), leaping(0.0, 400), 1e-9));
    }

    /// For random speeds, the result equals that of the sums of the discrete Fourier transform, computed directly.
    void theSpectrumIsThatOfTheSums() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> speed(0.0, 40.0);
        std::vector<double> speeds(60);
        for (double& each : speeds) each = speed(random);
        const std::size_t count = 64 * 16;
        std::vector<double> magnitudes;
        for (std::size_t k = 0; static_cast<double>(k) / (0.01 * count) <= 20.0; ++k) {
            std::complex<double> sum;
            for (std::size_t i = 0; i < speeds.size(); ++i)
                sum += std::polar(speeds[i], -2.0 * pi * static_cast<double>(k * i) / count);
            magnitudes.push_back(std::abs(sum));
        }
        while (magnitudes.back() < 0.05 * magnitudes.front()) magnitudes.pop_back();
        double length = 0.0;
        for (std::size_t k = 1; k < magnitudes.size(); ++k)
            length += std::hypot(1.0 / static_cast<double>(magnitudes.size() - 1),
                                 (magnitudes[k] - magnitudes[k - 1]) / magnitudes.front());
        const std::optional<double> value = spectralArcLength(speeds, 0.01);
        QVERIFY(value && std::abs(*value + length) < 1e-9);
        QVERIFY(!spectralArcLength({}, 0.01) && !spectralArcLength(std::vector<double>(50, 0.0), 0.01));
    }
};

BURIN_TEST(TipSmoothnessTest, NoApplication)

} // namespace burin::tst_tip_smoothness

#include "tst_tip_smoothness.moc"
