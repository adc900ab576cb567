// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/milled_sample.h"
#include "tests/core/volume/surfaces.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"
#include "tests/ui/offscreen_stage.h"
#include "ui/scene/workpiece_actors.h"

#include <QCoreApplication>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkUnsignedCharArray.h>

#include <QElapsedTimer>
#include <QtTest>

#include <atomic>

namespace burin::tst_workpiece_actors {

using namespace burin::test;

namespace {

using Colour = std::array<int, 3>;
constexpr Colour background{255, 0, 255}; // a colour that nothing in the scene has
constexpr int side = 400;                 // pixels

/// A window without a display that shows the workpiece.
class Stage : public testing::OffscreenStage {
public:
    Stage() : OffscreenStage(side) {
        actors.emplace(*renderer, *films, [this] { calls.fetch_add(1); });
    }

    /// Views from straight above, with the grid filling the picture.
    void lookDown(const Grid& grid) {
        const glm::dvec3 centre = grid.box().centre();
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->ParallelProjectionOn();
        camera->SetFocalPoint(centre.x, centre.y, centre.z);
        camera->SetPosition(centre.x, centre.y, centre.z + 500.0);
        camera->SetViewUp(0.0, 1.0, 0.0);
        camera->SetParallelScale(0.45 * std::min(grid.box().size().x, grid.box().size().y));
        camera->SetClippingRange(1.0, 1000.0);
    }
    void paint(bool moving = false) {
        actors->update(moving, focus);
        window->Render();
    }
    /// Renders until everything is drawn at full detail.
    bool settle() {
        QElapsedTimer timer;
        for (timer.start(); timer.elapsed() < 60'000; QTest::qWait(5)) {
            paint();
            if (actors->fullDetail() && !actors->busy()) return true;
        }
        return false;
    }
    std::vector<Colour> pixels() {
        vtkNew<vtkUnsignedCharArray> bytes;
        window->GetPixelData(0, 0, side - 1, side - 1, 0, bytes.Get(), 0);
        std::vector<Colour> all;
        for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
            all.push_back(
                {bytes->GetTypedComponent(i, 0), bytes->GetTypedComponent(i, 1), bytes->GetTypedComponent(i, 2)});
        return all;
    }
    std::size_t holes() {
        const std::vector<Colour> all = pixels();
        return static_cast<std::size_t>(std::count(all.begin(), all.end(), background));
    }
    Colour middle() { return pixels()[side * side / 2 + side / 2]; }

    vtkNew<vtkRenderer> films;
    std::atomic<int> calls = 0;
    glm::dvec3 focus{0.0};
    std::optional<WorkpieceActors> actors;
};

RunVolume block(glm::ivec3 count, PropertyIndex property = wax) {
    const Grid grid = *Grid::make({-3.0, 5.0, 1.0}, 0.25, count);
    RunVolume volume = RunVolume::make(grid, someProperties()).value();
    (void)volume.fillBlock({0, 0}, {count.x, count.y}, 0, grid.lineEnd(), property);
    return volume;
}

std::size_t differing(const std::vector<Colour>& one, const std::vector<Colour>& other) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            if (std::abs(one[i][channel] - other[i][channel]) > 8) {
                ++count;
                break;
            }
    return count;
}

std::chrono::steady_clock::time_point at(int seconds) {
    return std::chrono::steady_clock::time_point(std::chrono::seconds(seconds));
}

} // namespace

class WorkpieceActorsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { vtkObject::GlobalWarningDisplayOff(); } // two lines about GLEW without X
    void showsTheWorkpiece();
    void hidesAndEmpties();
    void bareProtectedMaterialHasThePartColour();
    void cutsAppearAndAreToldOnce();
    void skippedSnapshotsHandTheirCutOn();
    void showsTheSameAsFromScratch();
    void noHoleBetweenLevels();
    void milledSampleKeepsToItsTriangles();
    void anotherVolumeReplacesTheFirst();
    void endsWhileBusy();
    void letsSnapshotsGo();
};

void WorkpieceActorsTest::showsTheWorkpiece() {
    Stage stage;
    QVERIFY(stage.context);
    RunVolume volume = block({100, 100, 40});
    stage.lookDown(volume.grid());
    stage.paint();
    QCOMPARE(stage.actors->triangles(), std::size_t{0});
    QVERIFY(!stage.actors->fullDetail());
    stage.actors->show(volume.snapshot(), std::nullopt);
    QVERIFY(stage.settle());
    QVERIFY(stage.calls.load() > 0);
    QVERIFY(stage.actors->triangles() > 0 && stage.actors->triangles() < 2000); // flat faces
    QCOMPARE(stage.holes(), std::size_t{0});
    QVERIFY(!stage.actors->takeCutShown());
}

