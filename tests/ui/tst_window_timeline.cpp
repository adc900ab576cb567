// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"
#include "core/path/hand_interval.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/notice.h"
#include "ui/panels/program_view.h"
#include "ui/panels/timeline_panel.h"

#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_timeline {

using namespace burin::testing;

/// The timeline: going to a moment, playing, continuing to mill from there, and undoing all of it.
class TestWindowTimeline : public QObject {
    Q_OBJECT
private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(makeReady(*driver_));
        QVERIFY(saveAs(*driver_, driver_->folder().filePath("hand.burin")));
        viewport().setStandardView(StandardView::top);
        QTest::qWait(400); // the view turns
        QVERIFY(driver_->step(JobStep::mill));
        stock_ = now();
        QVERIFY(driver_->clickOn("millButton"));
        QVERIFY(driver_->waitFor([&] { return workbench().mill.active(); }));
        millLine(*driver_, {-15, -8}, {-5, -8});
        QVERIFY(strokesAre(1));
        QVERIFY(leaveMilling());
        first_ = now();
        QVERIFY(first_ != stock_);
        QVERIFY(enterMilling());
        millLine(*driver_, {0, -8}, {12, -8});
        QVERIFY(strokesAre(2));
        millLine(*driver_, {0, 6}, {12, 6});
        QVERIFY(strokesAre(3));
        QVERIFY(leaveMilling());
        all_ = now();
        QVERIFY(driver_->waitFor([&] { return time().possible() && time().recorded()->tracks.size() == 2; }));
    }
    void cleanup() { driver_.reset(); }

    /// A drag along the timeline shows the workpiece as it was, without changing the workpiece itself; Esc shows the
    /// present.
    void aDragThroughTheTimeShowsWhatStoodThere() {
        driver_->shoot("timeline");
        const double middle = secondsOfTake(1);
        QVERIFY(seek(middle));
        QCOMPARE(fingerprint(time().shown()->workpiece), first_);
        QCOMPARE(now(), all_);
        QVERIFY(driver_->waitFor([&] { return time().shown()->sample.has_value(); }));
        driver_->shoot("timeline-middle");
        QVERIFY(seek(0.0));
        QCOMPARE(fingerprint(time().shown()->workpiece), stock_);
        QVERIFY(seek(time().recorded()->seconds()));
        QCOMPARE(fingerprint(time().shown()->workpiece), all_);
        QVERIFY(seek(0.0)); // and back, without cutting anything again
        QCOMPARE(fingerprint(time().shown()->workpiece), stock_);
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !time().away(); }));
        QCOMPARE(now(), all_);
    }

    /// Keys, playing with a pause, and its end.
    BURIN_ONLY_IN_LONG_RUNS void itPlaysToTheEnd() {
        QVERIFY(driver_->clickOn("timeStartButton"));
        QVERIFY(driver_->waitFor([&] { return time().shown() && !time().arriving() && time().seconds() == 0.0; }));
        auto* speed = driver_->visible<QComboBox>("playSpeed");
        speed->setFocus();
        driver_->key(Qt::Key_End); // 64 ×
        QCOMPARE(time().speed(), 64.0);
        QVERIFY(driver_->clickOn("playButton"));
        QVERIFY(driver_->waitFor([&] { return time().seconds() > 0.0; }));
        QVERIFY(driver_->waitFor([&] { return !time().playing() && !time().arriving(); }));
        QCOMPARE(time().seconds(), time().recorded()->seconds());
        QCOMPARE(fingerprint(time().shown()->workpiece), all_);
        auto* view = driver_->visible<TimelineView>("timelineView");
        view->setFocus();
        driver_->key(Qt::Key_Home);
        QVERIFY(driver_->waitFor([&] { return time().seconds() == 0.0 && !time().arriving(); }));
        driver_->key(Qt::Key_Right, Qt::ControlModifier); // the first stroke
        const SampleRange stroke = time().recorded()->tracks.front().strokes.front();
        QVERIFY(driver_->waitFor([&] { return !time().arriving() && time().shown()->moment.samples == stroke.first; }));
    }

    /// Milling continues from the middle: what came after is switched off. Undo restores the same state to the bit, and
    /// so does redo.
    void punchedInAndTakenBack() {
        QVERIFY(seek(secondsOfTake(1)));
        QVERIFY(driver_->clickOn("punchInButton"));
        QVERIFY(driver_->waitFor([&] { return workbench().mill.recording(); }));
        QCOMPARE(fingerprint(workbench().session.workpiece()), first_);
        millLine(*driver_, {-10, 2}, {10, 2});
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.strokes().count() == 1; }));
        QVERIFY(leaveMilling());
        const std::uint64_t punched = now();
        QVERIFY(punched != first_ && punched != all_);
        QVERIFY(driver_->waitFor([&] { return time().possible() && time().recorded()->tracks.size() == 3; }));
        QVERIFY(!time().recorded()->tracks[1].switchedOff.empty());
        driver_->shoot("timeline-punched-in");
        QVERIFY(replayed() == punched);

        driver_->key(Qt::Key_Z, Qt::ControlModifier); // the stroke
        QVERIFY(stands(first_));
        driver_->key(Qt::Key_Z, Qt::ControlModifier); // the punch-in
        QVERIFY(stands(all_));
        driver_->key(Qt::Key_Z, Qt::ControlModifier); // an earlier stroke, for which there is no snapshot any more
        QVERIFY(driver_->waitFor([&] { return !busy() && now() != all_; }));
        for (int i = 0; i < 3; ++i) {
            driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(driver_->waitFor([&] { return !busy(); }));
            QTest::qWait(100);
            QVERIFY(driver_->waitFor([&] { return !busy(); }));
        }
        QVERIFY(stands(punched));
        QVERIFY(replayed() == punched);
    }

    /// The part that was switched off is milled on top again from its menu; the project opens with the same workpiece.
    BURIN_ONLY_IN_LONG_RUNS void bothVersionsAreKept() {
        QVERIFY(seek(secondsOfTake(1)));
        QVERIFY(driver_->clickOn("punchInButton"));
        QVERIFY(driver_->waitFor([&] { return workbench().mill.recording(); }));
        millLine(*driver_, {-10, 2}, {10, 2});
        QVERIFY(driver_->waitFor([&] { return workbench().workpiece.strokes().count() == 1; }));
        QVERIFY(leaveMilling());
        const std::uint64_t punched = now();
        QVERIFY(driver_->waitFor([&] { return time().possible() && time().recorded()->tracks.size() == 3; }));
        QVERIFY(chooseInMenu(1.5, "takeOnAction"));
        QVERIFY(driver_->waitFor([&] { return !busy() && now() != punched; }));
        const std::uint64_t together = now();
        QVERIFY(together != all_);
        QVERIFY(replayed() == together);
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(stands(punched));
        driver_->key(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(driver_->settle());
    }

    /// Moves a take by key and menu, with undo: the workpiece is unchanged, and at the boundary between the takes the
    /// timeline shows what the earlier takes cut. A copy cuts nothing more, and replaces its original if that is
    /// deleted.
    BURIN_ONLY_IN_LONG_RUNS void takesAreMovedAndCopied() {
        const std::vector<std::int64_t> ids = listed();
        QVERIFY(goesBy(ids));
        QVERIFY(chooseInMenu(0.5, "takeOffAction"));
        QVERIFY(driver_->waitFor([&] { return !busy() && now() != all_; }));
        const std::uint64_t second = now(); // only the second take
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(stands(all_));
        const std::vector<std::int64_t> other{ids[1], ids[0]};
        QVERIFY(goesBy(ids));
        clickOnTake(1);
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return workbench().mill.chosenTake() == ids[1]; }));
        QVERIFY(menuAction(*driver_, "takeUpAction")->isEnabled() &&
                !menuAction(*driver_, "takeDownAction")->isEnabled());
        driver_->key(Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(goesBy(other));
        QCOMPARE(now(), all_);
        driver_->shoot("timeline-moved");
        QVERIFY(seek(secondsOfTake(1)));
        QCOMPARE(fingerprint(time().shown()->workpiece), second);
        QVERIFY(seek(time().recorded()->seconds()));
        QCOMPARE(fingerprint(time().shown()->workpiece), all_);
        QCOMPARE(replayed(), all_);
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(goesBy(ids));
        QVERIFY(seek(secondsOfTake(1)));
        QCOMPARE(fingerprint(time().shown()->workpiece), first_);
        driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(goesBy(other));
        QVERIFY(chooseInMenu(0.5, "moveTakeDownAction"));
        QVERIFY(goesBy(ids));

        clickOnTake(0);
        driver_->key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(driver_->waitFor([&] { return listed().size() == 3 && time().recorded()->tracks.size() == 3; }));
        const std::int64_t copy = listed().back();
        QVERIFY(goesBy({ids[0], ids[1], copy}));
        QCOMPARE(workbench().mill.chosenTake(), copy);
        QCOMPARE(workbench().mill.strokesOf(copy), workbench().mill.strokesOf(ids[0]));
        driver_->shoot("timeline-copied");
        QCOMPARE(now(), all_);
        QVERIFY(seek(time().recorded()->seconds()));
        QCOMPARE(fingerprint(time().shown()->workpiece), all_);
        QVERIFY(chooseInMenu(0.5, "deleteTakeAction"));
        QVERIFY(goesBy({ids[1], copy}));
        QVERIFY(stands(all_));
        QCOMPARE(replayed(), all_);
        for (int i = 0; i < 2; ++i) {
            driver_->key(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(stands(all_));
        }
        QVERIFY(goesBy(ids));
    }

    /// In the program step the timeline is the program's: its workpiece at the end is that of the check, the current
    /// line follows, blocks are stepped through; in the other steps it is that of the takes again.
    BURIN_ONLY_IN_LONG_RUNS void aProgramIsGoneThrough() {
        QVERIFY(newPath(*driver_));
        QVERIFY(postProgram(*driver_));
        QVERIFY(driver_->step(JobStep::program));
        QVERIFY(driver_->waitFor([&] { return time().showsProgram() && time().possible(); }));
        const auto program = workbench().program.program();
        QVERIFY(std::abs(time().recorded()->seconds() - program->report.machiningSeconds) < 0.02);
        QVERIFY(seek(time().recorded()->seconds()));
        QCOMPARE(fingerprint(time().shown()->workpiece), fingerprint(program->machined));
        QVERIFY(seek(0.0));
        QCOMPARE(fingerprint(time().shown()->workpiece), stock_);
        auto* view = driver_->visible<TimelineView>("timelineView");
        view->setFocus();
        int before = 0;
        for (int i = 0; i < 5; ++i) {
            driver_->key(Qt::Key_Right, Qt::ControlModifier);
            QVERIFY(driver_->waitFor([&] { return !time().arriving() && time().line() > 0; }));
            QVERIFY(time().line() >= before);
            before = time().line();
        }
        QVERIFY(driver_->waitFor([&] { return driver_->window().findChild<ProgramView*>()->line() == before; }));
        QVERIFY(seek(0.6 * time().recorded()->seconds()));
        driver_->shoot("timeline-program");
        QVERIFY(driver_->step(JobStep::mill));
        QVERIFY(driver_->waitFor([&] { return !time().showsProgram() && !time().away(); }));
        QCOMPARE(time().recorded()->tracks.size(), std::size_t{2});
    }

    /// A foreign program that is dropped on the window is checked, playing stops where its rapid runs into the stock,
    /// and undo restores the previous program.
    void aForeignProgramIsPlayedToItsFinding() {
        QFile file(driver_->folder().filePath("foreign.nc"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("G21 G90 G54\nM3 S12000\nG0 Z10\nG0 X-15 Y5\nG1 Z-1 F300\nG1 X-5 F600\nG0 X10\nG0 Z10\nM2\n");
        file.close();
        drop(driver_->window(), file.fileName());
        const auto program = [&] { return workbench().program.program(); };
        QVERIFY(driver_->waitFor([&] { return program() && !workbench().program.busy(); }));
        QVERIFY(!program()->passed());
        QVERIFY(driver_->waitFor([&] { return driver_->visible<Notice>("verdict") != nullptr; }));
        QVERIFY(driver_->visible<Notice>("verdict")->sentence().contains(QStringLiteral("1 finding")));
        QVERIFY(driver_->waitFor([&] { return time().showsProgram() && time().possible(); }));
        QVERIFY(!time().programTime()->findings.empty());
        QVERIFY(driver_->clickOn("timeStartButton"));
        QVERIFY(driver_->waitFor([&] { return time().shown() && !time().arriving(); }));
        time().setSpeed(8.0);
        // A breakpoint before the finding, set by a click on the line number and removed by the key.
        auto* text = driver_->visible<ProgramView>("programText");
        text->showLine(6);
        const QRect line = text->cursorRect();
        QTest::mouseClick(text->findChild<QWidget*>("programNumbers"), Qt::LeftButton, Qt::NoModifier,
                          QPoint(8, line.center().y()));
        QCOMPARE(time().breakpoints(), std::set<int>{6});
        driver_->shoot("timeline-breakpoint");
        QVERIFY(driver_->clickOn("playButton"));
        QVERIFY(driver_->waitFor([&] { return !time().playing() && !time().arriving(); }));
        QCOMPARE(time().line(), 6);
        driver_->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(time().breakpoints(), std::set<int>{});
        QVERIFY(driver_->clickOn("playButton"));
        QVERIFY(driver_->waitFor([&] { return !time().playing() && !time().arriving(); }));
        QCOMPARE(time().line(), 7);
        QVERIFY(time().seconds() < time().recorded()->seconds());
        driver_->shoot("timeline-finding");
        QVERIFY(driver_->clickOn("playButton")); // on, to the end
        QVERIFY(
            driver_->waitFor([&] { return !time().playing() && time().seconds() == time().recorded()->seconds(); }));
        QVERIFY(driver_->waitFor([&] { return !time().arriving(); }));
        QCOMPARE(fingerprint(time().shown()->workpiece), fingerprint(program()->machined));
        for (int i = 0; i < 3 && !workbench().program.storedText().isEmpty(); ++i)
            driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(workbench().program.storedText().isEmpty() && !workbench().program.program());
    }

    /// A point that is clicked on the path is marked at the time at which the tool was there, and the past follows it;
    /// a time of the timeline is marked on the path.
    BURIN_ONLY_IN_LONG_RUNS void pathAndTimelineShowTheSamePoint() {
        QVERIFY(newPath(*driver_));
        QVERIFY(driver_->step(JobStep::path));
        QVERIFY(driver_->waitFor([&] { return workbench().path.evaluated() && !workbench().path.busy(); }));
        QVERIFY(driver_->settle());
        const std::vector<PathPoint>& points = workbench().path.evaluated()->path.points;
        const auto cut = std::ranges::find_if(points, [&](const PathPoint& point) {
            return point.kind == MoveKind::cut && point.source == listed()[1] && point.sample > 0;
        });
        QVERIFY(cut != points.end());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().project(cut->pose.tip).toPoint());
        const std::optional<SourceInterval>& chosen = workbench().path.selection();
        QVERIFY(chosen && chosen->source == listed()[1]);
        const std::optional<double> seconds = time().secondsAt(Moment{chosen->source, chosen->first});
        QVERIFY(seconds);
        QVERIFY(driver_->waitFor([&] { return isYellow(view().placeOf(*seconds) + 1.0); }));
        QVERIFY(!time().away()); // the workpiece stays as it is
        driver_->shoot("timeline-chosen-point");
        const auto isThere = [&](const glm::dvec3& place) {
            return time().shown() && !time().arriving() && time().shown()->sample &&
                   glm::distance(time().shown()->sample->proxy.tip, place) < 0.3;
        };
        QVERIFY(seek(0.2)); // now the past is shown, and follows the next click
        const PathPoint& other = *std::ranges::find_if(points, [&](const PathPoint& point) {
            return point.kind == MoveKind::cut && point.source == listed()[0] && point.sample > 0;
        });
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().project(other.pose.tip).toPoint());
        QVERIFY(driver_->waitFor([&] { return isThere(other.pose.tip); }));

        // Back: the point of the path is where the tool was.
        const std::uint64_t sample = time().recorded()->tracks[1].strokes.front().first;
        const std::uint64_t length = time().recorded()->tracks[1].strokes.front().count;
        QVERIFY(seek(secondsOfTake(1) +
                     time().recorded()->tracks[1].info.tickPeriod * static_cast<double>(sample + length / 2)));
        QVERIFY(driver_->waitFor([&] { return time().handTip().has_value(); }));
        const auto at = placeAt(workbench().path.evaluated()->path, *time().handMoment(), time().handTip());
        QVERIFY(at && isThere(*at));
        auto* text = driver_->window().findChild<QLabel*>("pathAtTime");
        QVERIFY(driver_->waitFor([&] { return !text->isHidden() && text->text().startsWith("Timeline: X "); }));
        const QPoint dot = viewport().mapTo(&driver_->window(), viewport().project(*at).toPoint());
        QVERIFY(driver_->waitFor([&] { return driver_->window().grab().toImage().pixelColor(dot).green() > 215; }));
        driver_->shoot("timeline-point-on-path");
        driver_->key(Qt::Key_Escape);
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !time().away() && text->isHidden(); }));
        workbench().path.pointAt({-1, 5}); // of a computed pass
        QVERIFY(driver_->waitFor([&] { return isYellow(view().placeOf(0.0) + 3.0); }));
        driver_->shoot("timeline-computed-point");
    }

    /// The distance from the block's top while the tool goes level over it is the height of the tip above it.
    BURIN_ONLY_IN_LONG_RUNS void theDeviationIsDrawn() {
        const auto values = [&](std::size_t take) -> const std::vector<float>& {
            return time().recorded()->tracks[take].curves[static_cast<std::size_t>(TrackCurve::deviation)];
        };
        QVERIFY(values(0).empty()); // nobody wants it yet
        driver_->window().findChild<QAction*>("curve_deviation")->trigger();
        QVERIFY(driver_->waitFor([&] { return !values(0).empty() && !values(1).empty() && !busy(); }));
        const double top = workbench().workpiece.milling()->partModel->box().high.z;
        for (std::size_t take = 0; take < 2; ++take) {
            const TakeTrack& track = time().recorded()->tracks[take];
            const std::vector<float>& heights = track.curves[static_cast<std::size_t>(TrackCurve::height)];
            QCOMPARE(values(take).size(), heights.size());
            const SampleRange stroke = track.strokes.front();
            const std::size_t bin = (stroke.first + stroke.count / 2) / TakeTrack::samplesPerBin;
            const double above = static_cast<double>(heights[bin]) - top;
            QVERIFY2(std::abs(static_cast<double>(values(take)[bin]) - above) < 0.01,
                     qPrintable(QStringLiteral("%1, not %2").arg(static_cast<double>(values(take)[bin])).arg(above)));
        }
        driver_->shoot("timeline-deviation");
        // A further take is measured when milling has ended, the others stay.
        QVERIFY(enterMilling());
        millLine(*driver_, {-10, 2}, {10, 2});
        QVERIFY(leaveMilling());
        QVERIFY(driver_->waitFor(
            [&] { return time().recorded()->tracks.size() == 3 && !values(2).empty() && !values(0).empty(); }));
    }

    /// The clip of a recording grows while it is milled, in no more than ten steps a second; its stroke is visible.
    BURIN_ONLY_IN_LONG_RUNS void aRecordingGrowsOnTheTimeline() {
        const double before = view().all();
        QVERIFY(enterMilling());
        QElapsedTimer passed;
        passed.start();
        QSignalSpy steps(&workbench().growing, &Controller::changed);
        millLine(*driver_, {-10, 2}, {10, 2});
        QVERIFY(driver_->waitFor([&] { return strokesAre(4) && view().all() > before + 0.1; }));
        QVERIFY(steps.count() >= 2 && steps.count() <= passed.elapsed() / 100 + 2);
        QCOMPARE(workbench().growing.takes().size(), std::size_t{1});
        const GrowingTake take = workbench().growing.takes().front();
        QVERIFY(workbench().growing.underWay(take.take));
        QCOMPARE(take.strokes.size(), std::size_t{1});
        QVERIFY(take.strokes.front().second > take.strokes.front().first &&
                take.strokes.front().second <= take.seconds);
        driver_->shoot("timeline-growing");
        QVERIFY(leaveMilling());
        QVERIFY(driver_->waitFor(
            [&] { return time().recorded()->tracks.size() == 3 && workbench().growing.takes().empty(); }));
        QVERIFY(std::abs(time().recorded()->tracks[2].seconds() - take.seconds) <
                1e-3 * static_cast<double>(passed.elapsed()));
        const SampleRange stroke = time().recorded()->tracks[2].strokes.front();
        const double period = time().recorded()->tracks[2].info.tickPeriod;
        QVERIFY(std::abs(static_cast<double>(stroke.first) * period - take.strokes.front().first) < 0.2);
    }

