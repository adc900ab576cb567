// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/scene/camera_view.h"

#include <QAction>
#include <QApplication>
#include <QDirIterator>
#include <QLabel>
#include <QProgressBar>
#include <QtTest>

#include <algorithm>
#include <csignal>
#include <sys/types.h>

namespace burin::tst_window_preview {

using namespace burin::testing;

namespace {

/// A part with freeform faces, whose mesh takes seconds.
const QString part = QStringLiteral(BURIN_FIXTURES "/models/mouse-cover.step");

/// The import program that this process started; 0 if none is running.
pid_t importProgram() {
    QDirIterator threads(QStringLiteral("/proc/self/task"), QDir::Dirs | QDir::NoDotAndDotDot);
    while (threads.hasNext()) {
        QFile children(threads.next() + QStringLiteral("/children"));
        if (!children.open(QIODevice::ReadOnly)) continue;
        for (const QByteArray& child : children.readAll().simplified().split(' ')) {
            QFile name(QStringLiteral("/proc/%1/comm").arg(QString::fromLatin1(child)));
            if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "burin-import") return child.toInt();
        }
    }
    return 0;
}

/// Stops the import program as soon as the window has the preview: the fine mesh cannot arrive until it is continued.
class HeldImport : public QObject {
public:
    explicit HeldImport(Workbench& workbench) {
        connect(&workbench.model, &Controller::changed, this, [this, &workbench] {
            if (held_ != 0 || !workbench.model.preview()) return;
            held_ = importProgram();
            if (held_ != 0) ::kill(held_, SIGSTOP);
        });
    }
    bool held() const { return held_ != 0; }
    void goOn() const {
        if (held_ != 0) ::kill(held_, SIGCONT);
    }

private:
    pid_t held_ = 0;
};

Viewport& viewOf(WindowDriver& driver) {
    return *driver.window().findChild<Viewport*>();
}

bool seesPreview(WindowDriver& driver, const HeldImport& import) {
    return driver.waitFor([&] { return import.held() && viewOf(driver).showsPreview(); }, 60000);
}

/// The number of pixels that the part covers: those whose colour is far from the colour of the empty corner's row.
int coveredPixels(WindowDriver& driver) {
    const QImage picture = viewOf(driver).grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    int covered = 0;
    for (int y = 0; y < picture.height(); ++y) {
        const QColor empty = picture.pixelColor(2, y);
        for (int x = 0; x < picture.width(); ++x) {
            const QColor seen = picture.pixelColor(x, y);
            if (std::abs(seen.red() - empty.red()) + std::abs(seen.green() - empty.green()) +
                    std::abs(seen.blue() - empty.blue()) >
                60)
                ++covered;
        }
    }
    return covered;
}

bool sameView(const CameraView& one, const CameraView& other) {
    return glm::distance(one.focus, other.focus) < 0.01 * one.distance &&
           std::abs(one.distance - other.distance) < 0.01 * one.distance;
}

} // namespace

/// What is visible of a large part before its mesh is complete, and that it can only be viewed.
class TestWindowPreview : public QObject {
    Q_OBJECT
private slots:
    void aPartIsSeenBeforeItsMesh();
    void stoppingBringsTheOpenJobBack();
    void fromTheWelcomePageAndBack();
    BURIN_ONLY_IN_LONG_RUNS void theStatusLineNamesEachStep();
};

void TestWindowPreview::aPartIsSeenBeforeItsMesh() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    const HeldImport import(workbench);
    drop(driver.window(), part);
    QVERIFY(seesPreview(driver, import));
    QTest::qWait(400); // the camera's animation
    driver.shoot("60-preview");
    QVERIFY(driver.visible<QWidget>("workPage") != nullptr);
    QVERIFY(driver.visible<QLabel>("taskStatus")->text().contains(QStringLiteral("preview")));
    QVERIFY(coveredPixels(driver) > 20000);
    // The preview is not a part: there is nothing to set up, to embed or to mill.
    QVERIFY(!workbench.model.model());
    QVERIFY(!workbench.setup.hasPart());
    QVERIFY(!menuAction(driver, "embedAction")->isEnabled());
    QVERIFY(!viewOf(driver).pick(QRectF(viewOf(driver).rect()).center()));
    const CameraView before = viewOf(driver).cameraView();

    import.goOn();
    QVERIFY(driver.waitFor([&] { return workbench.model.model() && !viewOf(driver).showsPreview(); }, 120000));
    QVERIFY(!workbench.model.preview());
    QVERIFY(workbench.setup.hasPart());
    QVERIFY(sameView(viewOf(driver).cameraView(), before));
    QTest::qWait(400);
    QVERIFY(sameView(viewOf(driver).cameraView(), before));
    driver.shoot("61-after-preview");
}

