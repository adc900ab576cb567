// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "ui/workbench/done_command.h"
#include "ui/workbench/history.h"
#include "ui/workbench/value_command.h"

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_history {

/// The order in which undo and redo are carried out, with a window that answers when the test wants it to.
class TestHistory : public QObject {
    Q_OBJECT
private slots:
    void init() {
        project_ = std::make_unique<ProjectThread>();
        history_ = std::make_unique<History>(*project_);
        state_ = {};
        value_ = 0;
        atRest_ = true;
        said_.clear();
        rested_ = nullptr;
        gone_ = nullptr;
        history_->serve(
            {[this] { return state_; }, [this] { return atRest_; },
             [this](std::function<void()> then) { rested_ = std::move(then); },
             [this](std::int64_t take, bool hidden) {
                 said_ << QStringLiteral("%1 take %2").arg(hidden ? "hide" : "show").arg(take);
             },
             [this](const WorkState& to, const std::optional<SharedStep>& step, std::function<void(bool)> then) {
                 said_ << QStringLiteral("%1 to setup %2").arg(step ? "step" : "switch").arg(numberOf(to.setup));
                 gone_ = [this, to, then](bool well) {
                     if (well) state_ = to;
                     then(well);
                 };
             },
             [this] { said_ << QStringLiteral("embed"); }});
    }
    void cleanup() {
        history_.reset();
        project_.reset();
    }

    /// What is requested while a step is under way follows it; new values are refused meanwhile.
    void requestsFollowInOrder() {
        set(1);
        step(SetupId{2});
        set(2);
        history_->undo();
        QCOMPARE(value_, 1);
        history_->undo();
        history_->undo();
        QVERIFY(history_->busy() && value_ == 1);
        QSignalSpy refused(project_.get(), &ProjectThread::failed);
        set(7);
        QCOMPARE(value_, 1);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused.front().front().value<Error>().subject, std::string("7"));
        answer(true);
        QCOMPARE(value_, 0);
        QVERIFY(!history_->busy() && history_->index() == 0 && history_->count() == 3);
        QCOMPARE(said_, QStringList{"step to setup 1"});
        history_->setIndex(3);
        answer(true);
        QCOMPARE(value_, 2);
        QVERIFY(numberOf(state_.setup) == 2);
    }

    /// A change that was made in another setup is undone there.
    void theSetupOfAChangeIsUsedFirst() {
        set(1);
        state_.setup = SetupId{2};
        history_->undo();
        QCOMPARE(said_, QStringList{"switch to setup 1"});
        QCOMPARE(value_, 1);
        answer(true);
        QCOMPARE(value_, 0);
    }

    /// If a step fails, the list stands at the state reached, and what was to follow is not done.
    void aFailureLeavesTheStateReached() {
        set(1);
        step(SetupId{2});
        set(2);
        history_->setIndex(0);
        answer(false);
        QVERIFY(!history_->busy());
        QCOMPARE(history_->index(), 2);
        QCOMPARE(value_, 1);
        history_->redo();
        QCOMPARE(value_, 2);
        history_->setIndex(1);
        answer(true);
        history_->redo();
        answer(false);
        QCOMPARE(history_->index(), 1);
    }

    /// A macro is undone and redone as a whole: if a part of it fails, those before it are made undone again.
    void aMacroFailsAsAWhole() {
        set(1);
        history_->beginMacro(QStringLiteral("macro"));
        step(SetupId{2});
        set(2);
        set(3);
        history_->endMacro();
        history_->undo(); // its values, then the step
        QCOMPARE(value_, 1);
        answer(false);
        QVERIFY(!history_->busy());
        QCOMPARE(history_->index(), 2);
        QCOMPARE(value_, 3);

        history_->undo();
        answer(true);
        QVERIFY(history_->index() == 1 && value_ == 1 && numberOf(state_.setup) == 1);
        history_->redo();
        answer(true);
        QVERIFY(history_->index() == 2 && value_ == 3 && numberOf(state_.setup) == 2);
    }

    void aMacroThatIsRedoneFailsAsAWhole() {
        set(1);
        history_->beginMacro(QStringLiteral("macro"));
        set(2);
        step(SetupId{2});
        history_->endMacro();
        history_->undo();
        answer(true);
        QVERIFY(history_->index() == 1 && value_ == 1);
        for (int i = 0; i < 2; ++i) { // again after a failure
            history_->redo();
            QCOMPARE(value_, 2);
            answer(false);
            QVERIFY(!history_->busy());
            QVERIFY(history_->index() == 1 && value_ == 1 && numberOf(state_.setup) == 1);
        }
        history_->redo();
        answer(true);
        QVERIFY(history_->index() == 2 && value_ == 2 && numberOf(state_.setup) == 2);
    }

    /// A take is hidden before what was done earlier than its first stroke is undone, and shown before that is redone.
    void aRecordingIsHiddenOnlyWhenNeeded() {
        set(1);
        stroke(5);
        stroke(5);
        for (int i = 0; i < 2; ++i) history_->undo();
        QVERIFY(said_.isEmpty());
        history_->undo();
        QCOMPARE(said_, QStringList{"hide take 5"});
        history_->redo();
        QCOMPARE(said_.size(), 1);
        history_->redo();
        QCOMPARE(said_, (QStringList{"hide take 5", "show take 5"}));
    }

    /// A stroke that ends while the session is being ended stays, and what it stands on is not undone.
    void aStrokeThatEndsMeanwhileComesFirst() {
        atRest_ = false;
        history_->pushForming(command(1));
        history_->undo();
        QVERIFY(history_->busy());
        stroke(5);
        QVERIFY(!history_->busy());
        QCOMPARE(history_->index(), 2);
        rested_();
        QCOMPARE(value_, 1);
    }

    /// The workpiece of a state that had one is made again.
    void theWorkpieceComesBack() {
        state_.embedded = true;
        history_->pushForming(command(1));
        state_.embedded = false;
        history_->undo();
        QCOMPARE(said_, QStringList{"embed"});
    }

    void anotherProjectBeginsAnew() {
        step(SetupId{2});
        history_->undo();
        const auto late = gone_;
        history_->clear();
        late(true);
        QVERIFY(!history_->busy() && history_->count() == 0);
    }

private:
    QUndoCommand* command(int value) {
        return new ValueCommand<int>(QString::number(value), -1, value_, value,
                                     [this](const int& set) { value_ = set; });
    }
    void set(int value) { history_->push(command(value)); }
    void step(SetupId setup) {
        const WorkState before = state_;
        state_.setup = setup;
        history_->pushStep(QStringLiteral("step"), {}, before);
    }
    void stroke(std::int64_t take) {
        history_->pushRecorded(new DoneCommand(QStringLiteral("stroke"), [](bool) {}), take);
    }
    void answer(bool well) { std::exchange(gone_, nullptr)(well); }

    std::unique_ptr<ProjectThread> project_;
    std::unique_ptr<History> history_;
    WorkState state_;
    int value_ = 0;
    bool atRest_ = true;
    QStringList said_;
    std::function<void()> rested_;
    std::function<void(bool)> gone_;
};

BURIN_TEST(TestHistory, QCoreApplication)

} // namespace burin::tst_history

#include "tst_history.moc"
