// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_text.h"

#include "ui/panels/buttons.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/panel_layout.h"
#include "ui/theme/number_font.h"

#include <QAction>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <QToolTip>

#include <chrono>

namespace burin {

ProgramText::ProgramText(QWidget* parent)
    : QWidget(parent)
    , bar_(new QHBoxLayout)
    , wanted_(new QLineEdit(this))
    , edit_(
          makeIconButton(QStringLiteral("edit"), tr("Edit the program's text"), QStringLiteral("editTextButton"), this))
    , previous_(makeIconButton(QStringLiteral("previous"), tr("Previous match (Shift+Enter)"),
                               QStringLiteral("searchPreviousButton"), this))
    , next_(makeIconButton(QStringLiteral("next"), tr("Next match (Enter)"), QStringLiteral("searchNextButton"), this))
    , found_(new QLabel(this))
    , state_(makeWrappedLabel(this))
    , view_(new ProgramView(this)) {
    wanted_->setObjectName(QStringLiteral("programSearch"));
    wanted_->setPlaceholderText(tr("Find in the program"));
    wanted_->setAccessibleName(wanted_->placeholderText());
    wanted_->setToolTip(
        tr("Text to find, upper or lower case; Enter goes to the next match, Shift+Enter to the previous one"));
    wanted_->setClearButtonEnabled(true);
    found_->setObjectName(QStringLiteral("searchFound"));
    found_->setProperty("look", "small");
    state_->setObjectName(QStringLiteral("programState"));
    state_->setProperty("look", "small");
    state_->setFont(numberFont(state_->font()));
    view_->setObjectName(QStringLiteral("programText"));
    view_->setAccessibleName(tr("Text of the program"));
    view_->setMinimumHeight(160);

    bar_->setSpacing(4);
    edit_->setCheckable(true);
    bar_->addWidget(edit_);
    bar_->addWidget(wanted_, 1);
    bar_->addWidget(found_);
    bar_->addWidget(previous_);
    bar_->addWidget(next_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(bar_);
    column->addWidget(view_, 1);
    column->addWidget(state_);

    wanted_->installEventFilter(this);
    connect(wanted_, &QLineEdit::textChanged, this, &ProgramText::told);
    connect(next_, &QToolButton::clicked, this, [this] { search(false); });
    connect(previous_, &QToolButton::clicked, this, [this] { search(true); });
    connect(view_, &ProgramView::lineChosen, this, &ProgramText::lineChosen);
    connect(view_, &ProgramView::breakpointToggled, this, &ProgramText::breakpointToggled);
    connect(view_, &ProgramView::typedWhileLocked, this, &ProgramText::hintAtEditing);
    settled_.setSingleShot(true);
    settled_.setInterval(std::chrono::milliseconds(400));
    connect(edit_, &QToolButton::toggled, this, [this](bool editable) {
        view_->setEditable(editable);
        if (editable) view_->setFocus();
    });
    connect(view_, &ProgramView::edited, &settled_, qOverload<>(&QTimer::start));
    connect(&settled_, &QTimer::timeout, this, &ProgramText::tell);
    showState({});
    told();
}

void ProgramText::offer(QAction& action) {
    QToolButton* button =
        makeIconButton(QStringLiteral("dock"), action.toolTip(), QStringLiteral("moveTextButton"), this);
    button->setProperty("look", "toggle");
    button->setCheckable(true);
    button->setChecked(action.isChecked());
    bar_->addWidget(button);
    connect(&action, &QAction::toggled, button, &QToolButton::setChecked);
    connect(button, &QToolButton::clicked, &action, &QAction::trigger);
}

/// Responds to a key that was meant as text input but changed nothing.
void ProgramText::hintAtEditing() {
    QToolTip::showText(edit_->mapToGlobal(edit_->rect().bottomLeft()),
                       tr("The text can't be changed yet: press this button to edit it"), edit_);
}

bool ProgramText::editable() const {
    return edit_->isChecked();
}

bool ProgramText::eventFilter(QObject* watched, QEvent* event) {
    if (watched != wanted_ || (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride))
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride) { // this field handles Esc before the window does
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) event->accept();
        return QWidget::eventFilter(watched, event);
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
        search((key->modifiers() & Qt::ShiftModifier) != 0);
        return true;
    }
    if (key->key() == Qt::Key_Escape) {
        view_->setFocus();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ProgramText::showProgram(const QString& text) {
    if (settled_.isActive()) return; // the text being typed is newer
    view_->showProgram(text);
    told();
}

void ProgramText::tellNow() {
    if (!settled_.isActive()) return;
    settled_.stop();
    tell();
}

void ProgramText::tell() {
    told();
    emit textEdited(view_->program());
}

int ProgramText::line() const {
    return view_->line();
}

void ProgramText::setBreakpoints(const std::set<int>& lines) {
    view_->setBreakpoints(lines);
}

void ProgramText::showLine(int line) {
    view_->showLine(line);
}

void ProgramText::setMarks(std::vector<LineMark> marks) {
    view_->setMarks(std::move(marks));
}

void ProgramText::showState(const QString& state) {
    setWrappedText(state_, state);
    state_->setVisible(!state.isEmpty());
}

void ProgramText::startSearch() {
    wanted_->setFocus(Qt::ShortcutFocusReason);
    wanted_->selectAll();
}

void ProgramText::search(bool backward) {
    view_->find(wanted_->text(), backward);
}

void ProgramText::told() {
    const bool wanted = !wanted_->text().isEmpty();
    const auto count = view_->occurrences(wanted_->text());
    found_->setText(!wanted ? QString() : count == 0 ? tr("none") : QLocale().toString(count));
    found_->setToolTip(tr("Number of matches"));
    setEnabledKeepingFocus(previous_, count > 0);
    setEnabledKeepingFocus(next_, count > 0);
}

} // namespace burin