/// The bar moves to its end and never back, and the step is named; here by what the user reads.
void TestWindowPreview::theStatusLineNamesEachStep() {
    WindowDriver driver;
    Workbench& workbench = driver.window().workbench();
    std::vector<int> values;
    std::vector<QString> texts;
    const QObject watch; // ends before the vectors
    connect(&workbench.tasks(), &TaskRunner::changed, &watch, [&] {
        if (!workbench.model.importing()) return;
        if (const auto* bar = driver.visible<QProgressBar>("taskProgress")) values.push_back(bar->value());
        if (const auto* label = driver.visible<QLabel>("taskStatus")) texts.push_back(label->text());
    });
    drop(driver.window(), part);
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }, 120000));
    QVERIFY(std::ranges::is_sorted(values));
    const auto says = [&](const char* words) {
        return std::ranges::any_of(texts, [&](const QString& text) { return text.contains(QLatin1String(words)); });
    };
    QVERIFY(says("Importing mouse-cover.step"));
    QVERIFY(says("meshing, body 1 of 1"));
    const auto end = std::unique(values.begin(), values.end());
    QVERIFY2(end - values.begin() >= 5, qPrintable(QString::number(end - values.begin())));
}

void TestWindowPreview::stoppingBringsTheOpenJobBack() {
    WindowDriver driver;
    QVERIFY(makeReady(driver, 1.0) && driver.settle());
    Workbench& workbench = driver.window().workbench();
    const auto model = workbench.model.model();
    const auto workpiece = workbench.workpiece.milling();
    const int undo = workbench.undo().index();
    viewOf(driver).setStandardView(StandardView::front);
    QTest::qWait(600);
    const CameraView view = viewOf(driver).cameraView();
    const QImage picture = viewOf(driver).grabFramebuffer();

    const HeldImport import(workbench);
    drop(driver.window(), part);
    QVERIFY(seesPreview(driver, import));
    QTest::qWait(400);
    driver.shoot("62-preview-over-job");
    QVERIFY(workbench.model.model() == model && workbench.workpiece.milling() == workpiece);
    QVERIFY(!sameView(viewOf(driver).cameraView(), view));
    QVERIFY(driver.clickOn("cancelTaskButton"));
    QVERIFY(driver.waitFor([&] { return !viewOf(driver).showsPreview(); }));
    QVERIFY(driver.settle());
    QVERIFY(workbench.model.model() == model && workbench.workpiece.milling() == workpiece);
    QCOMPARE(workbench.undo().index(), undo);
    QCOMPARE(viewOf(driver).cameraView().focus, view.focus);
    QCOMPARE(viewOf(driver).cameraView().distance, view.distance);
    QTest::qWait(600);
    QCOMPARE(viewOf(driver).grabFramebuffer(), picture);
}

void TestWindowPreview::fromTheWelcomePageAndBack() {
    WindowDriver driver;
    const HeldImport import(driver.window().workbench());
    QVERIFY(driver.visible<QWidget>("workPage") == nullptr);
    drop(driver.window(), part);
    QVERIFY(seesPreview(driver, import));
    QVERIFY(driver.clickOn("cancelTaskButton"));
    QVERIFY(driver.waitFor([&] { return driver.visible<QWidget>("workPage") == nullptr; }));
    QVERIFY(driver.waitFor([&] { return !viewOf(driver).showsPreview(); }));
}

BURIN_TEST(TestWindowPreview, QApplication)

} // namespace burin::tst_window_preview

#include "tst_window_preview.moc"
