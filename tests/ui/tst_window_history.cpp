// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Undo and redo across everything that changes a project, by keys; states are compared by the rows of the project.
#include "core/document/setup_record.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/document/project_rows.h"
#include "tests/core/geometry/shapes.h"
#include "tests/long_run.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QScrollArea>
#include <QUndoView>
#include <QtTest>

#include <map>
#include <random>

namespace burin::tst_window_history {

using namespace burin::testing;

namespace {

/// What a user has before him.
struct Seen {
    std::vector<std::string> rows; ///< of the project
    std::string setup;             ///< as shown, also if it is not stored
    std::vector<std::string> values;
    std::uint64_t workpiece = 0; ///< 0: none

    static std::string differenceOf(const Seen& expected, const Seen& now) {
        std::string text = fixture::difference(expected.rows, now.rows);
        text += fixture::difference(expected.values, now.values);
        if (expected.setup != now.setup) text += "\n" + expected.setup + "\n" + now.setup;
        if (expected.workpiece != 0 && expected.workpiece != now.workpiece) text += "\nanother workpiece";
        return text;
    }
    /// Without what a recording leaves on the disk although it does not count any more, and the tool that it milled
    /// with.
    Seen withoutRecording() const {
        Seen less = *this;
        std::erase_if(less.rows, [](const std::string& row) {
            return row.starts_with("take") || row.starts_with("sample_chunk") || row.starts_with("undone_stretch") ||
                   row.starts_with("tool");
        });
        return less;
    }
};

QString writePart(const WindowDriver& driver, const char* name, const glm::dvec3& size) {
    QFile file(driver.folder().filePath(name));
    if (file.open(QIODevice::WriteOnly)) file.write(stlText(shapes::box(glm::dvec3(0.0), size), name));
    return file.fileName();
}

} // namespace

class TestWindowHistory : public QObject {
    Q_OBJECT
private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        driver_->key(Qt::Key_N, Qt::ControlModifier);
        QVERIFY(driver_->waitFor([&] { return workbench().document.isOpen(); }) && settled());
    }
    void cleanup() { driver_.reset(); }

