// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

namespace burin::tst_viewport_obstacle {

/// Machines with insufficient OpenGL. Each is simulated by starting this program again with another display.
class TestViewportObstacle : public QObject {
    Q_OBJECT

private slots:
    void hereTheSceneCanBeDrawn() {
        if (!asked()) QCOMPARE(Viewport::drawingObstacle(), QString());
    }

    void tellsWhenOpenGlIsMissingOrTooOld_data() {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("version");
        QTest::newRow("none") << "offscreen"
                              << "";
        QTest::newRow("2.1") << "xcb"
                             << "2.1";
    }
    void tellsWhenOpenGlIsMissingOrTooOld() {
        if (asked()) return;
        QFETCH(QString, platform);
        QFETCH(QString, version);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(asking, "1");
        environment.insert("QT_QPA_PLATFORM", platform);
        if (!version.isEmpty()) environment.insert("MESA_GL_VERSION_OVERRIDE", version);
        QProcess child;
        child.setProcessEnvironment(environment);
        child.start(QApplication::applicationFilePath(), {"viewport_obstacle", "drawingFails"});
        QVERIFY(child.waitForFinished(30000));
        QVERIFY2(child.exitCode() == 0, child.readAllStandardOutput().constData());
    }

    /// Runs in the child of the test above.
    void drawingFails() {
        if (!asked()) return;
        QVERIFY(Viewport::drawingObstacle().contains("OpenGL 3.2"));
        if (QGuiApplication::platformName() == "offscreen") return; // no OpenGL at all: no viewport is created
        Viewport viewport;
        QSignalSpy failed(&viewport, &Viewport::drawingFailed);
        viewport.resize(300, 200);
        viewport.setTool(fixture::ballTool());
        viewport.show();
        QTRY_COMPARE(failed.count(), 1);
        QCOMPARE(failed.at(0).at(0).toString(), Viewport::drawingObstacle());
        ToolMarks marks;
        marks.proxy.tip = {1.0, 2.0, 3.0};
        viewport.setToolMarks(marks);
        QTest::qWait(100); // nothing is drawn, nothing crashes
        QCOMPARE(viewport.statistics().frames, std::size_t{0});
    }

private:
    static constexpr const char* asking = "BURIN_TEST_OLD_OPENGL";
    static bool asked() { return qEnvironmentVariableIsSet(asking); }
};

BURIN_TEST(TestViewportObstacle, QApplication)

} // namespace burin::tst_viewport_obstacle

#include "tst_viewport_obstacle.moc"
