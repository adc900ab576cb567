// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_steps.h"

#include "tests/core/geometry/shapes.h"
#include "tests/stl_text.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QtTest>

namespace burin::testing {

void drop(MainWindow& window, const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent dropped(QPointF(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &dropped);
}

QString writeBlock(const WindowDriver& driver, bool closed) {
    TriangleMesh block = shapes::box(glm::dvec3(0.0), {40.0, 30.0, 20.0});
    if (!closed) block.triangles.resize(block.triangles.size() - 2);
    QFile file(driver.folder().filePath("block.stl"));
    if (file.open(QIODevice::WriteOnly)) file.write(stlText(block, "block"));
    return file.fileName();
}

bool makeReady(WindowDriver& driver, double voxel) {
    Workbench& workbench = driver.window().workbench();
    drop(driver.window(), writeBlock(driver));
    if (!driver.waitFor([&] { return workbench.model.model() != nullptr; })) return false;
    if (!driver.step(JobStep::stock) || !driver.settle() || !driver.enter("voxelField", QString::number(voxel)) ||
        !driver.waitFor([&] { return workbench.setup.setup().voxel == voxel; }) || !driver.clickOn("embedButton"))
        return false;
    return driver.waitFor([&] { return workbench.workpiece.ready(); }) && driver.settle();
}

/// Waits until the tool has stayed in one position for a while, as it follows the pointer at a limited speed.
static void waitForRest(WindowDriver& driver) {
    const SessionRunner& session = driver.window().workbench().session;
    glm::dvec3 last = session.state().sample.proxy.tip;
    QElapsedTimer still;
    still.start();
    driver.waitFor(
        [&] {
            const glm::dvec3 tip = session.state().sample.proxy.tip;
            if (glm::distance(tip, last) > 1e-3) still.restart(); // mm
            last = tip;
            return still.elapsed() >= 100;
        },
        2000);
}

void millLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to, LinePace pace) {
    Viewport& viewport = driver.window().viewport();
    const Setup& setup = driver.window().workbench().setup.setup();
    const auto at = [&](const glm::dvec2& place) {
        return viewport.project(setup.workOffset + glm::dvec3(place, 0.0)).toPoint();
    };
    QTest::mouseMove(&viewport, at(from));
    waitForRest(driver);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, at(from));
    const int steps = pace == LinePace::quick ? 20 : 40, milliseconds = pace == LinePace::quick ? 10 : 20;
    for (int i = 0; i <= steps; ++i) {
        QTest::mouseMove(&viewport, at(glm::mix(from, to, static_cast<double>(i) / steps)));
        QTest::qWait(milliseconds);
    }
    waitForRest(driver);
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, at(to));
    QTest::qWait(100);
}

bool recordLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to, LinePace pace) {
    Workbench& workbench = driver.window().workbench();
    if (!driver.step(JobStep::mill) || !driver.clickOn("millButton")) return false;
    if (!driver.waitFor([&] { return workbench.mill.active(); })) return false;
    millLine(driver, from, to, pace);
    driver.key(Qt::Key_Escape);
    return driver.waitFor([&] { return !workbench.session.running(); });
}

bool newPath(WindowDriver& driver) {
    const PathController& path = driver.window().workbench().path;
    return driver.step(JobStep::path) && driver.clickOn("newPathButton") &&
           driver.waitFor([&] { return path.evaluated() != nullptr; }) && driver.settle();
}

bool postProgram(WindowDriver& driver) {
    const ProgramController& program = driver.window().workbench().program;
    const auto before = program.program();
    return driver.step(JobStep::program) && driver.clickOn("postButton") &&
           driver.waitFor([&] { return program.program() != before && !program.busy(); });
}

void chooseFile(WindowDriver& driver, const QString& file) {
    driver.whenDialogStands([file](QWidget& dialog) {
        auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
        auto* buttons = dialog.findChild<QDialogButtonBox*>("buttonBox");
        if (name == nullptr || buttons == nullptr) return;
        name->setText(file); // typing would open a list of names over the button
        for (const auto button : {QDialogButtonBox::Save, QDialogButtonBox::Open})
            if (QPushButton* accept = buttons->button(button)) QTest::mouseClick(accept, Qt::LeftButton);
    });
}

QAction* menuAction(WindowDriver& driver, const QString& name) {
    for (const QMenu* menu : driver.window().findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (action->objectName() == name) return action;
    return nullptr;
}

std::vector<QAction*> menuActions(WindowDriver& driver) {
    std::vector<QAction*> actions;
    for (const QAction* entry : driver.window().menuBar()->actions())
        for (QAction* action : entry->menu()->actions())
            if (!action->isSeparator() && action->menu() == nullptr) actions.push_back(action);
    return actions;
}

bool saveAs(WindowDriver& driver, const QString& file) {
    chooseFile(driver, file);
    driver.key(Qt::Key_S, Qt::ControlModifier);
    return driver.waitFor([&] { return QFile::exists(file) && !driver.window().workbench().document.unsaved(); });
}

bool answer(QWidget& dialog, const char* button) {
    auto* found = dialog.findChild<QWidget*>(button);
    if (found != nullptr) QTest::mouseClick(found, Qt::LeftButton);
    return found != nullptr;
}

double removedSoFar(const MillingContext& milling) {
    return milling.embedded.stockVolume - milling.workpieceVolume();
}

} // namespace burin::testing