void WorkpieceActorsTest::hidesAndEmpties() {
    Stage stage;
    RunVolume volume = block({60, 60, 20});
    stage.lookDown(volume.grid());
    stage.actors->show(volume.snapshot(), std::nullopt);
    QVERIFY(stage.settle());
    stage.actors->setVisible(false);
    stage.window->Render();
    QCOMPARE(stage.holes(), std::size_t{side * side});
    stage.actors->setVisible(true);
    stage.window->Render();
    QCOMPARE(stage.holes(), std::size_t{0});
    stage.actors->show({}, std::nullopt);
    QTRY_VERIFY(!stage.actors->busy());
    stage.paint();
    QCOMPARE(stage.holes(), std::size_t{side * side});
    QCOMPARE(stage.actors->triangles(), std::size_t{0});
}

void WorkpieceActorsTest::bareProtectedMaterialHasThePartColour() {
    Stage stage;
    RunVolume volume = block({60, 60, 20}, part);
    stage.lookDown(volume.grid());
    stage.actors->show(volume.snapshot(), std::nullopt);
    stage.actors->setPartColour({200, 40, 20});
    QVERIFY(stage.settle());
    const Colour red = stage.middle();
    QVERIFY(red[0] > 3 * red[1] && red[0] > 3 * red[2]);
    stage.actors->setPartColour({20, 200, 40});
    QTRY_VERIFY(!stage.actors->busy());
    QVERIFY(stage.settle());
    const Colour green = stage.middle();
    QVERIFY(green[1] > 3 * green[0] && green[1] > 3 * green[2]);
}

void WorkpieceActorsTest::cutsAppearAndAreToldOnce() {
    Stage stage;
    RunVolume volume = block({100, 100, 40});
    stage.lookDown(volume.grid());
    stage.actors->show(volume.snapshot(), std::nullopt);
    QVERIFY(stage.settle());
    const std::vector<Colour> before = stage.pixels();

    fillSphere(volume, airProperty, volume.grid().box().centre() + glm::dvec3(0.0, 0.0, 5.0), 4.0);
    stage.actors->show(volume.snapshot(), at(7));
    std::optional<std::chrono::steady_clock::time_point> shown;
    for (int i = 0; i < 2000 && !shown; ++i, QTest::qWait(2)) {
        stage.actors->update(true, stage.focus);
        shown = stage.actors->takeCutShown();
    }
    QVERIFY(shown);
    QCOMPARE(shown->time_since_epoch(), at(7).time_since_epoch());
    stage.window->Render();
    QVERIFY(differing(before, stage.pixels()) > side * side / 20); // the bowl is visible when the cut is reported
    QVERIFY(!stage.actors->takeCutShown());
    QVERIFY(stage.settle());
    QVERIFY(!stage.actors->takeCutShown());
}

void WorkpieceActorsTest::skippedSnapshotsHandTheirCutOn() {
    Stage stage;
    RunVolume volume = block({400, 300, 40}); // the first surface takes some time
    stage.actors->show(volume.snapshot(), std::nullopt);
    for (int i = 0; i < 20; ++i) {
        fillSphere(volume, airProperty, volume.grid().box().centre() + glm::dvec3(0.3 * i, 0.0, 5.0), 3.0);
        stage.actors->show(volume.snapshot(), at(100 + i));
    }
    std::vector<long> told;
    QElapsedTimer timer;
    for (timer.start(); timer.elapsed() < 60'000; QTest::qWait(2)) {
        stage.paint(true);
        if (const auto shown = stage.actors->takeCutShown())
            told.push_back(std::chrono::duration_cast<std::chrono::seconds>(shown->time_since_epoch()).count());
        if (!stage.actors->busy()) break;
    }
    QVERIFY(!told.empty());
    QCOMPARE(told.front(), 100L); // the oldest, although its snapshot was hardly meshed
    QVERIFY(std::is_sorted(told.begin(), told.end()));
}

void WorkpieceActorsTest::showsTheSameAsFromScratch() {
    RunVolume volume = block({200, 160, 40});
    std::vector<Colour> stepByStep;
    {
        Stage stage;
        stage.lookDown(volume.grid());
        for (int i = 0; i < 30; ++i) {
            fillSphere(volume, airProperty, volume.grid().low() + glm::dvec3(4.0 + 1.3 * i, 3.0 + i, 11.0), 3.0);
            stage.focus = volume.grid().low() + glm::dvec3(4.0 + 1.3 * i, 3.0 + i, 11.0);
            stage.actors->show(volume.snapshot(), at(i));
            stage.paint(i % 3 != 0);
            QTest::qWait(i % 7 == 0 ? 150 : 5);
        }
        QVERIFY(stage.settle());
        stepByStep = stage.pixels();
    }
    Stage fresh;
    fresh.lookDown(volume.grid());
    fresh.actors->show(volume.snapshot(), std::nullopt);
    QVERIFY(fresh.settle());
    QVERIFY(differing(stepByStep, fresh.pixels()) < side * side / 500);
}

