// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/geometry/mesh_distance.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/fixture_library.h"
#include "core/setup/fixture_measures.h"
#include "core/setup/fixture_placement.h"
#include "core/setup/fixture_solid.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>
#include <set>

namespace burin::tst_fixtures {

namespace {

const Box block{{-20.0, -15.0, -10.0}, {20.0, 15.0, 20.0}};

double volumeOf(const FixtureDesign& design) {
    return signedVolume(meshOf(design));
}

bool near(double one, double other, double within = 1e-9) {
    return std::abs(one - other) <= within * std::max(1.0, std::abs(other));
}

/// Volume of cylinders on each other: between the exact one and that of cylinders wider by the chord.
struct Bounds {
    double least = 0.0, most = 0.0;
    void add(double radius, double height) {
        least += pi * radius * radius * height;
        most += pi * (radius + cylinderChord) * (radius + cylinderChord) * height;
    }
};

/// Sizes at random within their ranges; not all go together.
FixtureDesign randomFixture(FixtureKind kind, std::mt19937& random) {
    FixtureDesign design = standardFixture(kind);
    for (std::size_t i = 0; i < design.values.size(); ++i) {
        const FixtureParameter& parameter = rowOf(kind).parameters[i];
        const double low = std::max(parameter.range.low, 0.3 * parameter.standard),
                     high = std::min(parameter.range.high, 2.0 * parameter.standard);
        design.values[i] = std::uniform_real_distribution<double>(low, high)(random);
    }
    design.place = {1.0, 2.0, 3.0};
    design.turn = std::uniform_real_distribution<double>(-pi, pi)(random);
    return design;
}

} // namespace

class TestFixtures : public QObject {
    Q_OBJECT
private slots:
    void everyKindAndSizeIsDescribed() {
        std::set<std::string> ids;
        for (const FixtureKindRow& row : fixtureKinds) {
            QCOMPARE(&rowOf(row.kind), &row);
            QCOMPARE(fixtureKindFromId(row.id), std::optional(row.kind));
            QVERIFY(ids.insert(row.id).second);
            QVERIFY(*row.title.text != '\0' && *row.toolTip.text != '\0');
            std::set<std::string> keys;
            for (const FixtureParameter& parameter : row.parameters) {
                QVERIFY2(keys.insert(parameter.key).second, parameter.key);
                QVERIFY2(*parameter.label.text != '\0' && *parameter.toolTip.text != '\0', parameter.key);
                QVERIFY2(*parameter.source != '\0', parameter.key);
                QVERIFY2(parameter.range.low < parameter.standard && parameter.standard < parameter.range.high,
                         parameter.key);
            }
            QVERIFY2(checkFixture(standardFixture(row.kind)), row.id);
        }
    }

    void boxesHaveTheVolumeOfTheirSizes() {
        FixtureDesign vise = standardFixture(FixtureKind::vise); // 60 between jaws of 125 x 40 x 30, body 125 x 60
        QVERIFY(near(volumeOf(vise), 2 * 125.0 * 40 * 30 + 125.0 * 60 * (60 + 2 * 30 + 100)));
        setValue(vise, "body-width", 90.0);
        vise.turn = 0.3;
        QVERIFY(near(volumeOf(vise), 2 * 125.0 * 40 * 30 + 90.0 * 60 * (60 + 2 * 30 + 100)));
        QVERIFY(near(volumeOf(standardFixture(FixtureKind::toeClamp)), 10.0 * 20 * 6 + 60.0 * 40 * 20));
        QVERIFY(near(volumeOf(standardFixture(FixtureKind::parallels)), 2 * 150.0 * 8 * 20));
        QVERIFY(near(volumeOf(standardFixture(FixtureKind::plate)), 300.0 * 200 * 20));
    }

