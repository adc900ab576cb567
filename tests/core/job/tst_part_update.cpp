// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/part_update.h"
#include "tests/core/document/sample_project.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_part_update {

namespace {

Body bodyOf(const std::string& name, const glm::dvec3& low, const glm::dvec3& high) {
    Body body;
    body.name = name;
    body.box = {low, high};
    body.mesh = shapes::box(low, high);
    const glm::dvec3 size = high - low;
    body.volume = size.x * size.y * size.z;
    return body;
}

Model modelOf(std::vector<Body> bodies) {
    Model model;
    model.sourceFile = "/parts/plate.step";
    model.format = "STEP AP214";
    model.lengthUnit = "mm";
    model.bodies = std::move(bodies);
    return model;
}

/// A plate of brass in a stock of aluminium, and a clamp.
Model plateAndClamp() {
    return modelOf({bodyOf("plate", {0, 0, 0}, {40, 30, 10}), bodyOf("clamp", {50, 0, 0}, {60, 30, 10})});
}

struct Stored {
    QTemporaryDir folder;
    Project project = *Project::create(folder.filePath("p.burin").toStdString());

    Stored() {
        Setup setup;
        setup.roles = {BodyRole::part, BodyRole::fixture};
        setup.bodyMaterials = {"brass", ""};
        setup.marginLow = glm::dvec3(2.0);
        setup.marginHigh = glm::dvec3(3.0);
        setup.zero.on = ZeroReference::part;
        if (!project.setModel(plateAndClamp())) std::abort(); // the test's own set-up
        if (!project.setSetup(placeStock(plateAndClamp(), setup).value())) std::abort();
    }
    Setup setup() const { return project.setup().value(); }
};

} // namespace

/// A part that was changed in the CAD system is read again into a project.
class TestPartUpdate : public QObject {
    Q_OBJECT
private slots:
    void rolesAndMaterialsGoByName() {
        Stored stored;
        const Model now = modelOf({bodyOf("bolt", {70, 0, 0}, {75, 5, 20}), bodyOf("clamp", {50, 0, 0}, {60, 30, 10}),
                                   bodyOf("plate", {0, 0, 0}, {44, 30, 10})});
        const Result<PartUpdate> update = updatePart(stored.project, now);
        QVERIFY(update.hasValue());
        QCOMPARE(update->changed, std::vector<std::string>{"plate"});
        QCOMPARE(update->added, std::vector<std::string>{"bolt"});
        QVERIFY(update->removed.empty() && !update->stockStays);
        const Setup setup = stored.setup();
        QCOMPARE(setup.roles, (std::vector{BodyRole::part, BodyRole::fixture, BodyRole::part}));
        QCOMPARE(setup.bodyMaterials, (std::vector<std::string>{"", "", "brass"}));
        // The stock is fitted around the parts again: the plate, and the bolt that is now a part.
        QCOMPARE(setup.stock.low, glm::dvec3(-2.0));
        QCOMPARE(setup.stock.high, glm::dvec3(78.0, 33.0, 23.0));
        QVERIFY(fixture::identical(stored.project.model().value(), now));
    }

    void aBodyThatIsGoneIsTold() {
        Stored stored;
        const Result<PartUpdate> update =
            updatePart(stored.project, modelOf({bodyOf("plate", {0, 0, 0}, {40, 30, 10})}));
        QVERIFY(update.hasValue());
        QVERIFY(update->changed.empty() && update->added.empty());
        QCOMPARE(update->removed, std::vector<std::string>{"clamp"});
        QCOMPARE(stored.setup().roles, std::vector{BodyRole::part});
    }

    void theSameFileChangesNothing() {
        Stored stored;
        const Setup before = stored.setup();
        const Result<PartUpdate> update = updatePart(stored.project, plateAndClamp());
        QVERIFY(update.hasValue() && update->nothing());
        QVERIFY(fixture::identical(stored.setup(), before));
    }