void WorkpieceActorsTest::noHoleBetweenLevels() {
    Stage stage;
    MilledSample sample(0.5);
    stage.lookDown(sample.workpiece.grid());
    stage.focus = {30.0, 20.0, 20.0};
    stage.actors->show(sample.workpiece.snapshot(), std::nullopt);
    QVERIFY(stage.settle());
    QCOMPARE(stage.holes(), std::size_t{0});
    for (double x = 10.0; x < 110.0; x += 9.0) { // settled groups next to groups that are just changing
        sample.pass(40.0, x, x + 9.0);
        stage.focus = {x, 40.0, 20.0};
        stage.actors->show(sample.workpiece.snapshot(), at(1));
        for (int i = 0; i < 3; ++i) {
            QTest::qWait(10);
            stage.paint(true);
            QCOMPARE(stage.holes(), std::size_t{0});
        }
    }
}

void WorkpieceActorsTest::milledSampleKeepsToItsTriangles() {
    Stage stage;
    MilledSample sample(0.25); // 480 × 280 × 180 voxels
    stage.lookDown(sample.workpiece.grid());
    stage.actors->show(sample.workpiece.snapshot(), std::nullopt);
    QElapsedTimer timer;
    timer.start();
    QVERIFY(stage.settle());
    qInfo("full detail after %lld ms: %zu triangles", timer.elapsed(), stage.actors->triangles());
    QVERIFY(stage.actors->triangles() <= 200'000);
    stage.paint(true);
    qInfo("while the view moves: %zu", stage.actors->triangles());
    QVERIFY(stage.actors->triangles() <= WorkpieceActors::movingTriangles);
    std::size_t most = 0;
    for (double x = 10.0; x < 110.0; x += 1.0) {
        sample.pass(40.0, x, x + 1.0);
        stage.focus = {x, 40.0, 20.0};
        stage.actors->show(sample.workpiece.snapshot(), std::chrono::steady_clock::now());
        stage.paint(true);
        most = std::max(most, stage.actors->triangles());
    }
    qInfo("while milling: at most %zu", most);
    QVERIFY(most <= WorkpieceActors::movingTriangles);
    timer.restart();
    QVERIFY(stage.settle());
    qInfo("full detail again after %lld ms", timer.elapsed());
}

void WorkpieceActorsTest::anotherVolumeReplacesTheFirst() {
    Stage stage;
    RunVolume large = block({200, 200, 40}), small = block({40, 40, 20});
    stage.lookDown(large.grid());
    stage.actors->show(large.snapshot(), std::nullopt);
    QVERIFY(stage.settle());
    QCOMPARE(stage.holes(), std::size_t{0});
    stage.actors->show(small.snapshot(), std::nullopt);
    QTRY_VERIFY(!stage.actors->busy());
    QVERIFY(stage.settle());
    QVERIFY(stage.holes() > side * side / 2);
}

void WorkpieceActorsTest::endsWhileBusy() {
    for (int i = 0; i < 5; ++i) {
        Stage stage;
        RunVolume volume = block({300, 300, 60});
        stage.actors->show(volume.snapshot(), at(1));
        QTest::qWait(10 * i);
        stage.paint(i % 2 == 0);
    }
}

void WorkpieceActorsTest::letsSnapshotsGo() {
    RunVolume volume = block({200, 160, 40}), untouched = block({200, 160, 40});
    {
        Stage stage;
        for (int i = 0; i < 10; ++i) {
            for (RunVolume* one : {&volume, &untouched})
                fillSphere(*one, airProperty, volume.grid().low() + glm::dvec3(4.0 + i, 3.0 + i, 11.0), 3.0);
            stage.actors->show(volume.snapshot(), std::nullopt);
            QTest::qWait(10);
        }
        QVERIFY(stage.settle());
    }
    for (RunVolume* one : {&volume, &untouched}) (void)one->snapshot(); // reclaims what readers released
    QCOMPARE(volume.usedBytes(), untouched.usedBytes());
}

BURIN_TEST(WorkpieceActorsTest, QCoreApplication)

} // namespace burin::tst_workpiece_actors

#include "tst_workpiece_actors.moc"
