// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/notice.h"
#include "ui/panels/value_row.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QLabel>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_strokes {

using namespace burin::testing;

namespace {

constexpr double halfTrail = 0.06; // mm: 0.05 that the tool may leave the trail by at corners, and the virtual coupling

/// The points where the tool's tip cut, from the recording's own trace: mm from the middle of the stock's top.
class CutTrace {
public:
    explicit CutTrace(WindowDriver& driver) : zero_(driver.window().workbench().setup.setup().workOffset) {
        connection_ = QObject::connect(&driver.window().workbench().session, &SessionRunner::traced,
                                       [this](const std::vector<TracePoint>& points) {
                                           for (const auto& point : points) {
                                               if (point.strokeBegins) strokes_.emplace_back();
                                               if (!strokes_.empty())
                                                   strokes_.back().push_back(glm::dvec3(point.tip) - zero_);
                                           }
                                       });
    }
    ~CutTrace() { QObject::disconnect(connection_); }
    CutTrace(const CutTrace&) = delete;
    CutTrace& operator=(const CutTrace&) = delete;
    const std::vector<glm::dvec3>& last() const { return strokes_.back(); }
    std::size_t count() const { return strokes_.size(); }

private:
    glm::dvec3 zero_;
    QMetaObject::Connection connection_;
    std::vector<std::vector<glm::dvec3>> strokes_;
};

double distanceToLine(const glm::dvec3& place, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec2 way = glm::normalize(glm::dvec2(b - a)), off = glm::dvec2(place - a);
    return std::abs(way.x * off.y - way.y * off.x);
}

} // namespace

