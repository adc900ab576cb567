// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/cutting/coolant_advice.h"
#include "core/cutting/cutting_force.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_cutting_force {

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

/// The force of a cut of one tick: 6 mm tool, two teeth, upright unless stated.
CuttingForce forceOf(const CutResult& cut, const glm::dvec3& motion, const glm::dvec3& tip, double edgeSpeed,
                     const glm::dvec3& axis = {0.0, 0.0, 1.0},
                     const CuttingCoefficients& coefficients = cuttingCoefficients(materials(), 6.0)) {
    const SpinningTool tool{3.0, edgeSpeed, 2.0 * edgeSpeed / (6.0 * pi)};
    return cuttingForce(cut, coefficients, tool, {tip - motion, axis}, {tip, axis}, 0.001);
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
        QCOMPARE(cuttingCoefficients(materials(), 6.0).byProperty[hardStock].specificEnergy, 2.0);
        const CuttingForce force = forceOf(twoMaterials(), {0.02, 0.0, 0.0}, {10.0, 0.0, 0.0}, 5000.0);
        QCOMPARE(force.removalRate, 5.0);
        QCOMPARE(force.tangential, 0.8);
        QCOMPARE(force.radial, 0.3 * 0.4 + 0.5 * 0.4);
        // Against the motion along x, and away from material at larger y.
        QVERIFY(glm::length(force.force - glm::dvec3(-0.8, -0.32, 0.0)) < 1e-12);
        // The force that is felt: 0.005 mm³ over 0.02 mm; 4/5 of K = 0.5 and 1/5 of K = 2.
        QCOMPARE(force.area, 0.25);
        QCOMPARE(force.energy, 0.8);
        QCOMPARE(force.radialRatio, (0.4 * 0.3 + 0.4 * 0.5) / 0.8);
    }

    /// If tool, motion and material are rotated together, the force rotates with them.
    void anyAxisIsAsGoodAsUpright() {
        const CuttingForce upright = forceOf(twoMaterials(), {0.01, 0.005, -0.01}, {10.0, 0.5, 0.0}, 5000.0);
        for (const glm::dvec3& about : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 2, -3)}) {
            const glm::dquat turn = glm::angleAxis(2.2, glm::normalize(about));
            CutResult cut = twoMaterials();
            cut.reportedCentroid = turn * cut.reportedCentroid;
            const CuttingForce turned =
                forceOf(cut, turn * glm::dvec3(0.01, 0.005, -0.01), turn * glm::dvec3(10.0, 0.5, 0.0), 5000.0,
                        turn * glm::dvec3(0.0, 0.0, 1.0));
            QVERIFY(glm::length(turned.force - turn * upright.force) < 1e-12);
            QVERIFY(glm::length(turned.away - turn * upright.away) < 1e-12);
        }
    }

    /// A tool that rotates about its tip cuts as well: the force acts against the motion of the point of removal.
    void aTurningAxisIsFelt() {
        CutResult cut = twoMaterials();
        cut.reportedCentroid = {0.0, 3.0, 10.0};
        const SpinningTool tool{3.0, 5000.0, 500.0};
        const double angle = 0.002;
        const CuttingForce force =
            cuttingForce(cut, cuttingCoefficients(materials(), 6.0), tool, {glm::dvec3(0.0), {0.0, 0.0, 1.0}},
                         {glm::dvec3(0.0), {0.0, std::sin(angle), std::cos(angle)}}, 0.001);
        QVERIFY(std::abs(glm::length(force.motion) - angle * std::hypot(3.0, 10.0)) < 1e-6);
        QCOMPARE(force.tangential, 0.8);
        QVERIFY(force.force.y < -0.7);
    }

    /// When plunging, the point of removal moves about the axis: the force along it must not jump sideways.
    void aPlungingToolIsPushedAlongItsAxis() {
        glm::dvec3 before(0.0);
        for (double x = -2.0; x <= 2.0; x += 0.01) {
            CutResult cut = twoMaterials();
            cut.reportedCentroid = {10.0 + x, 0.0, -0.5};
            const glm::dvec3 away = forceOf(cut, {0.0, 0.0, -0.01}, {10.0, 0.0, 0.0}, 5000.0).away;
            QVERIFY(std::abs(glm::length(away) - 1.0) < 1e-12);
            if (x > -2.0) QVERIFY(glm::length(away - before) < 0.03);
            if (std::abs(x) < 0.005) QVERIFY(away.z > 0.999);
            if (std::abs(x) > 1.01) QVERIFY(std::abs(away.z) < 1e-6 && away.x * x < 0.0);
            before = away;
        }
    }

    /// K(h) = kc1.1 h^-mc / 1000. A slot of 6 mm, 2 deep, 20 mm/s, v 5 m/s, two teeth: 530.5 teeth/s, so fz = 0.0377
    /// mm, and the mean chip over half a revolution is 2 / pi of it.
    void kienzlesLawGivesThinChipsMoreEnergy() {
        PropertyList list;
        Property aluminium = material("aluminium", 0.9, 0.4);
        aluminium.values[std::string(kienzleForce)] = {800.0, "N/mm^2", "ISCAR", false};
        aluminium.values[std::string(kienzleExponent)] = {0.25, "1", "ISCAR", false};
        aluminium.values[std::string(chipLoadPerDiameter)] = {0.008, "1", "test", false};
        QVERIFY(list.add(aluminium).hasValue());
        const CuttingCoefficients coefficients = cuttingCoefficients(list, 6.0);
        // The published table: 2.13, 1.69, 1.42, 1.20 J/mm³ at 0.02, 0.05, 0.1, 0.2 mm.
        const CuttingCoefficients::Entry& entry = coefficients.byProperty[1];
        QVERIFY(std::abs(entry.energyAt(0.02) - 2.13) < 0.005);
        QVERIFY(std::abs(entry.energyAt(0.05) - 1.69) < 0.005);
        QVERIFY(std::abs(entry.energyAt(0.1) - 1.42) < 0.005);
        QVERIFY(std::abs(entry.energyAt(0.2) - 1.20) < 0.005);
        QCOMPARE(entry.energyAt(0.0), entry.energyAt(0.005));
        QVERIFY(std::abs(entry.tableEnergy / (0.8 * std::pow(2.0 / pi * 0.048, -0.25)) - 1.0) < 1e-12);
        QCOMPARE(coefficients.hardest, entry.tableEnergy);
        CutResult cut;
        cut.removed[0] = {1, 0, 0.0, 12.0 * 0.02};
        cut.reported = 12.0 * 0.02;
        cut.reportedCentroid = {12.0, 0.0, 1.0};
        cut.engagement.area = pi * 3.0 * 2.0; // half the wall of the cutter
        const CuttingForce force =
            forceOf(cut, {0.02, 0.0, 0.0}, {10.0, 0.0, 0.0}, 5000.0, {0.0, 0.0, 1.0}, coefficients);
        const double chip = 2.0 / pi * 20.0 / (2.0 * 5000.0 / (6.0 * pi));
        const double expected = 800.0 * std::pow(chip, -0.25) * 240.0 / 5000.0;
        QVERIFY(std::abs(force.tangential / expected - 1.0) < 1e-12);
    }

    void theReferenceCutIsASlot() {
        QVERIFY(std::abs(slotArea(flat(6.0, 20.0), 3.0) / 18.0 - 1.0) < 1e-9);
        QVERIFY(std::abs(slotArea(ball(6.0, 20.0), 3.0) / (0.5 * pi * 9.0) - 1.0) < 2e-3);
        QVERIFY(std::abs(slotArea(ball(6.0, 20.0), 5.0) / (0.5 * pi * 9.0 + 12.0) - 1.0) < 2e-3);
        QVERIFY(std::abs(slotArea(bullNose(6.0, 1.0, 20.0), 3.0) / (18.0 - 2.0 + 0.5 * pi) - 1.0) < 2e-3);
    }

    void materialRightBelowPushesUp() {
        CutResult cut = twoMaterials();
        cut.reportedCentroid = {10.0, 0.0, -1.0};
        const CuttingForce force = forceOf(cut, {0.0, 0.0, -0.01}, {10.0, 0.0, 0.0}, 5000.0);
        QVERIFY(glm::length(force.force - glm::dvec3(0.0, 0.0, 0.8 + 0.32)) < 1e-12);
    }

    void noRemovalNoForce() {
        const CuttingForce force = forceOf({}, {0.1, 0.0, 0.0}, {}, 5000.0);
        QCOMPARE(force.tangential, 0.0);
        QVERIFY(force.force == glm::dvec3(0.0));
    }

    /// From the cut to the force: a slot 6 wide and 2 deep at 10 mm/s in K = 0.5 at v = 2 m/s means
    /// 120 mm³/s, 60 W, 30 N.
    void aSlotGivesTheForceOfItsRemovalRate() {
        const Grid fine = grid({-15.0, -15.0, -7.0}, 0.2, {150, 150, 35});
        RunVolume workpiece = block(fine);
        MaterialRemoval removal(flat(6.0, 20.0), fine);
        glm::dvec3 tip(-8.0, 0.0, -2.0);
        removal.cut(workpiece, tip + glm::dvec3(0.0, 0.0, 8.0), tip);
        double mean = 0.0;
        for (int tick = 0; tick < 900; ++tick) {
            const glm::dvec3 motion(0.01, 0.0, 0.0);
            const CutResult cut = removal.cut(workpiece, tip, tip + motion);
            tip += motion;
            if (tick < 300) continue;
            const CuttingForce force = forceOf(cut, motion, tip, 2000.0);
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

    /// 9,000 1/min and 700 mm/min are used as they are stated; the plunge feed is the material's 0.3 of the feed. At a
    /// spindle of 6,000 1/min all are two thirds. 0.05 mm per tooth are 0.05 · 2 · 9,000 mm/min.
    void aPresetStandsBeforeTheTable() {
        const Property material = withValues(300.0, 0.008, 0.3);
        Tool tool = sixMillimetres();
        CuttingPreset preset;
        preset.name = "own";
        preset.material = material.id;
        preset.spindleSpeed = 9000.0;
        preset.feed = 700.0;
        tool.presets = {preset};
        const Result<CuttingConditions> stated = cuttingConditions(tool, material, 24000.0, 4000.0);
        QVERIFY(stated);
        QCOMPARE(stated->spindleSpeed, 9000.0);
        QCOMPARE(stated->feed, 700.0);
        QCOMPARE(stated->plungeFeed, 210.0);
        QCOMPARE(stated->surfaceSpeed, pi * 6.0 * 150.0);
        QVERIFY(!stated->limitedByMachine);
        tool.presets[0].plungeFeed = 90.0;
        const Result<CuttingConditions> slow = cuttingConditions(tool, material, 6000.0, 4000.0);
        QVERIFY(slow && slow->limitedByMachine);
        QCOMPARE(slow->spindleSpeed, 6000.0);
        QVERIFY(std::abs(slow->feed - 700.0 * 2.0 / 3.0) < 1e-9 && std::abs(slow->plungeFeed - 60.0) < 1e-9);
        QCOMPARE(cuttingConditions(tool, material, 24000.0, 500.0)->feed, 500.0);
        tool.presets[0].feed = 0.0;
        tool.presets[0].chipLoad = 0.05;
        QVERIFY(std::abs(cuttingConditions(tool, material, 24000.0, 4000.0)->feed - 900.0) < 1e-9);
    }

    /// Which preset: that of the material, else that for any, else the table as before.
    void presetsAreForTheirMaterial() {
        const Property material = withValues(300.0, 0.008, 0.3);
        Tool tool = sixMillimetres();
        CuttingPreset any, other;
        any.name = "any";
        any.spindleSpeed = 5000.0;
        any.feed = 300.0;
        other = any;
        other.name = "other";
        other.material = "brass";
        other.spindleSpeed = 6000.0;
        const auto speed = [&] { return cuttingConditions(tool, material, 24000.0, 4000.0)->spindleSpeed; };
        const double table = speed();
        tool.presets = {other};
        QCOMPARE(speed(), table);
        tool.presets = {other, any};
        QCOMPARE(speed(), 5000.0);
        tool.presets.push_back(other);
        tool.presets.back().name = "its own";
        tool.presets.back().material = material.id;
        QCOMPARE(speed(), 6000.0);
        // A preset with a plunge feed needs no value of the material.
        Property bare = material;
        bare.values.clear();
        QVERIFY(!cuttingConditions(tool, bare, 24000.0, 4000.0));
        tool.presets.back().plungeFeed = 100.0;
        QCOMPARE(cuttingConditions(tool, bare, 24000.0, 4000.0)->plungeFeed, 100.0);
        QCOMPARE(advisedCoolant(tool, material), Coolant::off);
        tool.presets.back().coolant = Coolant::flood;
        QCOMPARE(advisedCoolant(tool, material), Coolant::flood);
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

    /// A drill at 120 m/min and 0.01 of its diameter per tooth, whatever the values for end mills; all its feed is
    /// plunging.
    void valuesOfACutterStandBeforeThoseForAll() {
        Property material = withValues(300.0, 0.008, 0.3);
        material.values["surface_speed_drill"] = {120.0, "m/min", "test", false};
        material.values["chip_load_per_diameter_drill"] = {0.01, "1", "test", false};
        material.values["plunge_feed_ratio_drill"] = {1.0, "1", "test", false};
        Tool drill = *loadTool("drill-5");
        drill.maximumSpindleSpeed = 0.0;
        const Result<CuttingConditions> found = cuttingConditions(drill, material, 24000.0, 4000.0);
        QVERIFY(found);
        const double turns = 120'000.0 / (std::acos(-1.0) * 5.0);
        QVERIFY(std::abs(found->spindleSpeed - turns) < 1e-6);
        QVERIFY(std::abs(found->feed - turns * drill.fluteCount * 0.05) < 1e-6);
        QCOMPARE(found->plungeFeed, found->feed);
        const Result<CuttingConditions> milled = cuttingConditions(sixMillimetres(), material, 24000.0, 4000.0);
        const Result<CuttingConditions> before =
            cuttingConditions(sixMillimetres(), withValues(300.0, 0.008, 0.3), 24000.0, 4000.0);
        QCOMPARE(milled->feed, before->feed);
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
                // The hardest material with the largest drill: 24 m/min at 12 mm are 637 1/min.
                QVERIFY(found->spindleSpeed > 600.0 && found->spindleSpeed <= 24000.0);
                QVERIFY(found->feed > 20.0 && found->feed <= 4000.0);
                QVERIFY(found->plungeFeed > 0.0 && found->plungeFeed <= found->feed);
            }
        }
    }
};

BURIN_TEST(CuttingForceTest, NoApplication)

} // namespace burin::tst_cutting_force

#include "tst_cutting_force.moc"