private:
    TimelineView& view() { return *driver_->visible<TimelineView>("timelineView"); }
    /// Whether the row of the takes has the colour of the chosen part of a path there.
    bool isYellow(double x) {
        const QColor colour =
            view().grab().toImage().pixelColor(static_cast<int>(std::lround(x)), view().height() - 16);
        return colour.red() > 215 && colour.green() > 200 && colour.blue() < 120;
    }
    Workbench& workbench() { return driver_->window().workbench(); }
    Viewport& viewport() { return driver_->window().viewport(); }
    TimeController& time() { return workbench().time; }
    std::uint64_t now() { return fingerprint(workbench().workpiece.milling()->embedded.workpiece.snapshot()); }
    bool busy() { return workbench().workpiece.embedding() || !workbench().tasks().idle(); }
    bool stands(std::uint64_t wanted) {
        return driver_->waitFor([&] { return !busy() && now() == wanted; });
    }
    bool strokesAre(std::size_t count) {
        return driver_->waitFor([&] { return workbench().workpiece.strokes().count() == count; });
    }
    bool enterMilling() {
        return driver_->clickOn("millButton") && driver_->waitFor([&] { return workbench().mill.active(); });
    }
    bool leaveMilling() {
        return driver_->clickOn("millButton") &&
               driver_->waitFor([&] { return !workbench().mill.active() && !workbench().session.running(); }) &&
               driver_->settle();
    }
    std::vector<std::int64_t> listed() {
        std::vector<std::int64_t> ids;
        for (const TakeInfo& take : workbench().mill.allTakes()) ids.push_back(take.id);
        return ids;
    }
    /// Waits until the takes are in that order, both in the list and in the timeline.
    bool goesBy(const std::vector<std::int64_t>& ids) {
        const bool goes = driver_->waitFor([&] {
            if (busy() || !time().possible() || time().reading()) return false;
            std::vector<std::int64_t> tracks;
            for (const TakeTrack& track : time().recorded()->tracks) tracks.push_back(track.info.id);
            return listed() == ids && tracks == ids;
        });
        QTest::qWait(50); // the view is told
        return goes;
    }
    void clickOnTake(std::size_t take) {
        auto* view = driver_->visible<TimelineView>("timelineView");
        const double middle = 0.5 * (secondsOfTake(take) + secondsOfTake(take + 1));
        const QPoint place(static_cast<int>(std::lround(view->placeOf(middle))), view->height() - 16);
        QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier, place);
    }
    double secondsOfTake(std::size_t end) {
        double seconds = 0.0;
        for (std::size_t i = 0; i < end; ++i) seconds += time().recorded()->tracks[i].seconds();
        return seconds;
    }
    /// Goes to a moment by a press and a drag.
    bool seek(double seconds) {
        auto* view = driver_->visible<TimelineView>("timelineView");
        const auto place = [&](double at) {
            return QPoint(static_cast<int>(std::lround(view->placeOf(at))), view->height() - 16);
        };
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, place(0.5 * seconds));
        QTest::mouseMove(view, place(0.7 * seconds));
        QTest::mouseMove(view, place(seconds));
        QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, place(seconds));
        time().goTo(seconds); // to the exact sample, which a pixel does not give
        return driver_->waitFor([&] {
            return time().shown() && !time().arriving() &&
                   time().shown()->moment == time().recorded()->momentAt(seconds);
        });
    }
    /// @param take  number of the take, with a fraction for the position within it
    bool chooseInMenu(double take, const char* action) {
        auto* view = driver_->visible<TimelineView>("timelineView");
        const auto before = static_cast<std::size_t>(take);
        const double seconds =
            secondsOfTake(before) + (take - static_cast<double>(before)) * time().recorded()->tracks[before].seconds();
        const QPoint place(static_cast<int>(std::lround(view->placeOf(seconds))), view->height() - 16);
        QContextMenuEvent wanted(QContextMenuEvent::Mouse, place, view->mapToGlobal(place));
        QCoreApplication::sendEvent(view, &wanted);
        QMenu* menu = nullptr;
        if (!driver_->waitFor([&] { return (menu = driver_->window().findChild<QMenu*>("takeMenu")) != nullptr; }))
            return false;
        driver_->shoot("timeline-menu");
        for (QAction* each : menu->actions())
            if (each->objectName() == QLatin1String(action)) {
                QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(each).center());
                return true;
            }
        return false;
    }
    /// Fingerprint of the workpiece as replayed from all recordings, without stored snapshots.
    std::uint64_t replayed() {
        const std::shared_ptr<MillingContext> milling = workbench().workpiece.milling();
        driver_->key(Qt::Key_S, Qt::ControlModifier);
        if (!driver_->settle()) return 0;
        const Result<Project> project = Project::openForReading(workbench().document.file());
        if (!project) return 0;
        Progress progress;
        const Result<RecordedWork> all = recordedWork(*project, false);
        if (!all) return 0;
        Result<RunVolume> volume = workpieceOf(
            *all, [&] { return milling->stock->makeStock(progress); }, progress);
        return volume ? fingerprint(volume->snapshot()) : 0;
    }

    std::unique_ptr<WindowDriver> driver_;
    std::uint64_t stock_ = 0, first_ = 0, all_ = 0;
};

BURIN_TEST(TestWindowTimeline, QApplication)

} // namespace burin::tst_window_timeline

#include "tst_window_timeline.moc"