/// Strokes that are straight, locked, repeated or rows, by mouse and keys; the effect of Esc.
class TestWindowStrokes : public QObject {
    Q_OBJECT
private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(makeReady(*driver_));
        viewport().setStandardView(StandardView::top);
        QTest::qWait(400); // the view turns
        QVERIFY(driver_->step(JobStep::mill));
        QVERIFY(driver_->clickOn("millButton"));
        QVERIFY(driver_->waitFor([&] { return workbench().mill.active(); }));
        trace_ = std::make_unique<CutTrace>(*driver_);
    }
    void cleanup() {
        trace_.reset();
        driver_.reset();
    }

    void aShiftClickCutsAStraightLineFromTheLastEnd() {
        millLine(*driver_, {-15, -8}, {-5, -8});
        QVERIFY(strokesAre(1));
        const glm::dvec3 end = trace_->last().back();
        const QPoint wanted = at({12, 7});
        const glm::dvec3 target = placeAt(wanted);
        QTest::mouseMove(&viewport(), wanted);
        QTest::qWait(300);
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ShiftModifier, wanted);
        QVERIFY(strokesAre(2));
        const auto& line = trace_->last();
        for (const glm::dvec3& place : line) {
            QVERIFY(distanceToLine(place, end, target) < halfTrail);
            QVERIFY(place.z > end.z - 0.01);
        }
        QVERIFY(glm::distance(glm::dvec2(line.front()), glm::dvec2(end)) < halfTrail);
        QVERIFY(glm::distance(glm::dvec2(line.back()), glm::dvec2(target)) < halfTrail);
        QVERIFY(std::abs(line.back().z - end.z) < 0.01); // at the height of the previous stroke
        driver_->shoot("strokes-line");
    }

    /// Esc on the way to the start of a stroke: nothing was cut, and there is nothing to repeat or undo.
    BURIN_ONLY_IN_LONG_RUNS void aStrokeThatIsGivenUpOnItsWayIsNone() {
        millLine(*driver_, {-15, -8}, {-5, -8});
        QVERIFY(strokesAre(1));
        const auto canRepeat = [&] { return driver_->visible<QPushButton>("repeatLowerButton")->isEnabled(); };
        QVERIFY(driver_->waitFor(canRepeat));
        const QPoint away = at({14, 10});
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, away);
        QTest::mouseMove(&viewport(), at({5, 10}));
        driver_->key(Qt::Key_Escape);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, at({5, 10}));
        QTest::qWait(500); // as long as the tool needs to get there
        QVERIFY(strokesAre(1) && workbench().mill.active());
        QCOMPARE(workbench().workpiece.strokes().count(), std::size_t{1});
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.strokes().count() == 0; }));
        QVERIFY(driver_->waitFor([&] { return !canRepeat(); }));
        driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->waitFor(canRepeat));
        QCOMPARE(workbench().workpiece.strokes().count(), std::size_t{1});
    }

    BURIN_ONLY_IN_LONG_RUNS void xAndYLockAStrokeUntilPressedAgain() {
        driver_->key(Qt::Key_X);
        QVERIFY(driver_->waitFor([&] { return lockSentence().contains(QStringLiteral("locked to X")); }));
        millLine(*driver_, {-12, -6}, {12, 6});
        QVERIFY(strokesAre(1));
        const std::vector<glm::dvec3> along = trace_->last();
        for (const glm::dvec3& place : along) QVERIFY(std::abs(place.y - along.front().y) < halfTrail);
        QVERIFY(std::abs(along.back().x - along.front().x) > 20.0);
        driver_->key(Qt::Key_Y);
        QVERIFY(driver_->waitFor([&] { return lockSentence().contains(QStringLiteral("locked to Y")); }));
        driver_->key(Qt::Key_Y);
        QVERIFY(driver_->waitFor([&] { return lockSentence().isEmpty(); }));
        millLine(*driver_, {-12, -6}, {12, 6});
        QVERIFY(strokesAre(2));
        QVERIFY(std::abs(trace_->last().back().y - trace_->last().front().y) > 10.0);
    }

    /// A pixel to the side, a pixel down, a pixel to the side, as a good mouse reports a slanted sweep: 30 mm of such a
    /// sweep are cut as fast as a straight line, without steps.
    void aSlantedSweepIsCutAtTheSpeedLimit() {
        QVERIFY(driver_->enter("speedField", "200"));
        const QPoint from = at({-13, 9});
        QTest::mouseMove(&viewport(), from);
        QTest::qWait(300);
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, from);
        QVERIFY(driver_->waitFor([&] { return workbench().session.state().cutting; }));
        QPoint pointer = from;
        while (glm::distance(placeAt(pointer), placeAt(from)) < 25.0) {
            pointer += (pointer.x() - from.x() > pointer.y() - from.y()) ? QPoint(0, 1) : QPoint(1, 0);
            QTest::mouseMove(&viewport(), pointer);
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, pointer);
        QVERIFY(strokesAre(1));
        const glm::dvec3 a = placeAt(from), b = placeAt(pointer);
        const double pixel = glm::distance(placeAt(from), placeAt(from + QPoint(1, 0)));
        for (const glm::dvec3& place : trace_->last())
            QVERIFY2(distanceToLine(place, a, b) < pixel + halfTrail,
                     qPrintable(QString::number(distanceToLine(place, a, b))));
        QVERIFY(glm::distance(glm::dvec2(trace_->last().back()), glm::dvec2(b)) < halfTrail);
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }));
        const QString file = driver_->folder().filePath("sweep.burin"), copy = driver_->folder().filePath("copy.burin");
        QVERIFY(saveAs(*driver_, file));
        QVERIFY(QFile::copy(file, copy)); // the window has the original open
        const Result<Project> project = Project::open(copy.toStdString());
        QVERIFY(project);
        const Result<Take> take = project->take(workbench().mill.takes().front().id);
        QVERIFY(take);
        double fastest = 0.0;
        for (std::size_t i = 10; i < take->samples.size(); ++i) {
            const Sample &before = take->samples[i - 10], &now = take->samples[i];
            if (glm::distance(before.proxy.tip, now.proxy.tip) > 5.0) continue; // between two parts of the path
            fastest = std::max(fastest, glm::distance(glm::dvec2(before.proxy.tip), glm::dvec2(now.proxy.tip)) /
                                            (now.time - before.time));
        }
        QVERIFY2(fastest > 0.9 * 200.0, qPrintable(QString::number(fastest)));
    }

    /// "Beside" means to the left in the direction of the stroke: a stroke to +X gets one that is a step-over farther
    /// to +Y.
    BURIN_ONLY_IN_LONG_RUNS void theLastStrokeIsRepeatedLowerAndBeside() {
        QVERIFY(driver_->enter("stepOverField", "3"));
        QVERIFY(driver_->enter("depthOfCutField", "0.7"));
        millLine(*driver_, {-12, -4}, {10, -1});
        QVERIFY(strokesAre(1));
        // The values that the cut required can still be read after it.
        const auto* feed = driver_->visible<ValueRow>("feedMeter");
        QVERIFY(driver_->waitFor([&] { return feed->value().contains("mm/min at") && feed->value().endsWith("rpm"); }));
        QVERIFY2(feed->toolTip().startsWith("Machinable wax, engagement "), qPrintable(feed->toolTip()));
        const std::vector<glm::dvec3> first = trace_->last();
        driver_->key(Qt::Key_L);
        QVERIFY(strokesAre(2));
        const std::vector<glm::dvec3> lower = trace_->last();
        QVERIFY(glm::distance(lower.back(), first.back() - glm::dvec3(0, 0, 0.7)) < 0.01);
        for (const glm::dvec3& place : lower) QVERIFY(distanceToLine(place, first.front(), first.back()) < 0.3);
        QVERIFY(driver_->clickOn("repeatLeftButton"));
        QVERIFY(strokesAre(3));
        const glm::dvec3 across =
            glm::normalize(glm::dvec3(first.front().y - first.back().y, first.back().x - first.front().x, 0.0));
        QVERIFY(across.y > 0.0);
        QVERIFY(glm::distance(trace_->last().back(), lower.back() + 3.0 * across) < 0.02);
        driver_->shoot("strokes-repeated");
    }

    /// Rows of a ball of radius 3 mm, 1 mm deep and 2 mm apart, leave ridges of 3 − √(9 − 1) = 0.17 mm: the volume
    /// removed is at least all of the rectangle above them, and at most also what the ball reaches beyond its edges.
    void aRasterFillsARectangleAsOneStroke() {
        driver_->key(Qt::Key_T);
        QVERIFY(driver_->enter("stepOverField", "2"));
        const double before = removedSoFar(*workbench().workpiece.milling());
        const QPoint from = at({-14, -7}), to = at({13, 6});
        const glm::dvec3 a = placeAt(from), b = placeAt(to);
        QTest::mouseMove(&viewport(), from);
        QTest::qWait(300);
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, from);
        for (int i = 1; i <= 10; ++i) {
            QTest::mouseMove(&viewport(), from + (to - from) * i / 10);
            QTest::qWait(20);
        }
        QCOMPARE(trace_->count(), std::size_t{0}); // the rectangle is drawn, but not yet cut
        driver_->shoot("strokes-raster-spanned");
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, to);
        QTest::qWait(300);
        driver_->shoot("strokes-raster-under-way");
        QVERIFY(strokesAre(1));
        QCOMPARE(trace_->count(), std::size_t{1});
        const double width = std::abs(b.y - a.y), rows = std::ceil(width / 2.0);
        for (const glm::dvec3& place : trace_->last()) {
            const double row = (place.y - a.y) / (b.y - a.y) * rows;
            const double beside = std::min(std::abs(place.x - a.x), std::abs(place.x - b.x));
            const double off = std::min(std::abs(row - std::round(row)) * width / rows, beside);
            QVERIFY2(off < halfTrail, qPrintable(QString::number(off)));
        }
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }));
        const double removed = removedSoFar(*workbench().workpiece.milling()) - before;
        const double length = std::abs(b.x - a.x), reach = 2.0 * std::sqrt(9.0 - 4.0);
        QVERIFY(removed > length * width * (1.0 - (3.0 - std::sqrt(8.0))));
        QVERIFY(removed < (length + reach) * (width + reach) * 1.0);
        QCOMPARE(workbench().mill.takes().size(), std::size_t{1});
        QCOMPARE(workbench().mill.strokesOf(workbench().mill.takes()[0].id), std::size_t{1});
    }

    void escapeEndsARasterThenMilling() {
        driver_->key(Qt::Key_T);
        const QPoint from = at({-14, -7}), to = at({13, 6});
        QTest::mouseMove(&viewport(), from);
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&viewport(), to);
        QVERIFY(driver_->waitFor([&] { return escapeLabel().contains(QStringLiteral("cancel the raster")); }));
        driver_->key(Qt::Key_Escape);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, to);
        QTest::qWait(300);
        QCOMPARE(trace_->count(), std::size_t{0});
        QVERIFY(workbench().mill.active());
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&viewport(), to);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, to);
        QVERIFY(driver_->waitFor([&] { return workbench().session.state().cutting; }));
        QVERIFY(driver_->waitFor([&] { return escapeLabel().contains(QStringLiteral("stop the tool")); }));
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().session.state().cutting; }));
        QVERIFY(strokesAre(1)); // the part of the stroke that was cut
        QVERIFY(workbench().mill.active());
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().mill.active(); }));
    }

    /// The focus is in a field: the first Esc discards what is typed there, the next one parks the tool.
    void escapeLeavesMillingFromAField() {
        auto* field = driver_->visible<QAbstractSpinBox>("depthOfCutField");
        QVERIFY(field != nullptr);
        const QString before = field->text();
        QTest::mouseDClick(field, Qt::LeftButton, Qt::NoModifier, field->rect().center());
        QTest::keyClicks(field, QStringLiteral("7"));
        QVERIFY(field->text() != before);
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->text(), before);
        QTest::qWait(100);
        QVERIFY(workbench().mill.active());
        QVERIFY(driver_->waitFor([&] { return escapeLabel().contains(QStringLiteral("stop milling")); }));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().mill.active(); }));
        QVERIFY(driver_->waitFor([&] { return escapeLabel().isEmpty(); }));
    }

    void aValueOutOfRangeSaysSo() {
        auto* field = driver_->visible<QAbstractSpinBox>("speedField");
        QVERIFY(field != nullptr);
        const QString before = field->text();
        QVERIFY(driver_->enter("speedField", "100000"));
        QCOMPARE(field->text(), before);
        auto* message = driver_->visible<QLabel>("fieldMessage");
        QVERIFY(message != nullptr && driver_->window().rect().contains(message->geometry()));
        driver_->shoot("strokes-out-of-range");
    }

    void theFirstPressIsRecordedAndOneSeesIt() {
        QVERIFY(driver_->visible<QLabel>("recordingStatus") == nullptr);
        millLine(*driver_, {-10, 0}, {10, 0});
        QVERIFY(driver_->visible<QLabel>("recordingStatus") != nullptr);
        driver_->shoot("strokes-recording");
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }));
        QVERIFY(driver_->waitFor([&] { return driver_->visible<QLabel>("recordingStatus") == nullptr; }));
        // All that was cut is in the take: replayed, as when a project is opened, it gives the same workpiece.
        const double removed = removedSoFar(*workbench().workpiece.milling());
        QVERIFY(removed > 0.0);
        QVERIFY(saveAs(*driver_, driver_->folder().filePath("strokes.burin")));
        const QString file = driver_->folder().filePath("strokes.burin");
        trace_.reset(); // it belongs to the window that is closed
        QVERIFY(driver_->restart());
        driver_->window().openFile(file);
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.ready() && !workbench().workpiece.embedding(); }));
        QCOMPARE(removedSoFar(*workbench().workpiece.milling()), removed);
    }

    /// Undoing the only stroke of a take removes the take from the list, the path and the program; redo restores it. If
    /// the project is saved and reopened without it, it stays removed.
    BURIN_ONLY_IN_LONG_RUNS void undoOfATakesFirstStrokeLeavesNoTraceOfIt() {
        const PathController& path = workbench().path;
        const ProgramController& program = workbench().program;
        millLine(*driver_, {-12, -4}, {12, -4});
        QVERIFY(strokesAre(1));
        QVERIFY(driver_->step(JobStep::path));
        QVERIFY(driver_->clickOn("newPathButton"));
        QVERIFY(driver_->waitFor([&] { return path.evaluated() && !path.outdated() && !path.busy(); }));
        QVERIFY(postProgram(*driver_));
        QVERIFY(!program.outdated());
        const auto evaluated = path.evaluated();

        QVERIFY(recordLine(*driver_, {-12, 5}, {12, 5}));
        QVERIFY(strokesAre(2));
        QVERIFY(driver_->waitFor([&] { return takesAre(2) && path.outdated() && program.outdated(); }));
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(1); }));
        QVERIFY(!path.outdated() && path.evaluated() == evaluated);
        QVERIFY(!program.outdated());
        driver_->shoot("strokes-first-undone");
        driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(2) && path.outdated() && program.outdated(); }));
        QCOMPARE(workbench().mill.strokesOf(workbench().mill.takes()[1].id), std::size_t{1});
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(1); }));

        const double removed = removedSoFar(*workbench().workpiece.milling());
        const QString file = driver_->folder().filePath("strokes.burin");
        QVERIFY(saveAs(*driver_, file));
        trace_.reset(); // it belongs to the window that is closed
        QVERIFY(driver_->restart());
        driver_->window().openFile(file);
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.ready() && !workbench().workpiece.embedding(); }));
        QVERIFY(driver_->waitFor([&] { return takesAre(1); }));
        QCOMPARE(removedSoFar(*workbench().workpiece.milling()), removed);
        QVERIFY(driver_->waitFor(
            [&] { return workbench().path.evaluated() && !workbench().path.outdated() && !workbench().path.busy(); }));
    }

    /// Without a recording the setup can be changed and a path can't be made; after the undo it is the same again.
    BURIN_ONLY_IN_LONG_RUNS void undoOfTheVeryFirstStrokeLeavesTheSetupOpen() {
        millLine(*driver_, {-12, -4}, {12, -4});
        QVERIFY(strokesAre(1));
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }));
        QVERIFY(workbench().setup.locked() && workbench().path.hasTakes());
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(0); }));
        QVERIFY(!workbench().setup.locked() && !workbench().path.hasTakes());
        driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(1); }));
        QVERIFY(workbench().setup.locked() && workbench().path.hasTakes());
        // A path of the take is undone and redone with it.
        const PathController& path = workbench().path;
        QVERIFY(driver_->step(JobStep::path));
        QVERIFY(driver_->clickOn("newPathButton"));
        QVERIFY(driver_->waitFor([&] { return path.evaluated() && !path.outdated() && !path.busy(); }));
        const auto evaluated = path.evaluated();
        for (int i = 0; i < 2; ++i) driver_->key(Qt::Key_Z, Qt::ControlModifier); // the path, and the stroke
        QVERIFY(driver_->waitFor([&] { return takesAre(0); }));
        QVERIFY(path.stored() == nullptr && !path.evaluated());
        for (int i = 0; i < 2; ++i) driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->waitFor([&] { return takesAre(1) && path.evaluated() == evaluated && !path.outdated(); }));
    }

    BURIN_ONLY_IN_LONG_RUNS void helpAndBack() {
        driver_->key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->visible<QWidget>("backButton") != nullptr);
        driver_->shoot("strokes-welcome-back");
        const auto* escape = driver_->visible<QLabel>("escapeStatus");
        QVERIFY(escape != nullptr && escape->text() == QStringLiteral("Esc: back to the project"));
        QVERIFY(driver_->clickOn("backButton"));
        QVERIFY(driver_->visible<QWidget>("viewport") != nullptr);
        driver_->key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
        driver_->key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->visible<QWidget>("viewport") != nullptr);
        driver_->key(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->visible<QWidget>("viewport") != nullptr);
        QVERIFY(workbench().mill.active()); // that Esc was handled by the page
    }

    BURIN_ONLY_IN_LONG_RUNS void aMessageLeavesTheViewCubeFree() {
        viewport().setStandardView(StandardView::isometric);
        QTest::qWait(400); // the view turns
        const QString name = QStringLiteral("a name that is so long that it takes the whole width of the view.step");
        emit workbench().failed(Error{ErrorCode::fileNotReadable, name.toStdString(), "", "and a reason of its own"});
        QVERIFY(!driver_->message().isEmpty());
        QTest::qWait(50);
        const QPoint cube = viewport().mapTo(&driver_->window(), QPoint(viewport().width() - 60, 60)); // its centre
        QWidget* under = driver_->window().childAt(cube);
        const glm::dvec3 looked = viewport().sight({1.0, 1.0}).rayDirection;
        driver_->shoot("strokes-cube");
        QTest::mouseMove(under, under->mapFrom(&driver_->window(), cube));
        QTest::mouseClick(under, Qt::LeftButton, {}, under->mapFrom(&driver_->window(), cube));
        QVERIFY(driver_->waitFor([&] { return viewport().sight({1.0, 1.0}).rayDirection != looked; }));
    }

    /// A lock is set by a key, while the user is moving to a field.
    BURIN_ONLY_IN_LONG_RUNS void aLockMovesNoFieldOfThePanel() {
        auto* field = driver_->visible<QAbstractSpinBox>("speedField");
        const QPoint before = field->mapTo(&driver_->window(), QPoint());
        viewport().setFocus();
        driver_->key(Qt::Key_X);
        QTRY_VERIFY(!lockSentence().isEmpty());
        QTest::qWait(100);
        QCOMPARE(field->mapTo(&driver_->window(), QPoint()), before);
        driver_->key(Qt::Key_X);
        QTRY_VERIFY(lockSentence().isEmpty());
        QCOMPARE(field->mapTo(&driver_->window(), QPoint()), before);
    }

    /// A field is disabled and a message appears while the user types digits: none of them turns the view, and nothing
    /// moves.
    BURIN_ONLY_IN_LONG_RUNS void nothingThatComesUnderTheHandMakesAShortcutOfATypedKey() {
        auto* field = driver_->visible<QAbstractSpinBox>("depthOfCutField");
        QTest::mouseDClick(field, Qt::LeftButton, Qt::NoModifier, field->rect().center());
        const QPoint before = field->mapTo(&driver_->window(), QPoint());
        const double looked = viewport().sight({1.0, 1.0}).rayDirection.z;
        setEnabledKeepingFocus(field, false);
        emit workbench().failed(Error{ErrorCode::fileNotReadable, "nothing.step", "", ""});
        QTest::qWait(50);
        QVERIFY(!driver_->message().isEmpty());
        QCOMPARE(field->mapTo(&driver_->window(), QPoint()), before);
        for (const int key : {Qt::Key_4, Qt::Key_3, Qt::Key_L}) {
            QWidget* focus = QApplication::focusWidget();
            QTest::keyClick(focus != nullptr ? focus : &driver_->window(), static_cast<Qt::Key>(key));
        }
        QTest::qWait(500); // a view would turn in this time
        QCOMPARE(viewport().sight({1.0, 1.0}).rayDirection.z, looked);
        setEnabledKeepingFocus(field, true);
        QVERIFY(field->hasFocus());
        driver_->shoot("strokes-message");
    }

    void metersFoldAndStaySo() {
        QVERIFY(driver_->visible<QWidget>("forceMeter") != nullptr);
        QVERIFY(driver_->visible<QWidget>("rateMeter") == nullptr);
        QVERIFY(driver_->clickOn("unfoldMetersButton"));
        QVERIFY(driver_->visible<QWidget>("rateMeter") != nullptr);
        trace_.reset();
        QVERIFY(driver_->restart(true));
        QVERIFY(!driver_->window().findChild<Meters*>()->folded());
    }

