// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "part_judge.h"

#include "core/document/project.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace burin::tst_window_job {

using burin::testing::chooseFile;
using burin::testing::WindowDriver;

namespace {

constexpr const char* sample = BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step";

/// The middle sample of each interval that was recorded with the spindle turning.
std::vector<std::size_t> middlesOfStrokes(const Take& take) {
    std::vector<std::size_t> middles;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= take.samples.size(); ++i) {
        const bool turning = i < take.samples.size() && (take.samples[i].flags & sampleSpindleOff) == 0;
        if (turning) continue;
        if (i > first) middles.push_back((first + i) / 2);
        first = i + 1;
    }
    return middles;
}

} // namespace

/// The whole job in the window by mouse and keyboard, judged from outside: LinuxCNC's interpreter determines the moves
/// of the program, the fine mesh and OpenCASCADE their effect on the part.
class WindowJobTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void importsAPart();
    void embedsIt();
    void millsAlongThePart();
    void takesAStrokeBack();
    void editsThePath();
    void isSavedAndOpenedAgain();
    void postsAProgram();
    void theHandNeverEnteredThePart();
    void theProgramLiesOnThePart();
    void whatWasTakenBackIsNotMilled();

private:
    Workbench& workbench() { return driver_->window().workbench(); }
    void stroke(const glm::dvec3& from, const glm::dvec3& to, const QString& picture = {});

    QTemporaryDir folder_;
    std::unique_ptr<WindowDriver> driver_;
    std::optional<PartJudge> judge_;
    std::optional<Take> take_;
    QString project_, program_;
    glm::dvec3 workOffset_{0.0};
    double voxel_ = 0.0;
};

void WindowJobTest::initTestCase() {
    judge_ = PartJudge::of(sample, 3.0);
    QVERIFY(judge_);
    driver_ = std::make_unique<WindowDriver>();
    project_ = folder_.filePath("job.burin");
    program_ = folder_.filePath("job.ngc");
}

void WindowJobTest::importsAPart() {
    chooseFile(*driver_, sample);
    driver_->key(Qt::Key_I, Qt::ControlModifier);
    QVERIFY(driver_->waitFor([&] { return workbench().model.model() != nullptr; }, 60000));
    QCOMPARE(workbench().model.model()->bodies.size(), std::size_t{1});
    driver_->shoot("job-1-part");
}

void WindowJobTest::embedsIt() {
    QVERIFY(driver_->step(JobStep::stock));
    QVERIFY(driver_->clickOn("embedButton"));
    QVERIFY(driver_->waitFor([&] { return workbench().workpiece.ready(); }, 60000));
    QVERIFY(driver_->settle());
    workOffset_ = workbench().setup.setup().workOffset;
    voxel_ = workbench().setup.setup().voxel;
    QVERIFY(driver_->step(JobStep::tool));
    driver_->shoot("job-2-tool");
}

/// Drags the left button from one point to another, mm, setup frame, at the speed of a hand. @param picture  taken
/// halfway
void WindowJobTest::stroke(const glm::dvec3& from, const glm::dvec3& to, const QString& picture) {
    Viewport& viewport = driver_->window().viewport();
    const auto at = [&](const glm::dvec3& place) { return viewport.project(place).toPoint(); };
    QTest::mouseMove(&viewport, at(from));
    QTest::qWait(400); // for the tool to arrive
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, at(from));
    constexpr int steps = 80;
    for (int i = 0; i <= steps; ++i) {
        QTest::mouseMove(&viewport, at(glm::mix(from, to, static_cast<double>(i) / steps)));
        QTest::qWait(20);
        if (i == steps / 2 && !picture.isEmpty()) driver_->shoot(picture);
    }
    QTest::qWait(500); // for the tool to follow
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, at(to));
    QTest::qWait(300);
}

void WindowJobTest::millsAlongThePart() {
    QVERIFY(driver_->step(JobStep::mill));
    QVERIFY(driver_->clickOn("alongPartButton"));
    QVERIFY(driver_->clickOn("millButton"));
    QVERIFY(driver_->waitFor([&] { return workbench().mill.active(); }, 5000));
    const Box box = judge_->model().box();
    const glm::dvec3 centre = box.centre();
    const double height = box.high.z - 4.0;
    std::size_t strokes = 0;
    for (const double y : {-12.0, -6.0, 0.0, 6.0}) {
        // Farther out the part is deeper than the flutes reach, and the shank rubs on the slot that they cut.
        stroke({centre.x - 14.0, centre.y + y, height}, {centre.x + 14.0, centre.y + y, height},
               strokes == 2 ? QStringLiteral("job-3-mill") : QString());
        ++strokes;
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.strokes().count() == strokes; }, 3000));
    }
    const SessionState state = workbench().session.state();
    qInfo("haptic loop: %.0f Hz, p99.9 %.0f us of CPU time a tick, %llu edges missed", state.rateHz, state.cpuP999,
          static_cast<unsigned long long>(state.missed));
}

void WindowJobTest::takesAStrokeBack() {
    driver_->key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(driver_->waitFor([&] { return workbench().workpiece.strokes().count() == 3; }, 3000));
    QTest::qWait(1000); // full detail
    driver_->shoot("job-4-undone");
    driver_->key(Qt::Key_Escape);
    QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }, 5000));
    QCOMPARE(workbench().mill.takes().size(), std::size_t{1});
}

