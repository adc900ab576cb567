// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/kept_program.h"
#include "core/machine/machine_profile.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <functional>

namespace burin::tst_kept_program {

namespace {

constexpr const char* text = "%\nG21 G90 G54\nT1 M6\nS8000 M3\nG0 X0 Y0 Z10\nG1 Z5 F200\nG0 Z10\nM2\n%\n";

/// A program as a check leaves it, with a finding of each kind that the report may contain.
CheckedProgram checked(const Tool& tool) {
    CheckedProgram program;
    program.text = text;
    program.dialect = "linuxcnc";
    program.tools = {tool};
    program.gougeTolerance = 0.025;
    program.report.gougeMax = 0.1 + 0.2;
    program.report.removed = 1234.5678901234567;
    program.report.findings = {{FindingKind::shankCollision, 5, {1.5, -2.25, 3.125}, 0.1}};
    program.report.nearPasses = {{ToolSection::shank, NearTo::obstacle, 6, {0.1, 0.2, 0.3}, 0.7, 41}};
    return program;
}

struct Change {
    const char* name;
    std::function<Result<void>(Project&)> make;
};

} // namespace

/// A verdict kept in a project is valid as long as everything that was judged is unchanged.
class TestKeptProgram : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        const auto file = std::filesystem::path(folder_->filePath("kept.burin").toStdString());
        QVERIFY(fixture::fillProject(file));
        Result<Project> project = Project::open(file);
        QVERIFY(project);
        project_.emplace(std::move(*project));
        QVERIFY(keepVerdict(*project_, checked(fixture::tool()), "linuxcnc-mill", NcUnits::millimetre));
    }

    void whatTheCheckFoundComesBack() {
        const auto reopened = reopenProgram(*project_);
        QVERIFY(reopened && *reopened);
        const CheckedProgram& program = *(**reopened).program;
        QVERIFY((**reopened).upToDate);
        QCOMPARE(program.text, std::string(text));
        QCOMPARE(program.gougeTolerance, 0.025);
        QCOMPARE(program.report.gougeMax, 0.1 + 0.2); // bitwise equal
        QCOMPARE(program.report.removed, 1234.5678901234567);
        QCOMPARE(program.report.findings.size(), std::size_t{1});
        QVERIFY(program.report.findings[0].kind == FindingKind::shankCollision);
        QVERIFY(program.report.findings[0].place == glm::dvec3(1.5, -2.25, 3.125));
        QCOMPARE(program.report.nearPasses.size(), std::size_t{1});
        QVERIFY(program.report.nearPasses[0].to == NearTo::obstacle);
        QVERIFY(program.report.nearPasses[0].section == ToolSection::shank);
        QCOMPARE(program.report.nearPasses[0].lines, 41U);
        QVERIFY(!program.parsed.motions.empty());
        QVERIFY(!program.passed());
    }

    void aProjectWithoutOneHasNone() {
        QVERIFY(project_->setKeptProgram({}));
        QVERIFY(!reopenProgram(*project_).value());
        QVERIFY(project_->setKeptProgram("{\"text\": 3}")); // from a Burin that writes another form
        QVERIFY(!reopenProgram(*project_).value());
    }

    void whateverWasJudgedMakesItOutOfDateWhenItChanges() {
        const std::vector<Change> changes{
            {"part", [](Project& p) { return p.setModel(fixture::modelNamed("another")); }},
            {"stock",
             [](Project& p) {
                 Setup setup = fixture::setup();
                 setup.stock.high.z += 0.001;
                 return p.setSetup(setup);
             }},
            {"material",
             [](Project& p) {
                 std::vector<Property> materials = fixture::materials();
                 materials.front().name += "x";
                 return p.setMaterials(materials);
             }},
            {"fixture",
             [](Project& p) {
                 std::vector<Obstacle> obstacles = fixture::obstacles();
                 obstacles.front().on = !obstacles.front().on;
                 return p.setObstacles(obstacles);
             }},
            {"travel",
             [](Project& p) {
                 TravelPlacement travel = fixture::travelPlacement();
                 travel.on = !travel.on;
                 return p.setTravelPlacement(travel);
             }},
            {"tool",
             [](Project& p) {
                 Tool tool = fixture::tool();
                 tool.cutter.stickOut += 0.5;
                 return p.setTool(tool);
             }},
            {"path",
             [](Project& p) {
                 StoredPath path = p.paths()->front();
                 path.edits.front().enabled = !path.edits.front().enabled;
                 return p.setPath(path);
             }},
            {"stroke taken back",
             [](Project& p) {
                 return p.undoInterval(p.takes()->front().id, SampleRange{200, 10});
             }},
        };
        for (const Change& change : changes) {
            init();
            QVERIFY2((**reopenProgram(*project_)).upToDate, change.name);
            QVERIFY2(change.make(*project_), change.name);
            const auto reopened = reopenProgram(*project_);
            QVERIFY2(reopened && *reopened && !(**reopened).upToDate, change.name);
        }
    }

    void textAndReportAreUnderTheChecksum() {
        for (const auto& [before, after] : {std::pair{"G1 Z5", "G1 Z4"}, std::pair{"0.025", "0.125"}}) {
            init();
            std::string json = *project_->keptProgram();
            const std::size_t at = json.find(before);
            QVERIFY(at != std::string::npos);
            QVERIFY(project_->setKeptProgram(json.replace(at, std::string(before).size(), after)));
            const auto reopened = reopenProgram(*project_);
            QVERIFY2(reopened && *reopened && !(**reopened).upToDate, before);
        }
    }

    /// The view direction, haptic guides, and a tool that milled nothing.
    void whatNobodyJudgedMayChange() {
        Tool other = fixture::tool();
        other.id = "another";
        QVERIFY(project_->setLeftAt("{}") && project_->setGuides({}) && project_->setTool(other));
        QVERIFY((**reopenProgram(*project_)).upToDate);
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
    std::optional<Project> project_;
};

BURIN_TEST(TestKeptProgram, QCoreApplication)

} // namespace burin::tst_kept_program

#include "tst_kept_program.moc"