    void roundBodiesAreEnclosed() {
        Bounds screw; // M8: 20 deep, washer 16 x 1.6, head 13 across flats
        screw.add(4.0, 20.0);
        screw.add(8.0, 1.6);
        Bounds socket = screw;
        screw.add(13.0 / std::sqrt(3.0), 5.3);
        socket.add(6.5, 8.0);
        const double hex = volumeOf(standardFixture(FixtureKind::hexScrew)),
                     cap = volumeOf(standardFixture(FixtureKind::socketScrew));
        QVERIFY(screw.least < hex && hex < screw.most);
        QVERIFY(socket.least < cap && cap < socket.most);
        // A bar of 100 x 40 x 20 with a hole of 14 x 14; steps of 15 mm, as high as 30, 20 and 10; an M12 stud.
        Bounds stud;
        stud.add(6.0, 30.0 + 20.0 + solidGap);
        stud.add(18.0, 6.0);
        stud.add(18.0 / std::sqrt(3.0), 10.8);
        stud.add(6.0, 10.0);
        const double boxes = 20.0 * (100.0 * 40.0 - 14.0 * 14.0) + 15.0 * 40.0 * (30.0 + 20.0 + 10.0),
                     clamp = volumeOf(standardFixture(FixtureKind::stepClamp)) - boxes;
        QVERIFY2(stud.least < clamp && clamp < stud.most, qPrintable(QString::number(clamp)));
    }

    void surfacesAreClosedForAllSizes() {
        std::mt19937 random(34);
        for (const FixtureKindRow& row : fixtureKinds) {
            int made = 0;
            for (int i = 0; i < 400 && made < 25; ++i) {
                const FixtureDesign design = randomFixture(row.kind, random);
                if (!checkFixture(design)) continue;
                ++made;
                const TriangleMesh mesh = meshOf(design);
                QCOMPARE(countOpenEdges(mesh), std::size_t{0});
                QVERIFY(signedVolume(mesh) > 0.0);
                Obstacle fixture;
                fixture.shape = mesh;
                QVERIFY(checkObstacle(fixture));
            }
            QVERIFY2(made >= 5, row.id);
        }
    }

    /// Inside and outside are told apart next to the gap between nut and bar, too.
    void solidsHaveAnInside() {
        const FixtureDesign clamp = standardFixture(FixtureKind::stepClamp);
        const MeshDistance distance(meshOf(clamp));
        const auto at = [&](double x, double y, double z) { return distance.closest({x, y, z}).signedDistance; };
        QVERIFY(at(0.0, 0.0, 10.0) < 0.0);          // bar
        QVERIFY(at(35.0 + 12.0, 0.0, 20.05) < 0.0); // washer, close above the bar
        QVERIFY(at(35.0 + 12.0, 0.0, 19.95) < 0.0); // bar, close below the washer
        QVERIFY(at(35.0, 0.0, 10.0) < 0.0);         // stud in its hole
        QVERIFY(at(35.0 + 6.5, 0.0, 10.0) > 0.0);   // between stud and bar
        QVERIFY(at(35.0, 0.0, 50.0) > 0.0);         // above the stud
        QVERIFY(near(at(35.0, 0.0, 26.01 + 10.8 + 10.0 + 3.0), 3.0, 1e-6));
        QVERIFY(at(90.0, 0.0, -29.0) < 0.0 && at(60.0, 0.0, -15.0) > 0.0); // step block, and the space before it
    }

    /// In a drawing, each measure is as long as its parameter, in the plane of its view and beside the solids.
    void measuresHaveTheLengthOfTheirParameter() {
        std::mt19937 random(7);
        for (const FixtureKindRow& row : fixtureKinds)
            for (int i = 0; i < 50; ++i) {
                FixtureDesign design = randomFixture(row.kind, random);
                if (i == 0) design = standardFixture(row.kind);
                if (!checkFixture(design)) continue;
                const std::vector<FixtureMeasure> measures = measuresOf(design);
                QCOMPARE(measures.size(), design.values.size());
                design.turn = 0.0;
                design.place = glm::dvec3(0.0);
                const Box bounds = boundingBox(meshOf(design)).grown(1e-6);
                for (std::size_t p = 0; p < measures.size(); ++p) {
                    const FixtureMeasure& measure = measures[p];
                    QVERIFY2(near(glm::distance(measure.from, measure.to), design.values[p]), row.parameters[p].key);
                    const int across = measure.view == FixtureView::side ? 1 : 2;
                    for (glm::dvec3 end : {measure.from, measure.to}) {
                        QCOMPARE(end[across], 0.0);
                        end[across] = bounds.centre()[across];
                        QVERIFY2(bounds.contains(end), row.parameters[p].key);
                    }
                }
            }
    }

