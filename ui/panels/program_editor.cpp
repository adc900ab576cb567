// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_editor.h"

#include "core/verify/findings.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/program_text.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"

#include <QBoxLayout>

#include <algorithm>
#include <span>

namespace burin {

namespace {

constexpr int rowsInPanel = 5;
constexpr int heightInPanel = 400, dockMargin = 8; // pixels

} // namespace

ProgramEditor::ProgramEditor(QWidget* parent)
    : QWidget(parent)
    , parts_(new QBoxLayout(QBoxLayout::TopToBottom, this))
    , side_(new QWidget(this))
    , findings_(new RowList(side_))
    , checkText_(makePrimaryButton(tr("Check the edited text"), QStringLiteral("checkTextButton"), side_))
    , text_(new ProgramText(this)) {
    setObjectName(QStringLiteral("programEditor"));
    findings_->setTextsWrap(true);
    findings_->setMaximumRows(rowsInPanel);
    findings_->setObjectName(QStringLiteral("findingList"));
    findings_->setAccessibleName(tr("Findings of the check"));
    auto* column = new QVBoxLayout(side_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(findings_);
    column->addWidget(checkText_, 0, Qt::AlignTop);
    parts_->setSpacing(8);
    parts_->addWidget(text_, 3);
    parts_->addWidget(side_, 2);

    connect(checkText_, &QPushButton::clicked, this, &ProgramEditor::textCheckRequested);
    connect(text_, &ProgramText::textEdited, this, &ProgramEditor::textEdited);
    connect(text_, &ProgramText::lineChosen, this, &ProgramEditor::lineChosen);
    connect(text_, &ProgramText::breakpointToggled, this, &ProgramEditor::breakpointToggled);
    connect(findings_, &RowList::rowChosen, this, [this](int row) {
        if (static_cast<std::size_t>(row) >= marks_.size()) return;
        const int line = marks_[static_cast<std::size_t>(row)].line;
        if (line == 0) return; // the finding refers to the whole program
        text_->showLine(line);
        emit lineChosen(line);
    });
    arrange();
}

void ProgramEditor::offer(QAction& move) {
    text_->offer(move);
}

void ProgramEditor::setDocked(bool docked) {
    docked_ = docked;
    arrange();
}

void ProgramEditor::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

QSize ProgramEditor::sizeHint() const {
    return {QWidget::sizeHint().width(), minimumHeight()};
}

/// Below the text the list is as high as its rows, up to a part of the total height; next to the text it has the
/// available height. In the panel, which scrolls, the total height is the same with and without findings.
void ProgramEditor::arrange() {
    const bool beside = docked_ && width() > height();
    parts_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    const int margin = docked_ ? dockMargin : 0;
    parts_->setContentsMargins(margin, margin, margin, margin);
    setMinimumHeight(docked_ || state_.text.isEmpty() ? 0 : heightInPanel);
    findings_->setFillsHeight(beside);
    const int shared = docked_ ? height() : std::max(heightInPanel, height());
    findings_->setMaximumHeight(beside ? QWIDGETSIZE_MAX : shared * 2 / 5);
    side_->setSizePolicy(QSizePolicy::Preferred, beside ? QSizePolicy::Preferred : QSizePolicy::Maximum);
}

void ProgramEditor::setUnit(LengthUnit unit) {
    unit_ = unit;
    refresh();
}

void ProgramEditor::setState(const ProgramState& state) {
    state_ = state;
    refresh();
}

void ProgramEditor::refresh() {
    gather();
    findings_->setRows(rows());
    findings_->setVisible(!marks_.empty());
    checkText_->setVisible(state_.edited);
    enableUnless(checkText_, state_.busy ? tr("Work is under way.") : QString(),
                 tr("Read the edited text back and mill it again on a fresh workpiece"));
    side_->setVisible(!marks_.empty() || state_.edited);
    text_->showProgram(state_.text);
    text_->setMarks(marks_);
    text_->setVisible(!state_.text.isEmpty());
    arrange();
}

void ProgramEditor::gather() {
    marks_.clear();
    if (state_.report)
        for (const Finding& finding : state_.report->findings)
            marks_.push_back(
                {static_cast<int>(finding.line), LineMark::Kind::error,
                 findingText(finding, unit_) + QStringLiteral("; ") + Messages::text(remedyOf(finding.kind))});
    if (state_.report)
        for (const Finding& warning : state_.report->warnings)
            marks_.push_back({static_cast<int>(warning.line), LineMark::Kind::warning, findingText(warning, unit_)});
    for (const LintMark& mark : state_.lint)
        marks_.push_back({static_cast<int>(mark.line),
                          mark.severity == LintSeverity::error ? LineMark::Kind::error : LineMark::Kind::warning,
                          lintText(mark)});
    if (state_.report) gatherNearPasses(state_.report->nearPasses);
}

/// Sorted with the nearest first.
void ProgramEditor::gatherNearPasses(const std::vector<NearPass>& passes) {
    constexpr std::size_t most = 50;
    for (const NearPass& pass : std::span(passes).first(std::min(passes.size(), most)))
        marks_.push_back({static_cast<int>(pass.line), LineMark::Kind::warning, nearPassText(pass, unit_)});
}

std::size_t ProgramEditor::errors() const {
    return static_cast<std::size_t>(std::ranges::count(marks_, LineMark::Kind::error, &LineMark::kind));
}

std::vector<ListRow> ProgramEditor::rows() const {
    std::vector<ListRow> rows;
    for (const LineMark& mark : marks_) {
        const bool error = mark.kind == LineMark::Kind::error;
        ListRow row;
        row.title = row.toolTip = mark.text;
        row.value = mark.line > 0 ? tr("line %1").arg(mark.line) : tr("program");
        row.icon = error ? QStringLiteral("error") : QStringLiteral("warning");
        row.iconRole = error ? &Palette::force : &Palette::accent;
        rows.push_back(row);
    }
    return rows;
}

int ProgramEditor::line() const {
    return text_->line();
}

void ProgramEditor::setBreakpoints(const std::set<int>& lines) {
    text_->setBreakpoints(lines);
}

void ProgramEditor::showLine(int line) {
    text_->showLine(line);
}

void ProgramEditor::showMachineState(const QString& state) {
    text_->showState(state);
}

void ProgramEditor::startSearch() {
    window()->activateWindow(); // a dock may be a separate window
    text_->startSearch();
}

void ProgramEditor::tellTextNow() {
    text_->tellNow();
}

} // namespace burin
