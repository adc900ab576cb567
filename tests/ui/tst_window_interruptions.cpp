// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Interruptions while a stroke is drawn or cut: Esc, undo, another step, a dialog, another program.
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QLabel>
#include <QtTest>

#include <initializer_list>
#include <utility>

namespace burin::tst_window_interruptions {

using namespace burin::testing;

namespace {

/// What the user is doing when interrupted.
enum class Middle { stroke, line, rectangle, rows, repetition, spindle };

} // namespace

class TestWindowInterruptions : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        driver_ = std::make_unique<WindowDriver>();
        QVERIFY(makeReady(*driver_, 1.0));
        viewport().setStandardView(StandardView::top);
        QTest::qWait(400); // the view turns
    }
    /// All tests share a window; each starts with nothing cut.
    void init() {
        QVERIFY(driver_->step(JobStep::mill));
        for (std::size_t left = workbench().workpiece.strokes().count(); left > 0; --left) {
            driver_->key(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(strokesAre(left - 1));
        }
        QVERIFY(driver_->clickOn("strokeButton") && driver_->enter("speedField", "200"));
        if (!workbench().mill.active()) QVERIFY(driver_->clickOn("millButton"));
        QVERIFY(driver_->waitFor([&] { return workbench().mill.active(); }));
        millLine(*driver_, {-12, -9}, {12, -9}); // so that there is a stroke to continue from
        QVERIFY(strokesAre(1));
        QVERIFY(driver_->enter("speedField", "15")); // so that cutting without the pointer takes some time
        viewport().setFocus();
    }
    void cleanup() { letGo(); }
    void cleanupTestCase() { driver_.reset(); }

    /// Esc ends or cancels only what is under way; the tool is then free for the next stroke.
    void escapeEndsWhatIsUnderWay_data() {
        addMiddles({Middle::stroke, Middle::line},
                   {Middle::rows, Middle::rectangle, Middle::repetition, Middle::spindle});
    }
    void escapeEndsWhatIsUnderWay() {
        QFETCH(Middle, middle);
        begin(middle);
        const QString meaning = escapeLabel();
        QVERIFY2(!meaning.isEmpty() && !meaning.contains(QStringLiteral("stop milling")), qPrintable(meaning));
        driver_->shoot(QStringLiteral("interrupted-%1").arg(QTest::currentDataTag()));
        driver_->key(Qt::Key_Escape);
        QVERIFY(driver_->waitFor([&] { return !cutting() && escapeLabel().contains(QStringLiteral("stop milling")); }));
        letGo();
        QTest::qWait(300);
        QVERIFY(!cutting() && workbench().mill.active());
        const std::size_t before = workbench().workpiece.strokes().count();
        QCOMPARE(before, isCut(middle) ? std::size_t{2} : std::size_t{1});
        QVERIFY(driver_->enter("speedField", "200"));
        millLine(*driver_, {-12, 9}, {12, 9});
        QVERIFY(strokesAre(before + 1));
    }

    /// While the tool cuts, undo has to wait; what is not yet cut is cancelled together with the stroke that it belongs
    /// to.
    void undoNeverTakesBackSomethingElse_data() { addMiddles({Middle::rows}, {Middle::line}); }
    void undoNeverTakesBackSomethingElse() {
        QFETCH(Middle, middle);
        begin(middle);
        const double removed = removedSoFar(*workbench().workpiece.milling());
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QTest::qWait(300);
        QVERIFY(workbench().mill.active());
        if (!isCut(middle)) { // the stroke before is undone, as always
            QVERIFY(strokesAre(0));
            letGo();
            QVERIFY(driver_->waitFor([&] { return !cutting() && !escapeLabel().contains("stop the tool"); }));
            return;
        }
        QVERIFY(cutting());
        QVERIFY(!driver_->visible<QWidget>("undoStrokeButton")->isEnabled()); // and the button shows that
        driver_->key(Qt::Key_Escape);
        letGo();
        QVERIFY(strokesAre(2)); // both strokes are kept
        QVERIFY(driver_->waitFor([&] { return !cutting(); }));
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(strokesAre(1));
        driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(strokesAre(0));
        QVERIFY(removedSoFar(*workbench().workpiece.milling()) < removed);
    }

    /// By its key, while the left button is down: the tool is parked, what was cut is kept.
    void anotherStepEndsMilling_data() { addMiddles({Middle::rows}, {Middle::stroke}); }
    void anotherStepEndsMilling() {
        QFETCH(Middle, middle);
        begin(middle);
        QVERIFY(driver_->step(JobStep::tool));
        QVERIFY(driver_->waitFor([&] { return !workbench().session.running(); }));
        letGo();
        QVERIFY(!workbench().mill.active());
        QVERIFY(strokesAre(isCut(middle) ? 2 : 1));
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at({0, 5}));
        QTest::mouseMove(&viewport(), at({8, 5}), 50);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at({8, 5}));
        QTest::qWait(200);
        QVERIFY(!workbench().session.running());
        driver_->shoot(QStringLiteral("interrupted-step-%1").arg(QTest::currentDataTag()));
    }

    /// A dialog opens and receives the release: once it is closed, nothing continues with the pointer.
    void aDialogEndsWhatThePointerDraws_data() { addMiddles({Middle::rectangle}, {Middle::stroke, Middle::spindle}); }
    void aDialogEndsWhatThePointerDraws() {
        QFETCH(Middle, middle);
        begin(middle);
        bool stood = false;
        driver_->whenDialogStands([&](QWidget& dialog) {
            stood = true;
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        driver_->key(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return stood; }));
        movePointer(at({14, 11}), Qt::NoButton); // the button was released over the dialog
        QTest::qWait(100);
        const QString meaning = escapeLabel();
        movePointer(at({-14, 11}), Qt::NoButton);
        QVERIFY(driver_->waitFor([&] { return !cutting() || middle == Middle::spindle; }));
        if (cutting()) driver_->key(Qt::Key_Escape); // the spindle, which no mouse button keeps turning
        letGo();
        QVERIFY2(!meaning.contains(QStringLiteral("cancel")), qPrintable(meaning));
        QVERIFY(strokesAre(isCut(middle) ? 2 : 1));
        QVERIFY(driver_->enter("speedField", "200"));
        millLine(*driver_, {-12, 9}, {12, 9});
        QVERIFY(strokesAre(isCut(middle) ? 3 : 2));
    }