    /// By the path; below a root that was renamed; by the name alone, as in projects from before there were paths.
    void bodiesOfAssembliesGoByTheirPaths() {
        const auto bolt = [](const char* path, double x) { return bodyOf(path, {x, 0, 0}, {x + 5, 5, 5}); };
        const auto rolesAfter = [&](const std::vector<Body>& before, const std::vector<BodyRole>& roles,
                                    const std::vector<Body>& now, PartUpdate& update) {
            Stored stored;
            Setup setup = stored.setup();
            setup.roles = roles;
            setup.bodyMaterials.clear();
            if (!stored.project.setModel(modelOf(before)) || !stored.project.setSetup(setup))
                return std::vector<BodyRole>();
            Result<PartUpdate> done = updatePart(stored.project, modelOf(now));
            if (!done) return std::vector<BodyRole>();
            update = std::move(*done);
            return stored.setup().roles;
        };
        const std::vector<BodyRole> roles{BodyRole::part, BodyRole::fixture, BodyRole::ignored};
        const std::vector<BodyRole> turned{BodyRole::ignored, BodyRole::part, BodyRole::fixture};
        PartUpdate update;
        QCOMPARE(rolesAfter({bolt("V/A/Bolt", 0), bolt("V/B/Bolt:1", 9), bolt("V/B/Bolt:2", 18)}, roles,
                            {bolt("V/B/Bolt:2", 18), bolt("V/A/Bolt", 0), bolt("V/B/Bolt:1", 9)}, update),
                 turned);
        QVERIFY(update.nothing());
        QCOMPARE(rolesAfter({bolt("V v1/A/Bolt", 0), bolt("V v1/B/Bolt:1", 9), bolt("V v1/B/Bolt:2", 18)}, roles,
                            {bolt("V v2/B/Bolt:2", 18), bolt("V v2/A/Bolt", 0), bolt("V v2/B/Bolt:1", 9)}, update),
                 turned);
        QVERIFY(update.nothing());
        QCOMPARE(rolesAfter({bolt("Bolt", 0), bolt("Bolt", 9), bolt("Nut", 18)}, roles,
                            {bolt("V/Nut", 18), bolt("V/Bolt:1", 0), bolt("V/Bolt:2", 9)}, update),
                 turned);
        QVERIFY(update.nothing());
        // Of a project made before there were paths; a name of the file had a '/', which is another letter now.
        QCOMPARE(rolesAfter({bolt("M6/A2", 0), bolt("M8/A2", 9), bolt("Nut", 18)}, roles,
                            {bolt("V/Nut", 18), bolt("V/M6\u2044A2", 0), bolt("V/M8\u2044A2", 9)}, update),
                 turned);
        QVERIFY(update.nothing());
    }

    /// The part is mirrored about x = 20 mm. Read in cm, it is ten times as large, and mirrored about x = 200 mm.
    void anotherUnitScalesWhatWasMirrored() {
        Stored stored;
        Model before = plateAndClamp(),
              now =
                  modelOf({bodyOf("plate", {0, 0, 0}, {400, 300, 100}), bodyOf("clamp", {500, 0, 0}, {600, 300, 100})});
        before.statedUnit = now.statedUnit = 1.0;
        now.unitScale = 10.0;
        const Placement mirror = mirroredAcross(0, glm::dvec3(20.0, 0.0, 0.0));
        QVERIFY(stored.project.setModel(*placed(std::make_shared<const Model>(before), mirror)).hasValue());
        QVERIFY(updatePart(stored.project, now).hasValue());
        const Box plate = stored.project.model().value().bodies[0].box; // x becomes 400 - x
        QVERIFY(glm::distance(plate.low, glm::dvec3(0.0)) < 1e-9);
        QVERIFY(glm::distance(plate.high, glm::dvec3(400.0, 300.0, 100.0)) < 1e-9);
    }

    void aColourIsKeptUntilTheFileHasOne() {
        Stored stored;
        QVERIFY(stored.project.setBodyColours({BodyColour({9, 8, 7}), BodyColour({1, 2, 3})}).hasValue());
        Model now = plateAndClamp();
        now.bodies[0].colour = {{250, 0, 0}};
        QVERIFY(updatePart(stored.project, now).hasValue());
        const Model model = stored.project.model().value();
        QVERIFY(model.bodies[0].colour == BodyColour({250, 0, 0}) && model.bodies[1].colour == BodyColour({1, 2, 3}));
    }