private:
    Workbench& workbench() { return driver_->window().workbench(); }
    Viewport& viewport() { return driver_->window().viewport(); }
    glm::dvec3 zero() { return workbench().setup.setup().workOffset; }
    /// The pixel over a point on the stock's top, mm from its middle.
    QPoint at(const glm::dvec2& place) { return viewport().project(zero() + glm::dvec3(place, 0.0)).toPoint(); }
    /// The point on the stock's top under a pixel, where the sight line meets z = 0.
    glm::dvec3 placeAt(const QPoint& pixel) {
        const ViewportEvent sight = viewport().sight(QPointF(pixel));
        const glm::dvec3 from = sight.rayOrigin - zero();
        return from - sight.rayDirection * (from.z / sight.rayDirection.z);
    }
    bool strokesAre(std::size_t count) {
        return driver_->waitFor([&] { return workbench().workpiece.strokes().count() == count; }, 15000);
    }
    bool takesAre(std::size_t count) { return workbench().mill.takes().size() == count; }
    QString lockSentence() {
        auto* lock = driver_->visible<Notice>("millLock");
        return lock != nullptr ? lock->sentence() : QString();
    }
    QString escapeLabel() {
        auto* label = driver_->visible<QLabel>("escapeStatus");
        return label != nullptr ? label->text() : QString();
    }

    std::unique_ptr<WindowDriver> driver_;
    std::unique_ptr<CutTrace> trace_;
};

BURIN_TEST(TestWindowStrokes, QApplication)

} // namespace burin::tst_window_strokes

#include "tst_window_strokes.moc"