    void aViseGripsTheWidthOfTheStock() {
        const FixtureSite site = siteOf(block, {});
        QCOMPARE(site.table, -10.0);
        const std::pair<glm::dvec3, int> clicks[] = {
            {{20, 0, 5}, 0}, {{-20, 3, 5}, 0}, {{2, -15, 5}, 1}, {{2, 15, 5}, 1}};
        for (const auto& [click, axis] : clicks) {
            const FixtureDesign vise = placedAt(standardFixture(FixtureKind::vise), {}, site, click);
            QCOMPARE(valueOf(vise, "opening"), block.size()[axis]);
            QCOMPARE(depthIn(vise, block), 0.0);
            // The faces of the jaws are the sides of the stock, bit for bit, as high as the grip.
            const TriangleMesh mesh = meshOf(vise);
            for (const double side : {block.low[axis], block.high[axis]})
                QVERIFY(std::ranges::any_of(mesh.vertices, [&](const glm::dvec3& vertex) {
                    return vertex[axis] == side && vertex.z == block.low.z + 8.0;
                }));
            // The movable jaw and its spindle are opposite the clicked side.
            const Box bounds = boundingBox(mesh);
            const bool high = click[axis] > 0.0;
            const double spindle = high ? block.low[axis] - bounds.low[axis] : bounds.high[axis] - block.high[axis];
            QVERIFY(near(spindle, 130.0));
            FixtureDesign closer = vise;
            setValue(closer, "opening", block.size()[axis] - 1.0);
            QVERIFY(near(depthIn(closer, block), 0.5));
        }
    }

    void aStepClampPointsToTheNearestSide() {
        const FixtureSite site = siteOf(block, {});
        const FixtureDesign clamp = placedAt(standardFixture(FixtureKind::stepClamp), {}, site, {2.0, 9.0, 20.0});
        QCOMPARE(clamp.place, glm::dvec3(2.0, 9.0, 20.0));
        QCOMPARE(clamp.turn, 0.5 * pi);
        QCOMPARE(valueOf(clamp, "height"), 30.0);
        const Box bounds = boundingBox(meshOf(clamp));
        QVERIFY(near(bounds.low.y, 9.0 - 5.0) && near(bounds.low.x, 2.0 - 20.0) && near(bounds.low.z, -10.0, 1e-6));
        QCOMPARE(depthIn(clamp, block), 0.0);
        // From the middle of a wide stock the stud stands outside all the same, unless its distance is given.
        const Box wide{{-200.0, -100.0, 0.0}, {200.0, 100.0, 20.0}};
        const FixtureDesign far = placedAt(standardFixture(FixtureKind::stepClamp), {}, siteOf(wide, {}), {0, 10, 20});
        QVERIFY(near(valueOf(far, "stud-distance"), 90.0 + 6.0 + 2.0));
        QVERIFY(checkFixture(far));
        QCOMPARE(depthIn(far, wide), 0.0);
        FixtureDesign given = standardFixture(FixtureKind::stepClamp);
        setValue(given, "stud-distance", 50.0);
        given = placedAt(given, {"stud-distance"}, siteOf(wide, {}), {0, 10, 20});
        QCOMPARE(valueOf(given, "stud-distance"), 50.0);
        QVERIFY(depthIn(given, wide) > 0.0);
    }

    void theOthersStandWhereTheyAreClicked() {
        const FixtureSite site = siteOf(block, {});
        const FixtureDesign toe = placedAt(standardFixture(FixtureKind::toeClamp), {}, site, {-19.0, 4.0, 20.0});
        QCOMPARE(toe.place, glm::dvec3(-20.0, 4.0, -10.0));
        QCOMPARE(toe.turn, pi);
        QVERIFY(near(boundingBox(meshOf(toe)).high.x, -20.0));
        for (const auto& [point, height] : {std::pair{glm::dvec3(3, 4, 20), 20.0}, {glm::dvec3(40, 4, -10), -10.0}}) {
            const FixtureDesign screw = placedAt(standardFixture(FixtureKind::socketScrew), {}, site, point);
            QCOMPARE(screw.place, glm::dvec3(point.x, point.y, height));
            QCOMPARE(depthIn(screw, block), 0.0); // its thread may be in the stock
        }
        const FixtureDesign parallels = placedAt(standardFixture(FixtureKind::parallels), {}, site, {0, 0, 20});
        QCOMPARE(parallels.place, glm::dvec3(0.0, 0.0, -10.0));
        QVERIFY(near(boundingBox(meshOf(parallels)).high.z, -10.0));
        QVERIFY(near(boundingBox(meshOf(parallels)).size().y, 9.0 + 8.0)); // 1 mm between them, as there is no room
        const Box wide{{-200.0, -100.0, 0.0}, {200.0, 100.0, 20.0}};
        const FixtureDesign apart = placedAt(standardFixture(FixtureKind::parallels), {}, siteOf(wide, {}), {0, 0, 20});
        QVERIFY(near(boundingBox(meshOf(apart)).size().y, 200.0 - 2.0 * 8.0)); // 8 mm inside both sides
    }

