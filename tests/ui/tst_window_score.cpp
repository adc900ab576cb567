// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Scores a take against a reference: by shortcut, by the menu of the tree, and on the timeline.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/project_tree.h"
#include "ui/panels/timeline_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QtTest>

namespace burin::tst_window_score {

using namespace burin::testing;

namespace {

QString textOf(const QWidget& dialog, const char* label) {
    const auto* found = dialog.findChild<QLabel*>(QLatin1String(label));
    return found != nullptr ? found->text() : QStringLiteral("no label");
}

/// Returns the number that precedes the unit.
double numberOf(const QString& text) {
    return text.split(QChar(QChar::Nbsp)).front().toDouble();
}

} // namespace

class TestWindowScore : public QObject {
    Q_OBJECT
private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(makeReady(*driver_, 1.0));
        QVERIFY(recordLine(*driver_, {-15.0, -8.0}, {-5.0, -8.0}));
        QVERIFY(driver_->settle());
        QVERIFY(recordLine(*driver_, {-12.0, 6.0}, {12.0, 6.0}));
        QVERIFY(driver_->settle());
        QVERIFY(driver_->waitFor([&] { return workbench().mill.allTakes().size() == 2; }));
        QVERIFY(driver_->waitFor([&] { return time().possible() && time().recorded()->tracks.size() == 2; }));
    }
    void cleanup() { driver_.reset(); }

    /// The shortcut compares the newest take with the first one. Both together removed what the workpiece lost; the
    /// longer line took longer. The reference is drawn behind the curve of the take until the box is unticked; nothing
    /// else in the timeline changes.
    BURIN_ONLY_IN_LONG_RUNS void theNewestTakeIsComparedByKey() {
        bool compared = false;
        driver_->whenDialogStands([&](QWidget& dialog) {
            lookAtComparison(dialog);
            compared = answer(dialog, "closeScoreButton");
        });
        driver_->key(Qt::Key_N, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(driver_->waitFor([&] { return compared; }));
        auto* view = driver_->visible<TimelineView>("timelineView");
        QVERIFY(view && driver_->settle());
        driver_->shoot("score-timeline");
        const QImage drawn = view->grab().toImage();
        workbench().score.setDrawn(false);
        QVERIFY(driver_->waitFor([&] { return view->grab().toImage() != drawn; }));
        const QImage plain = view->grab().toImage();
        const double ratio = static_cast<double>(plain.width()) / view->width();
        const int begin = static_cast<int>(ratio * view->placeOf(time().recorded()->tracks[0].seconds())) - 1;
        for (int x = 0; x < begin; ++x)
            for (int y = 0; y < plain.height(); ++y) QVERIFY(plain.pixel(x, y) == drawn.pixel(x, y));
    }

    /// Scores the first take from the menu of the tree; the keyboard chooses no reference, then the other take.
    void aTakeIsScoredFromItsMenu() {
        driver_->key(Qt::Key_F10, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return driver_->visible<ProjectTree>("projectTree") != nullptr; }));
        auto* tree = driver_->visible<ProjectTree>("projectTree");
        const auto takes = [&] { return tree->findItems("Takes", Qt::MatchExactly | Qt::MatchRecursive, 0); };
        QVERIFY(driver_->waitFor([&] { return !takes().isEmpty() && takes().front()->childCount() == 2; }));
        const QPoint place = tree->visualItemRect(takes().front()->child(0)).center();
        QContextMenuEvent wanted(QContextMenuEvent::Mouse, place, tree->viewport()->mapToGlobal(place));
        QCoreApplication::sendEvent(tree->viewport(), &wanted);
        QMenu* menu = nullptr;
        QVERIFY(driver_->waitFor([&] { return (menu = driver_->window().findChild<QMenu*>("takeMenu")) != nullptr; }));
        bool compared = false;
        driver_->whenDialogStands([&](QWidget& dialog) {
            chooseReferences(dialog);
            compared = true;
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        auto* entry = menu->findChild<QAction*>("scoreTakeEntry");
        QVERIFY(entry);
        QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(entry).center());
        QVERIFY(driver_->waitFor([&] { return compared; }));
    }

private:
    void lookAtComparison(QWidget& dialog) {
        QCOMPARE(dialog.objectName(), QStringLiteral("scoreDialog"));
        QVERIFY(scored());
        driver_->shoot("score-dialog");
        QCOMPARE(dialog.findChild<QComboBox*>("scoreTake")->currentData().toLongLong(), take(1).id);
        QCOMPARE(dialog.findChild<QComboBox*>("scoreReference")->currentData().toLongLong(), take(0).id);
        const double own = seconds(take(1)), other = seconds(take(0));
        QVERIFY(std::abs(numberOf(textOf(dialog, "score_duration_s")) - own) < 0.051);
        QVERIFY(std::abs(numberOf(textOf(dialog, "reference_duration_s")) - other) < 0.051);
        QCOMPARE(textOf(dialog, "score_gouge_tries"), QStringLiteral("0"));
        QCOMPARE(textOf(dialog, "verdict_gouge_tries"), QStringLiteral("the same"));
        const std::vector<TakeScore>& scores = workbench().score.scores();
        const double removed = *scores[0][ScoreValue::removed] + *scores[1][ScoreValue::removed];
        const double lost = removedSoFar(*workbench().workpiece.milling());
        QVERIFY2(std::abs(removed - lost) < 1e-3, qPrintable(QString("%1, not %2").arg(removed).arg(lost)));
        QVERIFY(textOf(dialog, "verdict_removed_mm3").contains("better by"));
        QVERIFY(*scores[0][ScoreValue::meanStockLeft] < *scores[1][ScoreValue::meanStockLeft]);
        auto* box = dialog.findChild<QCheckBox*>("scoreDrawn");
        for (const bool on : {false, true}) {
            QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {10, box->height() / 2});
            QCOMPARE(workbench().score.drawn(), on);
        }
    }

    void chooseReferences(QWidget& dialog) {
        QVERIFY(scored());
        QCOMPARE(workbench().score.take(), take(0).id);
        QCOMPARE(workbench().score.scores().size(), std::size_t{2});
        dialog.findChild<QComboBox*>("scoreReference")->setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Home);
        QVERIFY(driver_->waitFor([&] { return scored() && workbench().score.scores().size() == 1; }));
        QVERIFY(textOf(dialog, "verdict_duration_s").isEmpty() && textOf(dialog, "reference_duration_s").isEmpty());
        QVERIFY(!textOf(dialog, "score_duration_s").isEmpty());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_End);
        QVERIFY(driver_->waitFor([&] { return scored() && workbench().score.reference() == take(1).id; }));
    }

    Workbench& workbench() { return driver_->window().workbench(); }
    TimeController& time() { return workbench().time; }
    const TakeInfo& take(std::size_t place) { return workbench().mill.allTakes()[place]; }
    static double seconds(const TakeInfo& take) { return static_cast<double>(take.sampleCount) * take.tickPeriod; }
    bool scored() {
        return driver_->waitFor([&] { return !workbench().score.busy() && !workbench().score.scores().empty(); });
    }
    std::unique_ptr<WindowDriver> driver_;
};

BURIN_TEST(TestWindowScore, QApplication)

} // namespace burin::tst_window_score

#include "tst_window_score.moc"
