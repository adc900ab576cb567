// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/coach.h"

#include "ui/coach/target_outline.h"
#include "ui/panels/panel_layout.h"
#include "ui/workbench/workbench.h"

#include <QApplication>
#include <QEvent>
#include <QListWidget>

namespace burin {

Coach::Coach(QWidget& window, Workbench& workbench, const Actions& actions)
    : window_(window), workbench_(workbench), actions_(actions), job_(workbench), panel_(new CoachPanel(&window)) {
    connect(&job_, &FirstJob::stepChanged, this, [this] {
        followSoon();
        if (job_.finished()) emit finished();
    });
    connect(&job_, &FirstJob::lookedAt, this, &Coach::followSoon);
    connect(panel_, &CoachPanel::backRequested, &job_, &FirstJob::back);
    connect(panel_, &CoachPanel::skipRequested, &job_, &FirstJob::skip);
    connect(panel_, &CoachPanel::endRequested, this, &Coach::end);
}

Coach::~Coach() {
    delete outline_;
    delete panel_;
}

void Coach::begin() {
    pointed_ = {};
    said_ = {};
    if (!running()) QCoreApplication::instance()->installEventFilter(this);
    job_.begin();
    panel_->show();
    follow();
    takeKeyboard();
}

void Coach::end() {
    if (!running()) return;
    QCoreApplication::instance()->removeEventFilter(this);
    if (hasKeyboard()) place().setFocus();
    job_.end();
    pointed_ = {};
    panel_->hide();
    delete outline_;
}

bool Coach::hasKeyboard() const {
    const QWidget* focus = QApplication::focusWidget();
    return running() && focus != nullptr && (focus == panel_ || panel_->isAncestorOf(focus));
}

void Coach::takeKeyboard() {
    panel_->setFocus(Qt::OtherFocusReason);
}

void Coach::setUnit(LengthUnit unit) {
    unit_ = unit;
    followSoon();
}

/// Any widget that moves, appears or disappears may be the target or contain it.
bool Coach::eventFilter(QObject* watched, QEvent* event) {
    if (!watched->isWidgetType() || watched == panel_ || watched == outline_) return false;
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
        followSoon();
        break;
    case QEvent::EnabledChange:
    case QEvent::ToolTipChange:
        if (watched == pointed_.widget) followSoon();
        break;
    case QEvent::Paint: // scrolling a list moves no widget
        if (watched == pointed_.widget && !job_.finished() && firstJobSteps()[job_.at()].row != nullptr) followSoon();
        break;
    default:
        break;
    }
    return false;
}

void Coach::followSoon() {
    if (!running() || std::exchange(due_, true)) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            due_ = false;
            follow();
        },
        Qt::QueuedConnection);
}

void Coach::follow() {
    if (!running()) return;
    point();
    if (const CoachState next = state(); next != said_) {
        said_ = next;
        panel_->setState(next);
    }
    const QWidget& under = place();
    panel_->placeIn({under.mapTo(&window_, QPoint(0, 0)), under.size()}, pointed_.rectIn(window_));
    panel_->raise();
    if (!outline_) outline_ = new TargetOutline(&window_);
    outline_->surround(pointed_, *panel_);
}

void Coach::point() {
    const bool nothing = job_.finished() || busy();
    const Pointed next = nothing ? Pointed{} : pointAt(window_, firstJobSteps()[job_.at()], workbench_);
    const bool other = next.widget != pointed_.widget || job_.at() != pointedFor_;
    pointed_ = next;
    pointedFor_ = job_.at();
    if (!other || !next.widget) return;
    // Only once, so that the user may scroll it away again.
    bringIntoView(next.widget);
    const FirstJobStep& step = firstJobSteps()[job_.at()];
    if (auto* list = qobject_cast<QListWidget*>(next.widget->parentWidget()); list != nullptr && step.row != nullptr)
        if (QListWidgetItem* item = list->item(step.row(workbench_))) list->scrollToItem(item);
}

/// Whether the work that the user started is still running; the next step has to wait for it.
bool Coach::busy() const {
    return workbench_.model.importing() || workbench_.workpiece.embedding() || workbench_.path.busy() ||
           workbench_.program.busy();
}

QString Coach::keyOf(ActionId id) const {
    const QKeySequence keys = actions_[id]->shortcut();
    return keys.isEmpty() ? QString() : tr("Key: %1").arg(keys.toString(QKeySequence::NativeText));
}

QString Coach::note() const {
    if (busy()) return tr("Wait until Burin has done this.");
    if (!pointed_.way.isEmpty()) return pointed_.way;
    if (pointed_.widget && !pointed_.widget->isEnabled()) return pointed_.widget->toolTip(); // the reason
    if (workbench_.program.refused() && firstJobSteps()[job_.at()].key == ActionId::post)
        return tr(
            "The check refused the program: its findings say why. Delete your edit or mill anew, then post again.");
    return {};
}

CoachState Coach::state() const {
    if (!job_.finished()) return stateOf(firstJobSteps()[job_.at()]);
    CoachState state;
    state.title = tr("Your first job is done");
    state.text = tr("You milled by hand, and the machine can repeat it. The help has more on every step.");
    state.key = keyOf(ActionId::help);
    return state;
}

CoachState Coach::stateOf(const FirstJobStep& step) const {
    CoachState state;
    state.number = static_cast<int>(job_.at()) + 1;
    state.steps = static_cast<int>(firstJobSteps().size());
    state.title = titleOf(step);
    state.text = textOf(step, workbench_, unit_);
    if (step.key) state.key = keyOf(*step.key);
    state.done = job_.isDone();
    state.note = state.done && pointed_.way.isEmpty() ? tr("You have done this step.") : note();
    return state;
}

/// Returns the area for the coach panel: the view, or the whole page if there is no view. Other panels stay uncovered.
QWidget& Coach::place() const {
    for (const char* name : {"viewport", "pages"}) {
        auto* widget = window_.findChild<QWidget*>(QLatin1String(name));
        if (widget != nullptr && widget->isVisible()) return *widget;
    }
    return window_;
}

} // namespace burin