    /// The table is below the parallels, or the top of the plate.
    void clampsReachDownToTheTable() {
        std::vector<Obstacle> fixtures;
        const auto add = [&](FixtureKind kind) {
            const FixtureDesign design =
                placedAt(standardFixture(kind), {}, siteOf(block, fixtures), firstPoint(kind, block));
            const Result<Obstacle> fixture = fixtureOf(design, block, "fixture", 1.0);
            QVERIFY(fixture);
            fixtures.push_back(*fixture);
        };
        add(FixtureKind::parallels);
        QCOMPARE(siteOf(block, fixtures).table, -30.0);
        add(FixtureKind::plate);
        QCOMPARE(siteOf(block, fixtures).table, -30.0);
        add(FixtureKind::stepClamp);
        QCOMPARE(valueOf(*fixtures.back().design, "height"), 50.0);
        add(FixtureKind::toeClamp);
        QCOMPARE(valueOf(*fixtures.back().design, "grip-height"), 32.0);
        QVERIFY(near(boundsOf(fixtures.back()).low.z, -30.0));
        for (const FixtureKindRow& row : fixtureKinds) add(row.kind); // each can be added where it is first shown
    }

    /// A corner of a turned plate enters the stock by a length that is known.
    void theDepthInTheStockIsTold() {
        FixtureDesign plate = standardFixture(FixtureKind::plate);
        setValue(plate, "length", 100.0);
        setValue(plate, "width", 100.0);
        plate.turn = 0.25 * pi;
        const double reach = 50.0 * std::sqrt(2.0);
        plate.place = {block.high.x + reach - 1.5, 0.0, 10.0};
        QVERIFY(near(depthIn(plate, block), 1.5));
        const Result<Obstacle> refused = fixtureOf(plate, block, "Plate", 1.0);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::fixtureInStock);
        QCOMPARE(refused.error().subject, std::string("Plate"));
        QVERIFY(refused.error().place.starts_with("1.50") && refused.error().place.ends_with(" mm"));
        plate.place.x += 1.5;
        QVERIFY(fixtureOf(plate, block, "Plate", 1.0));
        FixtureDesign screw = standardFixture(FixtureKind::socketScrew);
        screw.place = {block.high.x + 3.0, block.high.y + 4.0, 10.0}; // 5 mm from the edge, washer 8 mm
        QVERIFY(near(depthIn(screw, block), 3.0));
        screw.place.z = block.high.z - 1.1; // upwards, the washer is out sooner
        QVERIFY(near(depthIn(screw, block), 1.1));
    }

    void sizesThatDoNotGoTogetherAreRefused() {
        FixtureDesign vise = standardFixture(FixtureKind::vise);
        setValue(vise, "jaw-height", 5.0);
        Result<void> refused = checkFixture(vise);
        QVERIFY(!refused);
        QCOMPARE(refused.error().subject, std::string("jaw-height"));
        QCOMPARE(refused.error().place, std::string("5"));
        QVERIFY(refused.error().detail.starts_with("8.000 mm or more"));
        setValue(vise, "jaw-height", 501.0);
        QCOMPARE(checkFixture(vise).error().detail, std::string("a length of 1 to 500 mm"));
        vise = standardFixture(FixtureKind::vise);
        vise.place.x = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!checkFixture(vise));
        setValue(vise, "opening", std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(checkFixture(vise).error().subject, std::string("opening"));
    }
};

BURIN_TEST(TestFixtures, NoApplication)

} // namespace burin::tst_fixtures

#include "tst_fixtures.moc"
