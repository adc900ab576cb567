// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/job_paths.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace burin::tst_own_materials {

using namespace burin::test;

namespace {

/// Wax with a multiple of the specific energy, under a name that the library does not know.
Property ownWax(double factor) {
    Property wax = loadMaterial("machinable-wax").value();
    wax.id = "wax-of-our-own";
    wax.name = "Wax of our own";
    wax.values.at(std::string(specificCuttingEnergy)).value *= factor;
    return wax;
}

/// A rig from a project file that contains such a wax.
Result<MillingContext> millingWith(const Property& material, Project& project) {
    Model model;
    Body body;
    body.name = "block";
    body.box = {{6.0, 6.0, 1.0}, {14.0, 14.0, 8.0}};
    body.mesh = shapes::box(body.box.low, body.box.high);
    body.volume = 8.0 * 8.0 * 7.0;
    model.bodies = {body};
    Setup setup = blockSetup();
    setup.stockMaterial = material.id;
    for (const Result<void>& done :
         {project.setModel(model), project.setSetup(setup), project.setMaterials({material})})
        if (!done) return done.error();
    Progress progress;
    return makeMillingContext(project, sessionTool(), "linuxcnc-mill", progress);
}

/// A groove next to the part with feeds by force, evaluated, posted and checked.
struct Job {
    EvaluatedPath path;
    CheckedProgram program;
};
Result<Job> milled(const MillingContext& milling) {
    FeedOptimisation level;
    level.target = 1.5; // N
    PathMatter matter;
    matter.path.edits = {{Simplify{}}, {Link{}}, {SetFeed{}}, {level}};
    matter.tool = milling.tool;
    matter.sources = {*recordedStrokes(takeOf(along({{2.0, 3.0, 8.5}, {18.0, 3.0, 8.5}}, 50.0)))};
    Progress progress;
    const Result<EvaluatedPaths> paths = evaluateInOrder(milling, {matter}, progress);
    if (!paths) return paths.error();
    Result<EvaluatedPath> path = evaluateStored(matter.sources, milling, milling.tool, matter.path, {}, progress);
    if (!path) return path.error();
    ProgramRequest request;
    request.name = "groove.ngc";
    request.exactSamples = 0;
    Result<CheckedProgram> program = makeProgram(milling, paths->program, request, progress);
    if (!program) return program.error();
    return Job{std::move(*path), std::move(*program)};
}

/// The feed in the middle of the groove, mm/min.
double feedOf(const Path& path) {
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].kind == MoveKind::cut && path.points[i - 1].pose.tip.x <= 10.0 &&
            path.points[i].pose.tip.x > 10.0)
            return path.points[i].feed;
    return 0.0;
}

double energyOf(const VerifyReport& report) {
    double energy = 0.0;
    for (const MotionLoad& load : report.loads) energy += load.power * load.duration;
    return energy;
}

} // namespace

/// A project's materials stay as they were when it was made, whatever the library contains.
class TestOwnMaterials : public QObject {
    Q_OBJECT
private slots:
    void theProjectsOwnMaterialIsCutEverywhere();
};

void TestOwnMaterials::theProjectsOwnMaterialIsCutEverywhere() {
    QTemporaryDir folder;
    std::vector<Job> jobs;
    for (const double factor : {1.0, 2.0}) {
        Result<Project> project = Project::create(folder.filePath(QString("%1.burin").arg(factor)).toStdString());
        QVERIFY(project);
        const Result<MillingContext> milling = millingWith(ownWax(factor), *project);
        QVERIFY2(milling, milling ? "" : milling.error().place.c_str());
        const PropertyList& list = milling->embedded.workpiece.properties();
        QCOMPARE(list[milling->embedded.stockProperty].name, std::string("Wax of our own"));
        Result<Job> job = milled(*milling);
        QVERIFY2(job, job ? "" : job.error().place.c_str());
        QVERIFY(!job->program.machined.empty());
        QCOMPARE(job->program.machined.properties()[1].id, std::string("wax-of-our-own"));
        jobs.push_back(std::move(*job));
    }
    // Twice the energy: half the feed for the same force, and twice the work for the same groove.
    const double soft = feedOf(jobs[0].path.path), hard = feedOf(jobs[1].path.path);
    QVERIFY2(hard > 0.0 && std::abs(soft / hard - 2.0) < 0.05, qPrintable(QString("%1 %2").arg(soft).arg(hard)));
    const double easy = energyOf(jobs[0].program.report), dear = energyOf(jobs[1].program.report);
    QVERIFY2(easy > 0.0 && std::abs(dear / easy - 2.0) < 0.02, qPrintable(QString("%1 %2").arg(easy).arg(dear)));
}

BURIN_TEST(TestOwnMaterials, QCoreApplication)

} // namespace burin::tst_own_materials

#include "tst_own_materials.moc"