void WindowJobTest::editsThePath() {
    QVERIFY(driver_->step(JobStep::path));
    QVERIFY(driver_->clickOn("newPathButton"));
    QVERIFY(driver_->waitFor([&] { return workbench().path.evaluated() != nullptr; }, 60000));
    const std::size_t before = workbench().path.evaluated()->path.points.size();
    QVERIFY(driver_->enter("edit4_tolerance_mm", "0.002")); // of the simplification
    QVERIFY(driver_->waitFor(
        [&] {
            const auto evaluated = workbench().path.evaluated();
            return evaluated != nullptr && evaluated->path.points.size() > before;
        },
        60000));
    // The removal of back-steps when the path is linked has its own tolerance and counts in the error budget.
    const auto evaluated = workbench().path.evaluated();
    const auto link = std::ranges::find(evaluated->reports, "link", &EditReport::edit);
    QVERIFY(link != evaluated->reports.end() && link->largestDeviation <= 0.06);
    QVERIFY(evaluated->errorBudget - link->largestDeviation < 0.06);
    driver_->shoot("job-5-path");
}

void WindowJobTest::isSavedAndOpenedAgain() {
    const std::size_t points = workbench().path.evaluated()->path.points.size();
    QVERIFY(burin::testing::saveAs(*driver_, project_));
    QVERIFY(driver_->restart());
    chooseFile(*driver_, project_);
    driver_->key(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(driver_->waitFor([&] { return workbench().workpiece.ready(); }, 60000));
    QVERIFY(driver_->waitFor([&] { return workbench().path.evaluated() != nullptr; }, 60000));
    QCOMPARE(workbench().path.evaluated()->path.points.size(), points);
    QVERIFY(driver_->settle());
    driver_->shoot("job-6-opened");
}

void WindowJobTest::postsAProgram() {
    QVERIFY(driver_->step(JobStep::program));
    QVERIFY(driver_->clickOn("postButton"));
    QVERIFY(driver_->waitFor([&] { return workbench().program.program() != nullptr; }, 120000));
    driver_->shoot("job-7-program");
    QVERIFY(workbench().program.exportable());
    chooseFile(*driver_, program_);
    QVERIFY(driver_->clickOn("exportButton"));
    QVERIFY(driver_->waitFor([&] { return QFile::exists(program_); }, 10000));
    driver_->key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(driver_->waitFor([&] { return !workbench().document.unsaved(); }, 10000));
    QVERIFY(driver_->endQuietly());
}

void WindowJobTest::theHandNeverEnteredThePart() {
    driver_.reset();
    const Result<Project> project = Project::open(project_.toStdString());
    QVERIFY(project);
    const auto takes = project->takes();
    QVERIFY(takes && takes->size() == 1);
    Result<Take> take = project->take(takes->front().id);
    QVERIFY(take);
    take_ = std::move(*take);
    QVERIFY(take_->samples.size() > 8000); // four strokes of more than two seconds
    const double deepest = judge_->deepestProxy(*take_, loadTool(take_->info.toolId).value());
    qInfo("the proxy's deepest place: %.4f mm in the part", deepest);
    QVERIFY2(deepest <= 0.05 * voxel_, qPrintable(QString("%1 mm").arg(deepest)));
    double press = 0.0;
    for (const Sample& tick : take_->samples)
        if ((tick.flags & sampleOnBoundary) != 0) press = std::max(press, glm::length(tick.stylusTip - tick.proxy.tip));
    QVERIFY(press > 1.5); // it was the push-back that protected the part
}

void WindowJobTest::theProgramLiesOnThePart() {
    QTemporaryDir home;
    const int number = loadTool("ball-6").value().number;
    const auto moves = canonicalMoves(program_, home.path(), number, 6.0);
    QVERIFY2(moves.has_value(), "rs274 refused the program");
    const std::vector<ToolSample> samples = judge_->along(*moves, workOffset_);
    const std::optional<double> gouge = judge_->exactGouge(samples, 500);
    QVERIFY(gouge);
    qInfo("gouge of the program: %.4f mm on the exact part", *gouge);
    QVERIFY2(*gouge <= 0.02, qPrintable(QString("gouge %1 mm").arg(*gouge)));

    // From where the tool first touches the part, after its ramp or helix, until it is retracted. Feeds are no
    // criterion: they follow the load, and few positions may have the highest one.
    std::size_t cutting = 0, onPart = 0;
    bool down = false;
    for (const ToolSample& place : samples) {
        down = !place.rapid && (down || place.clearance <= 0.1);
        if (!down) continue;
        ++cutting;
        if (place.clearance <= 0.1) ++onPart;
    }
    QVERIFY2(cutting > 3 * 500, qPrintable(QString("%1 places").arg(cutting)));
    QVERIFY2(onPart > cutting * 9 / 10, qPrintable(QString("%1 of %2").arg(onPart).arg(cutting)));
}

/// Every stroke that was kept is milled where it was recorded; the one that was undone is in no block.
void WindowJobTest::whatWasTakenBackIsNotMilled() {
    QTemporaryDir home;
    const auto moves = canonicalMoves(program_, home.path(), loadTool("ball-6").value().number, 6.0);
    QVERIFY(moves);
    const std::vector<ToolSample> samples = judge_->along(*moves, workOffset_);
    const auto distance = [&](const glm::dvec3& tip) {
        double nearest = 1e9;
        for (const ToolSample& place : samples)
            if (!place.rapid) nearest = std::min(nearest, glm::distance(place.tip, tip));
        return nearest;
    };
    const std::vector<std::size_t> middles = middlesOfStrokes(*take_);
    QCOMPARE(middles.size(), std::size_t{4});
    for (std::size_t i = 0; i < 3; ++i) QVERIFY(distance(take_->samples[middles[i]].proxy.tip) < 0.1);
    QVERIFY(distance(take_->samples[middles[3]].proxy.tip) > 1.0);
}

BURIN_TEST(WindowJobTest, QApplication)

} // namespace burin::tst_window_job

#include "tst_window_job.moc"
