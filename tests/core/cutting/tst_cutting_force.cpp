// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "tests/core/cutting/workpieces.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace burin;
using namespace burin::tests;

namespace {

CutResult twoMaterials() {
    CutResult cut;
    cut.removed[0] = {softStock, 0, 0.0, 0.004};
    cut.removed[1] = {hardStock, 0, 0.0, 0.001};
    cut.reported = 0.005;
    cut.reportedCentroid = {10.0, 3.0, 1.0};
    return cut;
}

Property withValues(double speed, double chipLoad, double plunge) {
    Property property;
    property.id = "test";
    property.values[std::string(surfaceSpeed)] = {speed, "m/min", "test", false};
    property.values[std::string(chipLoadPerDiameter)] = {chipLoad, "1", "test", false};
    property.values[std::string(plungeFeedRatio)] = {plunge, "1", "test", false};
    return property;
}

Tool sixMillimetres(double highestSpindle = 0.0) {
    Tool tool;
    tool.fluteCount = 2;
    tool.maximumSpindleSpeed = highestSpindle;
    tool.cutter = flat(6.0, 20.0);
    return tool;
}

} // namespace

class CuttingForceTest : public QObject {
    Q_OBJECT

    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }

    /// Paper, eqs. 11–14, by hand: 4 mm³/s of K = 0.5 and 1 mm³/s of K = 2 J/mm³ make 4 W; at 5 m/s that is 0.8 N.
    void followsThePapersFormulas() {
        const CuttingCoefficients coefficients = cuttingCoefficients(materials());
        QCOMPARE(coefficients.byProperty[hardStock].specificEnergy, 2.0);
        const CuttingForce force =
            cuttingForce(twoMaterials(), coefficients, {0.02, 0.0, 0.0}, {10.0, 0.0, 0.0}, 5000.0, 0.001);
        QCOMPARE(force.removalRate, 5.0);
        QCOMPARE(force.tangential, 0.8);
        QCOMPARE(force.radial, 0.3 * 0.4 + 0.5 * 0.4);
        // Against the motion along x, and away from material at larger y.
        QVERIFY(glm::length(force.force - glm::dvec3(-0.8, -0.32, 0.0)) < 1e-12);
    }

    void materialRightBelowPushesUp() {
        CutResult cut = twoMaterials();
        cut.reportedCentroid = {10.0, 0.0, -1.0};
        const CuttingForce force =
            cuttingForce(cut, cuttingCoefficients(materials()), {0.0, 0.0, -0.01}, {10.0, 0.0, 0.0}, 5000.0, 0.001);
        QVERIFY(glm::length(force.force - glm::dvec3(0.0, 0.0, 0.8 + 0.32)) < 1e-12);
    }

    void noRemovalNoForce() {
        const CuttingForce force =
            cuttingForce({}, cuttingCoefficients(materials()), {0.1, 0.0, 0.0}, {}, 5000.0, 0.001);
        QCOMPARE(force.tangential, 0.0);
        QVERIFY(force.force == glm::dvec3(0.0));
    }

    /// From the cut to the force: a slot 6 wide and 2 deep at 10 mm/s in K = 0.5 at v = 2 m/s means
    /// 120 mm³/s, 60 W, 30 N.
    void aSlotGivesTheForceOfItsRemovalRate() {
        const Grid fine = grid({-15.0, -15.0, -7.0}, 0.2, {150, 150, 35});
        RunVolume workpiece = block(fine);
        MaterialRemoval removal(flat(6.0, 20.0), fine);
        const CuttingCoefficients coefficients = cuttingCoefficients(workpiece.properties());
        glm::dvec3 tip(-8.0, 0.0, -2.0);
        removal.cut(workpiece, tip + glm::dvec3(0.0, 0.0, 8.0), tip);
        double mean = 0.0;
        for (int tick = 0; tick < 900; ++tick) {
            const glm::dvec3 motion(0.01, 0.0, 0.0);
            const CutResult cut = removal.cut(workpiece, tip, tip + motion);
            tip += motion;
            if (tick < 300) continue;
            const CuttingForce force = cuttingForce(cut, coefficients, motion, tip, 2000.0, 0.001);
            mean += force.tangential / 600.0;
            QVERIFY(std::abs(force.tangential / 30.0 - 1.0) < 0.2);
            QVERIFY(force.force.x < 0.0);
            QVERIFY(std::abs(force.force.y) < 0.05 * force.radial);
        }
        QVERIFY2(std::abs(mean / 30.0 - 1.0) < 0.02, qPrintable(QString::number(mean)));
    }

    /// n = vc / (pi D), feed = n z fz.
    void conditionsFollowTheTable() {
        const Result<CuttingConditions> found =
            cuttingConditions(sixMillimetres(), withValues(300.0, 0.008, 0.3), 24000.0, 4000.0);
        QVERIFY(found.hasValue());
        const double n = 300.0 * 1000.0 / (pi * 6.0); // 15915
        QCOMPARE(found->spindleSpeed, n);
        QCOMPARE(found->feed, n * 2 * 0.048);
        QCOMPARE(found->plungeFeed, 0.3 * n * 2 * 0.048);
        QCOMPARE(found->surfaceSpeed, 5000.0);
        QVERIFY(!found->limitedByMachine);
    }

    void aSlowSpindleTakesTheFeedWithIt_data() {
        QTest::addColumn<double>("toolLimit");
        QTest::addColumn<double>("machineLimit");
        QTest::newRow("machine") << 0.0 << 10000.0;
        QTest::newRow("tool") << 10000.0 << 24000.0;
    }
    void aSlowSpindleTakesTheFeedWithIt() {
        QFETCH(double, toolLimit);
        QFETCH(double, machineLimit);
        const Result<CuttingConditions> found =
            cuttingConditions(sixMillimetres(toolLimit), withValues(300.0, 0.008, 0.3), machineLimit, 4000.0);
        QVERIFY(found.hasValue());
        QCOMPARE(found->spindleSpeed, 10000.0);
        QCOMPARE(found->feed, 960.0);
        QCOMPARE(found->surfaceSpeed, pi * 6.0 * 10000.0 / 60.0);
        QVERIFY(found->limitedByMachine);
    }

    void theMachinesFeedIsNotExceeded() {
        const Result<CuttingConditions> found =
            cuttingConditions(sixMillimetres(), withValues(300.0, 0.008, 2.0), 24000.0, 1000.0);
        QVERIFY(found.hasValue());
        QCOMPARE(found->feed, 1000.0);
        QCOMPARE(found->plungeFeed, 1000.0);
        QVERIFY(found->limitedByMachine);
    }

    void aMaterialWithoutAValueIsNamed() {
        Property bare = withValues(300.0, 0.008, 0.3);
        bare.values.erase(bare.values.find(chipLoadPerDiameter));
        const Result<CuttingConditions> found = cuttingConditions(sixMillimetres(), bare, 24000.0, 4000.0);
        QVERIFY(!found.hasValue());
        QVERIFY(found.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(found.error().subject, std::string("test"));
        QCOMPARE(found.error().place, std::string(chipLoadPerDiameter));
    }

    void everyShippedToolCutsEveryShippedMaterial() {
        QVERIFY(materialIds().size() >= 3);
        for (const std::string& id : materialIds()) {
            const Result<Property> material = loadMaterial(id);
            QVERIFY2(material.hasValue(), material ? "" : (id + ": " + material.error().place).c_str());
            for (const auto& [name, value] : material->values)
                QVERIFY2(!value.source.empty() && !value.unit.empty(), (id + " " + name).c_str());
            QVERIFY(material->valueOr(specificCuttingEnergy, 0.0) > 0.0);
            QVERIFY(material->valueOr(radialForceRatio, 0.0) > 0.0);
            QVERIFY(material->valueOr(density, 0.0) > 0.0);
            for (const std::string& tool : toolIds()) {
                const Result<CuttingConditions> found = cuttingConditions(*loadTool(tool), *material, 24000.0, 4000.0);
                QVERIFY(found.hasValue());
                QVERIFY(found->spindleSpeed > 1000.0 && found->spindleSpeed <= 24000.0);
                QVERIFY(found->feed > 50.0 && found->feed <= 4000.0);
                QVERIFY(found->plungeFeed > 0.0 && found->plungeFeed <= found->feed);
            }
        }
    }
};

QTEST_APPLESS_MAIN(CuttingForceTest)
#include "tst_cutting_force.moc"