    void oneBodyInThePlaceOfOneMayHaveAnotherName() {
        Stored stored;
        QVERIFY(updatePart(stored.project, modelOf({bodyOf("plate", {0, 0, 0}, {40, 30, 10})})).hasValue());
        const auto update = updatePart(stored.project, modelOf({bodyOf("plate v2", {0, 0, 0}, {40, 30, 12})}));
        QVERIFY(update.hasValue());
        QCOMPARE(update->changed, std::vector<std::string>{"plate v2"});
        QVERIFY(update->added.empty() && update->removed.empty());
        QCOMPARE(stored.setup().bodyMaterials, std::vector<std::string>{"brass"});
    }

    /// A recording stays in its stock, bitwise unchanged.
    void stockAndZeroStayWhereSomethingWasMilled() {
        Stored stored;
        QVERIFY(stored.project.setTool(fixture::tool()).hasValue());
        QVERIFY(stored.project.addGenerated(fixture::generatedMoves()).hasValue());
        const Setup before = stored.setup();
        const Model now =
            modelOf({bodyOf("plate", {-5, 0, 0}, {40, 30, 18}), bodyOf("clamp", {50, 0, 0}, {60, 30, 10})});
        const Result<PartUpdate> update = updatePart(stored.project, now);
        QVERIFY(update.hasValue());
        QVERIFY(update->stockStays);
        const Setup after = stored.setup();
        QCOMPARE(after.stock.low, before.stock.low);
        QCOMPARE(after.stock.high, before.stock.high);
        QCOMPARE(after.workOffset, before.workOffset);
        // And they stay when the setup is evaluated again.
        const Setup again = placeStock(now, after).value();
        QCOMPARE(again.stock.high, before.stock.high);
        QCOMPARE(again.workOffset, before.workOffset);
        QCOMPARE(stored.project.generated().value().size(), std::size_t{1});
    }

    void aMirroredPartIsMirroredAsBefore() {
        Stored stored;
        const Placement mirror = mirroredAcross(0, glm::dvec3(20.0, 0.0, 0.0));
        QVERIFY(stored.project.setModel(*placed(std::make_shared<const Model>(plateAndClamp()), mirror)).hasValue());
        const auto longer =
            modelOf({bodyOf("plate", {0, 0, 0}, {44, 30, 10}), bodyOf("clamp", {50, 0, 0}, {60, 30, 10})});
        QVERIFY(updatePart(stored.project, longer).hasValue());
        const Box plate = stored.project.model().value().bodies[0].box; // x becomes 40 - x
        QVERIFY(glm::distance(plate.low, glm::dvec3(-4.0, 0.0, 0.0)) < 1e-9);
        QVERIFY(glm::distance(plate.high, glm::dvec3(40.0, 30.0, 10.0)) < 1e-9);
    }

    void rolesThatLeaveNoPartChangeNothing() {
        Stored stored;
        const Setup before = stored.setup();
        const auto clamp =
            modelOf({bodyOf("clamp", {50, 0, 0}, {60, 30, 10}), bodyOf("clamp", {70, 0, 0}, {80, 9, 9})});
        Setup twoClamps = before;
        QVERIFY(
            stored.project
                .setModel(modelOf({bodyOf("clamp", {50, 0, 0}, {60, 30, 10}), bodyOf("plate", {0, 0, 0}, {40, 30, 10}),
                                   bodyOf("clamp", {70, 0, 0}, {80, 9, 9})}))
                .hasValue());
        twoClamps.roles = {BodyRole::fixture, BodyRole::part, BodyRole::fixture};
        twoClamps.bodyMaterials.clear();
        QVERIFY(stored.project.setSetup(twoClamps).hasValue());
        const Result<PartUpdate> update = updatePart(stored.project, clamp);
        QVERIFY(!update.hasValue());
        QCOMPARE(update.error().code, ErrorCode::stockInvalid);
        QCOMPARE(stored.project.model().value().bodies.size(), std::size_t{3});
        QVERIFY(fixture::identical(stored.setup(), twoClamps));
    }
};

BURIN_TEST(TestPartUpdate, NoApplication)

} // namespace burin::tst_part_update

#include "tst_part_update.moc"
