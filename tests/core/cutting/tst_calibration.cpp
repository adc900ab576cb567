// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration.h"
#include "core/cutting/cutting_force.h"
#include "tests/core/cutting/measured_cuts.h"
#include "tests/test_program.h"

#include <QtTest>

#include <functional>

namespace burin::tst_calibration {

using namespace burin::tests;

namespace {

constexpr double axial = 0.35; // Kr of the generated records

/// Records as eq. 15 interprets them: Ft against the feed, Kr Ft along the axis.
std::vector<ForceRecord> measured(std::size_t count, double deviation, std::uint64_t seed,
                                  const std::function<double(const ForceRecord&)>& energy) {
    Noise noise(seed);
    std::vector<ForceRecord> records;
    for (std::size_t i = 0; i < count; ++i) {
        ForceRecord record = conditions(i);
        record.axis = glm::normalize(noise.vector(1.0));
        record.feedDirection = glm::normalize(glm::cross(record.axis, noise.vector(1.0)));
        const double tangential = tangentialForce(record, energy(record));
        record.force = -tangential * record.feedDirection + axial * tangential * record.axis + noise.vector(deviation);
        records.push_back(record);
    }
    return records;
}

CalibrationOptions with(ChipLaw law, ForceProjection projection = ForceProjection::feedAndAxis) {
    CalibrationOptions options;
    options.law = law;
    options.projection = projection;
    return options;
}

/// Mean chip thickness of a slot, by hand: half a revolution, fz times the sine of the angle, whose mean is 2 / pi.
double slotChip(const ForceRecord& record) {
    return 2.0 / pi * record.feed / (record.spindleSpeed * record.teeth);
}

/// Number of intervals that contained the true value, out of a total; about 95 % of 2000 means 0.95 ± 0.005.
struct Coverage {
    int total = 0, energy = 0, ratio = 0, force = 0, exponent = 0;
    static bool good(int held, int total) {
        const double share = static_cast<double>(held) / total;
        return share > 0.93 && share < 0.97;
    }
};

} // namespace

class CalibrationTest : public QObject {
    Q_OBJECT
private slots:
    void studentsQuantilesAreThoseOfTheTables() {
        // NIST/SEMATECH e-handbook, 1.3.6.7.2: two-sided 95 % and 99 %.
        QVERIFY(std::abs(studentQuantile(0.95, 1) - 12.706) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.95, 2) - 4.303) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.95, 5) - 2.571) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.95, 10) - 2.228) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.99, 30) - 2.750) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.95, 100) - 1.984) < 1e-3);
        QVERIFY(std::abs(studentQuantile(0.95, 1'000'000) - 1.960) < 2e-3);
    }

    void forcesWithoutNoiseGiveTheCoefficientsBack() {
        const auto records = measured(12, 0.0, 1, [](const ForceRecord&) { return 0.9; });
        const auto found = calibrate(records, "test", with(ChipLaw::constant), "forces.csv");
        QVERIFY(found.hasValue());
        QVERIFY(std::abs(found->specificEnergy.value - 0.9) < 1e-12);
        QVERIFY(std::abs(found->radialRatio.value - axial) < 1e-12);
        QCOMPARE(found->records, std::size_t{12});
        QCOMPARE(found->residuals.size(), std::size_t{12});
        QVERIFY(found->leftOut.empty());
    }

    /// ISCAR 2017, p. 558: cured wrought aluminium, kc1.1 = 800 N/mm², mc = 0.25.
    void aPublishedKienzleSetComesBackFromForcesMadeWithIt_data() {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("exponent");
        QTest::newRow("aluminium, cured, ISCAR") << 800.0 << 0.25;
        QTest::newRow("steel below 0.25 C, ISCAR") << 1350.0 << 0.21;
        QTest::newRow("austenitic stainless, ISCAR") << 2150.0 << 0.20;
        QTest::newRow("brass, ISCAR") << 700.0 << 0.27;
    }
    void aPublishedKienzleSetComesBackFromForcesMadeWithIt() {
        QFETCH(double, force);
        QFETCH(double, exponent);
        const auto energy = [&](const ForceRecord& record) {
            return force * std::pow(slotChip(record), -exponent) / 1000.0;
        };
        const auto exact = calibrate(measured(12, 0.0, 2, energy), "test", with(ChipLaw::kienzle), "forces.csv");
        QVERIFY(exact.hasValue());
        QVERIFY(std::abs(exact->kienzleForce.value / force - 1.0) < 1e-8);
        QVERIFY(std::abs(exact->kienzleExponent.value - exponent) < 1e-9);
        QVERIFY(std::abs(exact->radialRatio.value - axial) < 1e-9);
        const auto noisy = calibrate(measured(24, 1.0, 3, energy), "test", with(ChipLaw::kienzle), "forces.csv");
        QVERIFY(noisy.hasValue());
        QVERIFY(noisy->kienzleForce.holds(force));
        QVERIFY(noisy->kienzleExponent.holds(exponent));
        QVERIFY(noisy->radialRatio.holds(axial));
        QVERIFY(noisy->kienzleExponent.high - noisy->kienzleExponent.low < 0.1);
    }

    /// 6061-T6 in the review of cutting force coefficients (Chinese Journal of Mechanical Engineering 2021, table 5),
    /// the shear coefficients: forces of rotating teeth, step by step, in slots and on either side.
    void aPublishedShearSetComesBackFromTurningTeeth() {
        Noise noise(5);
        std::vector<ForceRecord> records;
        for (std::size_t i = 0; i < 12; ++i) {
            ForceRecord record = conditions(i);
            record.axis = glm::normalize(glm::dvec3(0.2, -0.4, 0.8));
            record.feedDirection = glm::normalize(glm::cross(record.axis, glm::dvec3(1.0, 0.3, 0.1)));
            if (i % 3 != 0) {
                record.immersion = i % 3 == 1 ? Immersion::up : Immersion::down;
                record.radialDepth = 1.5 + 0.25 * static_cast<double>(i);
            }
            record.force = forceOfTurningTeeth(record, {243.8, 0.0, 113.5, 0.0}) + noise.vector(0.1);
            records.push_back(record);
        }
        const auto found =
            calibrate(records, "test", with(ChipLaw::constant, ForceProjection::turningTeeth), "forces.csv");
        QVERIFY(found.hasValue());
        QVERIFY(found->leftOut.empty());
        QVERIFY(found->specificEnergy.holds(0.2438) && found->radialRatio.holds(113.5 / 243.8));
        QVERIFY(std::abs(found->specificEnergy.value / 0.2438 - 1.0) < 0.005);
        QVERIFY(std::abs(found->radialRatio.value / (113.5 / 243.8) - 1.0) < 0.01);
    }

    /// The same with its edge coefficients, at one feed. The power of a slot corresponds to K = Ktc + pi / 2 Kte / fz,
    /// but the force perpendicular to the feed shows 4 / pi: the edge's part of K comes out a fifth too small, as the
    /// header says.
    void anEdgeForceCountsAFifthLessThanItsPower() {
        std::vector<ForceRecord> records;
        for (std::size_t i = 0; i < 6; ++i) {
            ForceRecord record = conditions(i % 3);
            record.force = forceOfTurningTeeth(record, {243.8, 7.5, 113.5, 7.8});
            records.push_back(record);
        }
        const auto found =
            calibrate(records, "test", with(ChipLaw::constant, ForceProjection::turningTeeth), "forces.csv");
        QVERIFY(found.hasValue());
        const double fz = 500.0 / (12'000.0 * 2.0);
        const double acrossFeed = (243.8 + 4.0 / pi * 7.5 / fz) / 1000.0;
        QVERIFY2(std::abs(found->specificEnergy.value / acrossFeed - 1.0) < 1e-3,
                 qPrintable(QString::number(found->specificEnergy.value)));
    }

    /// The whole set is recovered if the edge is fitted: slots and both sides, noise, and one outlier.
    void aPublishedSetWithItsEdgeComesBack() {
        Noise noise(11);
        std::vector<ForceRecord> records;
        for (std::size_t i = 0; i < 24; ++i) {
            ForceRecord record = conditions(i);
            record.axis = glm::normalize(glm::dvec3(0.2, -0.4, 0.8));
            record.feedDirection = glm::normalize(glm::cross(record.axis, glm::dvec3(1.0, 0.3, 0.1)));
            if (i % 3 != 0) {
                record.immersion = i % 3 == 1 ? Immersion::up : Immersion::down;
                record.radialDepth = 1.5 + 0.15 * static_cast<double>(i);
            }
            record.force = forceOfTurningTeeth(record, {631.0, 13.0, 99.0, 10.0}) + noise.vector(0.3);
            records.push_back(record);
        }
        records[7].force *= 6.0;
        const auto found = calibrate(records, "test", with(ChipLaw::edge, ForceProjection::turningTeeth), "forces.csv");
        QVERIFY2(found.hasValue(), found ? "" : found.error().detail.c_str());
        QCOMPARE(found->leftOut.size(), std::size_t{1});
        QCOMPARE(found->leftOut.front().line, records[7].line);
        QVERIFY(found->specificEnergy.holds(0.631) && std::abs(found->specificEnergy.value / 0.631 - 1.0) < 0.02);
        QVERIFY(found->radialRatio.holds(99.0 / 631.0));
        QVERIFY(found->edgeForce.holds(13.0) && std::abs(found->edgeForce.value / 13.0 - 1.0) < 0.05);
        QVERIFY(found->radialEdgeForce.holds(10.0));
        QVERIFY(found->tangentialNoise > 0.2 && found->tangentialNoise < 0.4);
        Property basis;
        basis.id = "test";
        basis.values[std::string(kienzleForce)] = {1.0, "N/mm^2", "old", false};
        const Property material = calibratedMaterial(basis, *found, "forces.csv");
        QCOMPARE(material.valueOr(tangentialEdgeForce, 0.0), found->edgeForce.value);
        QVERIFY(!material.values.contains(kienzleForce));
        // A different law includes the edge force in its K.
        const auto constant =
            calibrate(records, "test", with(ChipLaw::constant, ForceProjection::turningTeeth), "forces.csv");
        QVERIFY(!calibratedMaterial(material, *constant, "forces.csv").values.contains(tangentialEdgeForce));
    }
    /// 95 % of the intervals contain the true value.
    void confidenceOfTheEdgeIsWhatItSays() {
        std::vector<ForceRecord> records;
        for (std::size_t i = 0; i < 12; ++i) {
            records.push_back(conditions(i));
            records.back().force = forceOfTurningTeeth(records.back(), {631.0, 13.0, 99.0, 10.0});
        }
        int energy = 0, ratio = 0, edge = 0, radial = 0;
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            Noise noise(seed);
            std::vector<ForceRecord> measured = records;
            for (ForceRecord& record : measured) record.force += noise.vector(0.5);
            const auto found =
                calibrate(measured, "test", with(ChipLaw::edge, ForceProjection::turningTeeth), "forces.csv");
            QVERIFY2(found.hasValue(), found ? "" : found.error().detail.c_str());
            energy += found->specificEnergy.holds(0.631);
            ratio += found->radialRatio.holds(99.0 / 631.0);
            edge += found->edgeForce.holds(13.0);
            radial += found->radialEdgeForce.holds(10.0);
        }
        for (const int held : {energy, ratio, edge, radial})
            QVERIFY2(Coverage::good(held, 2000), qPrintable(QString::number(held)));
    }

    void forcesOnTheWorkpieceAreTheOthersTurnedRound() {
        auto records = measured(12, 0.2, 5, [](const ForceRecord&) { return 0.9; });
        const auto onTool = calibrate(records, "test", with(ChipLaw::constant), "forces.csv");
        for (ForceRecord& record : records) record.force = -record.force;
        const auto refused = calibrate(records, "test", with(ChipLaw::constant), "forces.csv");
        QVERIFY(!refused.hasValue());
        QVERIFY(refused.error().detail.find("--on-workpiece") != std::string::npos);
        CalibrationOptions options = with(ChipLaw::constant);
        options.forcesOnWorkpiece = true;
        const auto onWorkpiece = calibrate(records, "test", options, "forces.csv");
        QVERIFY(onTool.hasValue() && onWorkpiece.hasValue());
        QCOMPARE(onWorkpiece->specificEnergy.value, onTool->specificEnergy.value);
        QCOMPARE(onWorkpiece->radialRatio.high, onTool->radialRatio.high);
    }

    /// 95 % of the intervals contain the true value, whatever the number of records and the noise.
    void confidenceIsWhatItSays_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("noise"); // N; forces are 3 to 60 N
        QTest::addColumn<bool>("kienzle");
        QTest::newRow("few records, constant K") << 6 << 0.5 << false;
        QTest::newRow("a dozen, much noise, constant K") << 12 << 3.0 << false;
        QTest::newRow("many records, constant K") << 48 << 1.0 << false;
        QTest::newRow("a dozen, Kienzle") << 12 << 0.5 << true;
        QTest::newRow("many records, Kienzle") << 48 << 1.0 << true;
    }
    void confidenceIsWhatItSays() {
        QFETCH(int, count);
        QFETCH(double, noise);
        QFETCH(bool, kienzle);
        const auto energy = [&](const ForceRecord& record) {
            return kienzle ? 800.0 * std::pow(slotChip(record), -0.25) / 1000.0 : 0.9;
        };
        Coverage coverage;
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            const auto found = calibrate(measured(static_cast<std::size_t>(count), noise, seed, energy), "test",
                                         with(kienzle ? ChipLaw::kienzle : ChipLaw::constant), "forces.csv");
            QVERIFY2(found.hasValue(), found ? "" : found.error().detail.c_str());
            ++coverage.total;
            coverage.ratio += found->radialRatio.holds(axial);
            coverage.energy += kienzle || found->specificEnergy.holds(0.9);
            coverage.force += found->kienzleForce.holds(800.0);
            coverage.exponent += found->kienzleExponent.holds(0.25);
        }
        const QByteArray said = QByteArray::number(coverage.energy) + " " + QByteArray::number(coverage.ratio) + " " +
                                QByteArray::number(coverage.force) + " " + QByteArray::number(coverage.exponent);
        QVERIFY2(Coverage::good(coverage.ratio, coverage.total), said);
        QVERIFY2(kienzle || Coverage::good(coverage.energy, coverage.total), said);
        QVERIFY2(!kienzle || Coverage::good(coverage.force, coverage.total), said);
        QVERIFY2(!kienzle || Coverage::good(coverage.exponent, coverage.total), said);
    }

    /// An air cut, a broken sensor and a typing error in thirty records.
    void whatIsFarOffIsLeftOutAndNamed_data() {
        QTest::addColumn<bool>("kienzle");
        QTest::newRow("constant K") << false;
        QTest::newRow("Kienzle") << true;
    }
    void whatIsFarOffIsLeftOutAndNamed() {
        QFETCH(bool, kienzle);
        const auto energy = [&](const ForceRecord& record) {
            return kienzle ? 800.0 * std::pow(slotChip(record), -0.25) / 1000.0 : 0.9;
        };
        auto records = measured(30, 0.3, 7, energy);
        records[10].force = glm::dvec3(0.0);
        records[17].force *= 10.0;
        records[23].force += 40.0 * records[23].axis;
        records[5].axialDepth = 0.0;
        const auto found =
            calibrate(records, "test", with(kienzle ? ChipLaw::kienzle : ChipLaw::constant), "forces.csv");
        QVERIFY(found.hasValue());
        QCOMPARE(found->records, std::size_t{30});
        QCOMPARE(found->residuals.size(), std::size_t{26});
        std::vector<std::size_t> lines;
        for (const LeftOut& record : found->leftOut) lines.push_back(record.line);
        QCOMPARE(lines, (std::vector<std::size_t>{7, 12, 19, 25}));
        QVERIFY(found->leftOut[0].reason.find("removed") != std::string::npos);
        QVERIFY(found->leftOut[1].reason.find("far off") != std::string::npos);
        QVERIFY(found->radialRatio.holds(axial));
        QVERIFY(kienzle ? found->kienzleExponent.holds(0.25) : found->specificEnergy.holds(0.9));
        QVERIFY(found->tangentialNoise > 0.2 && found->tangentialNoise < 0.4);
    }

    void whatCanNotBeToldIsRefused() {
        const auto constant = [](const ForceRecord&) { return 0.9; };
        const auto detail = [](const Result<MaterialCalibration>& result) {
            return result ? std::string("accepted") : result.error().detail;
        };
        const auto holds = [](const std::string& text, const char* word) {
            return text.find(word) != std::string::npos;
        };
        const auto three = measured(3, 0.1, 1, constant);
        QVERIFY(holds(detail(calibrate(three, "test", with(ChipLaw::constant), "f")), "only 3 records"));
        auto oneFeed = measured(12, 0.1, 1, constant);
        for (ForceRecord& record : oneFeed) {
            const double before = tangentialForce(record, 0.9);
            record.feed = 500.0;
            record.force *= tangentialForce(record, 0.9) / before;
        }
        QVERIFY(holds(detail(calibrate(oneFeed, "test", with(ChipLaw::kienzle), "f")), "different thickness"));
        QVERIFY(calibrate(oneFeed, "test", with(ChipLaw::constant), "f").hasValue());
        QVERIFY(
            holds(detail(calibrate(measured(12, 100.0, 3, constant), "test", with(ChipLaw::kienzle), "f")), "noise"));
        auto plunges = measured(12, 0.1, 1, constant);
        for (ForceRecord& record : plunges) record.feedDirection = -record.axis;
        QVERIFY(holds(detail(calibrate(plunges, "test", with(ChipLaw::constant), "f")), "only 0 records"));
        auto pulled = measured(12, 0.1, 1, constant);
        for (ForceRecord& record : pulled) record.force -= 2.0 * glm::dot(record.force, record.axis) * record.axis;
        QVERIFY(holds(detail(calibrate(pulled, "test", with(ChipLaw::constant), "f")), "pulls"));
        auto scattered = measured(12, 0.1, 1, constant);
        for (std::size_t i = 0; i < 5; ++i) scattered[i].force *= 5.0 + 3.0 * static_cast<double>(i);
        QVERIFY(holds(detail(calibrate(scattered, "test", with(ChipLaw::constant), "f")), "disagree"));
        const auto named = calibrate(three, "test", with(ChipLaw::constant), "f.csv").error();
        QVERIFY(named.code == ErrorCode::resourceInvalid);
        QCOMPARE(named.subject, std::string("f.csv"));
        QCOMPARE(named.place, std::string("material test"));
    }

    void theMaterialNamesItsCalibration() {
        Property basis;
        basis.id = "test";
        basis.name = "Test";
        basis.values["density"] = {2.7, "g/cm^3", "a handbook", false};
        basis.values[std::string(kienzleForce)] = {1.0, "N/mm^2", "old", false};
        basis.values[std::string(kienzleExponent)] = {0.1, "1", "old", false};
        const auto records = measured(12, 0.1, 9, [](const ForceRecord&) { return 0.9; });
        const auto constant = calibrate(records, "test", with(ChipLaw::constant), "forces.csv");
        const Property material = calibratedMaterial(basis, *constant, "forces.csv, 2026-01-31");
        QCOMPARE(material.valueOr(specificCuttingEnergy, 0.0), constant->specificEnergy.value);
        QCOMPARE(material.valueOr(radialForceRatio, 0.0), constant->radialRatio.value);
        QCOMPARE(material.valueOr(density, 0.0), 2.7);
        QVERIFY(!material.values.contains(kienzleForce)); // an old law would take precedence over the new K
        const NamedValue& value = material.values.find(specificCuttingEnergy)->second;
        QVERIFY(!value.estimate);
        QVERIFY(value.source.find("forces.csv, 2026-01-31") != std::string::npos);
        QVERIFY(value.source.find("95 %") != std::string::npos);
        const Result<Property> back = propertyFromJson(toJson(material), "back");
        QVERIFY(back.hasValue());
        QCOMPARE(back->valueOr(specificCuttingEnergy, 0.0), constant->specificEnergy.value);
    }
};

BURIN_TEST(CalibrationTest, NoApplication)

} // namespace burin::tst_calibration

#include "tst_calibration.moc"