    /// Import, stock, workpiece, recording, a second setup, a fixture there: back to the empty project and forth again.
    void aJobIsUndoneAndRedone() {
        std::map<int, Seen> states;
        const auto note = [&] { states[history().index()] = seen(); };
        note();
        QVERIFY(makeReady(*driver_, 1.0) && settled());
        note();
        const int beforeMilling = history().index();
        QVERIFY(recordLine(*driver_, {-15, 0}, {15, 0}) && settled());
        QVERIFY(history().index() > beforeMilling);
        note();
        const double removed = removedSoFar(*workbench().workpiece.milling());
        QVERIFY(removed > 10.0);
        QVERIFY(addSetup(QStringLiteral("Underside")));
        note();
        QVERIFY(driver_->step(JobStep::stock) && scrollTo("stockPage", "addObstacleButton"));
        QVERIFY(driver_->clickOn("addObstacleButton") && settled());
        QCOMPARE(workbench().surroundings.obstacles().size(), std::size_t{1});
        note();
        const int end = history().index();
        driver_->key(Qt::Key_H, Qt::ControlModifier);
        driver_->shoot("history-1-all-done");

        bool told = false;
        for (int at = end; at-- > 0;) {
            driver_->key(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(settled());
            QCOMPARE(history().index(), at);
            told = told || driver_->message().contains(QStringLiteral("Setup 1"));
            if (!states.contains(at)) continue;
            const std::string other =
                at > beforeMilling ? Seen::differenceOf(states[at], seen())
                                   : Seen::differenceOf(states[at].withoutRecording(), seen().withoutRecording());
            QVERIFY2(other.empty(), qPrintable(QString::number(at) + QString::fromStdString(other)));
            if (at <= beforeMilling) QVERIFY(workbench().mill.takes().empty() && !workbench().setup.locked());
        }
        QVERIFY(told && !history().canUndo());
        QVERIFY(workbench().model.model() == nullptr);
        driver_->shoot("history-2-all-undone");
        for (int at = 1; at <= end; ++at) {
            driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(settled());
            QCOMPARE(history().index(), at);
            if (!states.contains(at)) continue;
            const std::string other =
                at > beforeMilling ? Seen::differenceOf(states[at], seen())
                                   : Seen::differenceOf(states[at].withoutRecording(), seen().withoutRecording());
            QVERIFY2(other.empty(), qPrintable(QString::number(at) + QString::fromStdString(other)));
        }
        QVERIFY(!history().canRedo());
        driver_->key(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(settled());
        QVERIFY(std::abs(removedSoFar(*workbench().workpiece.milling()) - removed) < 1e-6);
    }

    /// Random changes of all kinds. Each state on the way back and forth equals the one on the way there.
    void randomStepsAreUndoneAndRedone_data() {
        QTest::addColumn<unsigned>("seed");
        const unsigned most = inLongRun(12U, 1U);
        for (unsigned seed = 1; seed <= most; ++seed) QTest::newRow(qPrintable(QString::number(seed))) << seed;
    }
    void randomStepsAreUndoneAndRedone() {
        QFETCH(unsigned, seed);
        random_.seed(seed);
        parts_ = {writePart(*driver_, "block.stl", {40, 30, 20}), writePart(*driver_, "slab.stl", {30, 30, 10})};
        std::vector<Seen> states{seen()};
        workbench().importPart(parts_[0].toStdString(), false);
        QVERIFY(settled());
        for (int step = 0; step < inLongRun(24, 5); ++step) {
            QCOMPARE(static_cast<int>(states.size()), history().index());
            states.push_back(seen());
            for (int tries = 0; history().index() < static_cast<int>(states.size()) && tries < 20; ++tries) {
                changeSomething();
                QVERIFY(settled());
                states.back() = history().index() < static_cast<int>(states.size()) ? seen() : states.back();
            }
        }
        states.push_back(seen());
        for (int at = static_cast<int>(states.size()) - 1; at-- > 0;) {
            const QString what = history().undoText();
            driver_->key(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(settled());
            compare(states, at, what);
            if (QTest::currentTestFailed()) return;
        }
        for (int at = 1; at < static_cast<int>(states.size()); ++at) {
            const QString what = history().redoText();
            driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(settled());
            compareRows(states, at, what);
            if (QTest::currentTestFailed()) return;
        }
        history().setIndex(0); // as by a click in the list
        QVERIFY(settled());
        compare(states, 0, QStringLiteral("list"));
        history().setIndex(history().count());
        QVERIFY(settled());
        compareRows(states, history().count(), QStringLiteral("list"));
    }

    /// Keys pressed faster than a step takes are followed in order.
    void quickKeysAreFollowed() {
        drop(driver_->window(), writeBlock(*driver_));
        QVERIFY(driver_->waitFor([&] { return workbench().setup.hasPart(); }) && settled());
        const Seen first = seen();
        for (const char* name : {"Second", "Third"}) {
            workbench().setups.add(QLatin1String(name), {}, false);
            QVERIFY(settled());
        }
        QCOMPARE(workbench().setups.setups().size(), std::size_t{3});
        const Seen last = seen();
        for (int i = 0; i < 2; ++i) driver_->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled());
        QCOMPARE(Seen::differenceOf(first, seen()), std::string());
        for (int i = 0; i < 2; ++i) driver_->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(settled());
        QCOMPARE(Seen::differenceOf(last, seen()), std::string());
    }

private:
    Workbench& workbench() { return driver_->window().workbench(); }
    History& history() { return workbench().undo(); }

    /// Until everything that was requested is done, also on the disk.
    bool settled() {
        for (int round = 0; round < 4; ++round) {
            bool stored = false;
            workbench().mill.refreshTakes([&stored] { stored = true; });
            if (!driver_->waitFor([&] { return stored && !history().busy() && !workbench().setups.adding(); }) ||
                !driver_->settle())
                return false;
        }
        return true;
    }

    Seen seen() {
        Workbench& w = workbench();
        Seen now;
        now.rows = fixture::rowsOf(w.document.file());
        if (w.setup.hasPart()) now.setup = toJson(w.setup.setup()).value();
        now.values = {"setup " + std::to_string(numberOf(w.setups.used())),
                      "setups " + std::to_string(w.setups.setups().size()),
                      "tool " + w.tool.current().id,
                      "allowance " + std::to_string(w.mill.allowance()),
                      "machine " + w.target.machine().id,
                      "axis " + std::to_string(w.surroundings.wanted().axis.direction.x),
                      "obstacles " + std::to_string(w.surroundings.obstacles().size()),
                      "guides " + std::to_string(w.guides.guides().size()),
                      "area " + std::to_string(w.area.area().rings.size()),
                      "takes " + std::to_string(w.mill.takes().size())};
        if (w.workpiece.embedded()) now.workpiece = fingerprint(w.workpiece.milling()->embedded.workpiece.snapshot());
        return now;
    }

    void compare(const std::vector<Seen>& states, int at, const QString& what) {
        QCOMPARE(history().index(), at);
        const std::string other = Seen::differenceOf(states[static_cast<std::size_t>(at)], seen());
        QVERIFY2(
            other.empty(),
            qPrintable(QString("%1, %2%3 %4").arg(at).arg(what, QString::fromStdString(other), driver_->message())));
    }

    /// The setup in use is that of the step, even if another one was used after it.
    void compareRows(const std::vector<Seen>& states, int at, const QString& what) {
        QCOMPARE(history().index(), at);
        const std::string other = fixture::difference(states[static_cast<std::size_t>(at)].rows, seen().rows);
        QVERIFY2(
            other.empty(),
            qPrintable(QString("%1, %2%3 %4").arg(at).arg(what, QString::fromStdString(other), driver_->message())));
    }

    bool scrollTo(const char* page, const char* name) {
        auto* area = driver_->visible<QScrollArea>(page);
        auto* widget = driver_->window().findChild<QWidget*>(QLatin1String(name));
        if (area == nullptr || widget == nullptr) return false;
        area->ensureWidgetVisible(widget);
        QCoreApplication::processEvents();
        return true;
    }

    bool addSetup(const QString& name) {
        const std::size_t before = workbench().setups.setups().size();
        driver_->whenDialogStands([name](QWidget& dialog) {
            if (auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("setupNameField"))) field->setText(name);
            answer(dialog, "confirmButton");
        });
        driver_->key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        return driver_->waitFor([&] { return workbench().setups.setups().size() == before + 1; }) && settled();
    }

    int pick(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most)); }

    /// One change, or none where it is not possible now.
    void changeSomething() {
        Workbench& w = workbench();
        Setup setup = w.setup.setup();
        switch (pick(18)) {
        case 0:
            if (!w.importNeedsNewProject())
                w.importPart(parts_[static_cast<std::size_t>(pick(2))].toStdString(), false);
            break;
        case 1:
            w.updatePart(parts_[static_cast<std::size_t>(pick(2))].toStdString());
            break;
        case 2:
            setup.voxel = pick(5) == 0 ? 1e-5 : 1.0 + pick(3); // the first can't be embedded and is not stored
            w.setup.edit(setup);
            break;
        case 3:
            setup.marginHigh.z = 1.0 + pick(9);
            w.setup.edit(setup);
            break;
        case 4:
            w.setup.chooseStockMaterial(w.setup.materials()[static_cast<std::size_t>(pick(5))].id);
            break;
        case 5:
            w.setup.chooseRole(0, pick(2) == 0 ? BodyRole::part : BodyRole::protectedInsert);
            break;
        case 6: {
            ProgramZero zero = setup.zero;
            zero.workOffset = 54 + pick(3);
            w.setup.chooseZero(zero);
            break;
        }
        case 7:
            w.setups.add(QStringLiteral("setup"), {}, false);
            break;
        case 8: {
            const auto& setups = w.setups.setups(); // no step of its own, but those before belong to another setup then
            w.setups.use(setups[static_cast<std::size_t>(pick(static_cast<int>(setups.size())))].id);
            break;
        }
        case 9:
            w.setups.remove();
            break;
        case 10:
            w.setups.rename(QString::number(pick(100)));
            break;
        case 11:
            w.surroundings.addBox(ObstacleKind::fixture);
            break;
        case 12:
            w.surroundings.setAxis({false, glm::dvec3(pick(3), 0.0, 1.0)});
            break;
        case 13:
            w.target.chooseMachine(
                w.target.machines()[static_cast<std::size_t>(pick(static_cast<int>(w.target.machines().size())))].id);
            break;
        case 14:
            w.tool.choose(w.tool.tools()[static_cast<std::size_t>(pick(6))].id);
            break;
        case 15:
            w.guides.add(GuideKind::plane);
            break;
        case 16:
            w.model.mirror(pick(3));
            break;
        case 17:
            w.ensureWorkpiece(); // no step either
            break;
        }
    }

    std::unique_ptr<WindowDriver> driver_;
    std::mt19937 random_{1};
    std::vector<QString> parts_;
};

BURIN_TEST(TestWindowHistory, QApplication)

} // namespace burin::tst_window_history

#include "tst_window_history.moc"
