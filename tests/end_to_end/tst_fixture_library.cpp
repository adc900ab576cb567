// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "core/document/project.h"
#include "core/setup/fixture_library.h"
#include "core/setup/fixture_placement.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_fixture_library {

namespace {

std::vector<Obstacle> fixturesIn(const QString& project) {
    const Result<Project> opened = Project::openForReading(project.toStdString());
    if (!opened) return {};
    return opened->obstacles().value();
}

} // namespace

/// Fixtures of the library by the command line. The stock is a cube of 10 mm with 5 mm on all sides.
class FixtureLibraryTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", project_, "--voxel", "1", "--margin", "5",
                           "--material", "machinable-wax"})
                     .status,
                 0);
    }
    void cleanup() { QFile::remove(project_); }

    void theLibraryIsListed() {
        const QJsonArray kinds = runBurin({"fixtures", "--json"}).json()["fixtures"].toArray();
        QCOMPARE(static_cast<std::size_t>(kinds.size()), fixtureKinds.size());
        QCOMPARE(kinds[0].toObject()["kind"].toString(), QString("vise"));
        QCOMPARE(kinds[0].toObject()["parameters"].toArray()[2].toObject()["default_mm"].toDouble(), 125.0);
        const QByteArray text = runBurin({"fixtures"}).output;
        QVERIFY2(text.contains("ISO 4762, M8") && text.contains("estimate"), text.constData());
    }

    /// The command places a fixture as a click at the same point does in the window.
    void aFixtureIsPlacedAsByAClick() {
        const ProgramRun run =
            runBurin({"setup", project_, "--add-fixture", "step-clamp at=13,5,15 width=30", "--add-fixture",
                      "toe-clamp at=5,-9", "--add-fixture", "vise", "--clearance", "0.5", "--json"});
        QVERIFY2(run.status == 0, run.messages.constData());
        const std::vector<Obstacle> fixtures = fixturesIn(project_);
        QCOMPARE(fixtures.size(), std::size_t{3});
        const Box stock{{-5.0, -5.0, -5.0}, {15.0, 15.0, 15.0}};
        FixtureDesign clamp = standardFixture(FixtureKind::stepClamp);
        setValue(clamp, "width", 30.0);
        QVERIFY(fixtures[0].design == placedAt(clamp, {"width"}, siteOf(stock, {}), {13.0, 5.0, 15.0}));
        QVERIFY(fixtures[1].design ==
                placedAt(standardFixture(FixtureKind::toeClamp), {}, siteOf(stock, {}), {5.0, -9.0, 0.0}));
        QCOMPARE(fixtures[2].name, std::string("Vise"));
        QCOMPARE(valueOf(*fixtures[2].design, "opening"), 20.0);
        QCOMPARE(fixtures[2].margin, 0.5);
        const QJsonObject told = run.json()["obstacles"].toArray()[0].toObject()["library"].toObject();
        QCOMPARE(told["kind"].toString(), QString("step-clamp"));
        QCOMPARE(told["values_mm"].toObject()["height"].toDouble(), 20.0);
    }

    /// Of a round bar the bar itself counts, not the box around it: 30 mm in diameter, standing about the cube.
    void theFormOfTheStockCounts() {
        const QString bar = folder_.filePath("bar.burin");
        const ProgramRun embedded =
            runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", bar, "--voxel", "1", "--stock-cylinder",
                      "5,5,-5,0,0,1,15,20", "--material", "machinable-wax"});
        QVERIFY2(embedded.status == 0, embedded.messages.constData());
        const ProgramRun run = runBurin({"setup", bar, "--add-fixture", "vise at=20,5", "--add-fixture",
                                         "socket-screw at=19,19,15 washer=9 head=6 diameter=4"});
        QVERIFY2(run.status == 0, run.messages.constData()); // the corner of the box is free
        const std::vector<Obstacle> fixtures = fixturesIn(bar);
        QCOMPARE(fixtures.size(), std::size_t{2});
        QVERIFY(std::abs(valueOf(*fixtures[0].design, "opening") - 30.0) < 1e-6);
        QCOMPARE(fixtures[1].design->place, glm::dvec3(19.0, 19.0, -5.0)); // beside the bar, on the table
        const ProgramRun refused = runBurin({"setup", bar, "--add-fixture", "vise at=20,5 opening=28"});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.messages.contains("1.000 mm deep in the stock"), refused.messages.constData());
    }

    void aFixtureIsChanged() {
        QCOMPARE(runBurin({"setup", project_, "--add-fixture", "vise", "--add-fixture", "vise at=-5,5"}).status, 0);
        const ProgramRun run = runBurin({"setup", project_, "--change-fixture", "Vise 2: jaw-width=60 grip=4",
                                         "--change-fixture", "Vise: turn=90"});
        QVERIFY2(run.status == 0, run.messages.constData());
        const std::vector<Obstacle> fixtures = fixturesIn(project_);
        QCOMPARE(valueOf(*fixtures[1].design, "jaw-width"), 60.0);
        QCOMPARE(valueOf(*fixtures[1].design, "grip"), 4.0);
        QVERIFY(std::abs(fixtures[0].design->turn - 1.5707963267948966) < 1e-12);
        QCOMPARE(boundsOf(fixtures[1]).size().y, 125.0); // the body is as wide as before
    }

    /// A box, and a fixture from a file, are moved and turned; what then is in the stock is told.
    void anyOtherFixtureIsMoved() {
        const ProgramRun added =
            runBurin({"setup", project_, "--fixture", BURIN_FIXTURES "/models/cube.brep", "--keep-out", "20,0,0,30,4,6",
                      "--change-fixture", "cube: place=16,-5,-5 turn=45", "--change-fixture",
                      "keep-out: by=1,2,3 turn=90", "--json"});
        QVERIFY2(added.status == 0, added.messages.constData());
        const std::vector<Obstacle> fixtures = fixturesIn(project_);
        const Box cube = boundsOf(fixtures[0]), space = boundsOf(fixtures[1]);
        const double half = 5.0 * std::sqrt(2.0); // of the diagonal of the cube of 10 mm
        QVERIFY(glm::distance(cube.low, {21.0 - half, -half, -5.0}) < 1e-9);
        QVERIFY(glm::distance(cube.high, {21.0 + half, half, 5.0}) < 1e-9);
        QCOMPARE(space.low, glm::dvec3(24.0, -1.0, 3.0));
        QCOMPARE(space.high, glm::dvec3(28.0, 9.0, 9.0));
        const ProgramRun refused = runBurin({"setup", project_, "--change-fixture", "keep-out: turn=30"});
        QCOMPARE(refused.status, 2);
        QVERIFY2(refused.messages.contains("a multiple of 90 degrees"), refused.messages.constData());
        const ProgramRun unknown = runBurin({"setup", project_, "--change-fixture", "cube: jaw-width=3"});
        QVERIFY2(unknown.status == 2 && unknown.messages.contains("by, place, turn"), unknown.messages.constData());
    }

    /// A vise that doesn't touch the stock: told by setup, verify and the sheet, in both forms of output.
    void whatDoesNotTouchTheStockIsTold() {
        const QStringList add{"setup", project_, "--add-fixture", "vise opening=23"};
        const ProgramRun text = runBurin(add);
        QVERIFY2(text.status == 0, text.messages.constData());
        const char* const sentence = "doesn't touch the stock: a gap of 3.000";
        QVERIFY2(text.output.contains(sentence), text.output.constData());
        const QJsonArray told = runBurin({"setup", project_, "--json"}).json()["fixture_warnings"].toArray();
        QCOMPARE(told.size(), 1);
        QCOMPARE(told[0].toObject()["name"].toString(), QString("Vise"));
        QCOMPARE(told[0].toObject()["gap_mm"].toDouble(), 3.0);
        QCOMPARE(told[0].toObject()["in_stock_mm"].toDouble(), 0.0);
        const QJsonArray none = runBurin({"setup", project_, "--change-fixture", "Vise: opening=20", "--json"})
                                    .json()["fixture_warnings"]
                                    .toArray();
        QVERIFY(none.isEmpty());
    }

    void whatCanNotBeIsRefusedInOneSentence() {
        const std::tuple<const char*, int, const char*> cases[] = {{"magnet", 2, "vise, step-clamp"},
                                                                   {"vise wide=3", 2, "jaw-width"},
                                                                   {"vise grip=long", 2, "SIZE=MM"},
                                                                   {"vise at=3", 2, "at=X,Y"},
                                                                   {"vise opening=19", 2, " mm deep in the stock"},
                                                                   {"vise jaw-height=2", 2, "or more"}};
        for (const auto& [text, status, words] : cases) {
            const ProgramRun run = runBurin({"setup", project_, "--add-fixture", text});
            QCOMPARE(run.status, status);
            QVERIFY2(run.messages.contains(words) && run.messages.count('\n') == 1, run.messages.constData());
        }
        QVERIFY(fixturesIn(project_).empty());
        QCOMPARE(runBurin({"setup", project_, "--change-fixture", "Vise: grip=4"}).status, 2);
    }

    /// A tool that goes over the side of the stock meets the jaw that stands higher than the stock.
    void theCheckFindsAToolInTheJaw() {
        QFile program(folder_.filePath("over.ngc"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        // Program zero is the middle of the stock's top: 1 mm into the stock, then 6 mm beyond its front side.
        program.write("G21 G90 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 X0 Y0 Z30\nG0 Y-16 Z30\nG1 Z-1 F300\nG1 Y0 F300\n"
                      "G0 Z30\nM2\n");
        program.close();
        const auto collides = [&] {
            const ProgramRun run =
                runBurin({"verify", program.fileName(), "--project", project_, "--tool", "ball-6", "--json"});
            for (const auto& finding : run.json()["findings"].toArray())
                if (finding.toObject()["kind"].toString() == "obstacle_collision") return true;
            return false;
        };
        QVERIFY(!collides());
        QCOMPARE(runBurin({"setup", project_, "--add-fixture", "vise at=5,-5 grip=10"}).status, 0);
        QVERIFY(!collides()); // the jaws end 10 mm below the top
        QCOMPARE(runBurin({"setup", project_, "--change-fixture", "Vise: grip=21"}).status, 0);
        QVERIFY(collides());
    }

private:
    QTemporaryDir folder_;
    QString project_ = folder_.filePath("cube.burin");
};

BURIN_TEST(FixtureLibraryTest, QCoreApplication)

} // namespace burin::tst_fixture_library

#include "tst_fixture_library.moc"