private:
    /// @param rest  in the long run
    static void addMiddles(std::initializer_list<Middle> usual, std::initializer_list<Middle> rest) {
        QTest::addColumn<Middle>("middle");
        for (const Middle middle : usual) QTest::newRow(nameOf(middle)) << middle;
        for (const Middle middle : rest)
            if (longRun()) QTest::newRow(nameOf(middle)) << middle;
    }
    static const char* nameOf(Middle middle) {
        switch (middle) {
        case Middle::stroke:
            return "stroke";
        case Middle::line:
            return "line";
        case Middle::rectangle:
            return "rectangle";
        case Middle::rows:
            return "rows";
        case Middle::repetition:
            return "repetition";
        case Middle::spindle:
            break;
        }
        return "spindle";
    }
    static bool isCut(Middle middle) { return middle != Middle::line && middle != Middle::rectangle; }

    void begin(Middle middle) {
        switch (middle) {
        case Middle::stroke:
            press(at({-10, -2}), Qt::NoModifier);
            for (int i = 1; i <= 10; ++i) QTest::mouseMove(&viewport(), at({-10 + 2 * i, -2 + 0.5 * i}), 10);
            break;
        case Middle::line:
            press(at({-8, 4}), Qt::ShiftModifier);
            break;
        case Middle::rectangle:
        case Middle::rows:
            QVERIFY(driver_->enter("speedField", "5")); // so that no row is the last one on a busy machine
            viewport().setFocus();
            driver_->key(Qt::Key_T);
            press(at({-12, -4}), Qt::NoModifier);
            for (int i = 1; i <= 10; ++i) QTest::mouseMove(&viewport(), at({-12 + 2.4 * i, -4 + 0.9 * i}), 10);
            if (middle == Middle::rows) letGo();
            break;
        case Middle::repetition:
            QTest::mouseMove(&viewport(), at({0, 0}));
            driver_->key(Qt::Key_L);
            break;
        case Middle::spindle:
            QTest::mouseMove(&viewport(), at({0, 0}));
            QTest::qWait(800); // for the tool to get there
            driver_->key(Qt::Key_Space);
            break;
        }
        if (isCut(middle)) QVERIFY(driver_->waitFor([&] { return cutting(); }, 8000));
        QTest::qWait(200);
    }
    void press(const QPoint& pixel, Qt::KeyboardModifiers modifiers) {
        QTest::mouseMove(&viewport(), pixel);
        QTest::qWait(300);
        QTest::mousePress(&viewport(), Qt::LeftButton, modifiers, pixel);
        held_ = true;
    }
    void letGo() {
        if (std::exchange(held_, false))
            QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, viewport().mapFromGlobal(QCursor::pos()));
    }
    void movePointer(const QPoint& pixel, Qt::MouseButtons buttons) {
        QMouseEvent move(QEvent::MouseMove, pixel, viewport().mapToGlobal(pixel), Qt::NoButton, buttons, {});
        QCoreApplication::sendEvent(&viewport(), &move);
    }
    Workbench& workbench() { return driver_->window().workbench(); }
    Viewport& viewport() { return driver_->window().viewport(); }
    QPoint at(const glm::dvec2& place) {
        return viewport().project(workbench().setup.setup().workOffset + glm::dvec3(place, 0.0)).toPoint();
    }
    bool cutting() { return workbench().session.running() && workbench().session.state().cutting; }
    bool strokesAre(std::size_t count) {
        return driver_->waitFor([&] { return workbench().workpiece.strokes().count() == count; }, 15000);
    }
    QString escapeLabel() {
        auto* label = driver_->visible<QLabel>("escapeStatus");
        return label != nullptr ? label->text() : QString();
    }

    std::unique_ptr<WindowDriver> driver_;
    bool held_ = false;
};

BURIN_TEST(TestWindowInterruptions, QApplication)

} // namespace burin::tst_window_interruptions

#include "tst_window_interruptions.moc"
