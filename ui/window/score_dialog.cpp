// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/score_dialog.h"

#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/score_labels.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace burin {

namespace {

constexpr int scoreDialogWidth = 660; // pixels

/// @param column title of the label's column; empty: none
QLabel* makeScoreLabel(const char* what, const QString& column, ScoreValue value, QWidget* parent) {
    auto* label = new QLabel(parent);
    const std::string_view key = keyOf(value);
    label->setObjectName(QLatin1String(what) + QLatin1String(key.data(), static_cast<qsizetype>(key.size())));
    label->setToolTip(scoreDefinition(value));
    const QString row = scoreTitle(value);
    label->setAccessibleName(column.isEmpty() ? row : QStringLiteral("%1, %2").arg(row, column));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

} // namespace

ScoreDialog::ScoreDialog(ScoreController& score, const MillController& mill, const TaskRunner& tasks, LengthUnit unit,
                         QWidget* parent)
    : QDialog(parent), score_(score), mill_(mill), unit_(unit) {
    setObjectName(QStringLiteral("scoreDialog"));
    setWindowTitle(tr("Score"));
    layOut();
    resize(scoreDialogWidth, sizeHint().height());
    connect(&score_, &Controller::changed, this, &ScoreDialog::showState);
    connect(&score_, &Controller::failed, this,
            [this](const Error& error) { notice_->tell(Notice::Kind::error, Messages::sentence(error)); });
    connect(&tasks, &TaskRunner::changed, this, &ScoreDialog::showProgress);
    showState();
    reference_->setFocus();
}

ScoreDialog::~ScoreDialog() {
    disconnect(&score_, nullptr, this, nullptr);
    score_.discard(); // so that nobody scores again when takes change
}

void ScoreDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(10);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(3, 1);
    take_ = makeChoice("scoreTake", tr("Take"));
    take_->setToolTip(tr("The take that is scored"));
    reference_ = makeChoice("scoreReference", tr("Reference"));
    reference_->setToolTip(tr("The take to compare it with, such as a teacher's; it may be switched off"));
    grid->addWidget(take_, 0, 1);
    grid->addWidget(reference_, 0, 2);
    layOutRows(*grid);
    column->addLayout(grid);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("scoreNotice"));
    column->addWidget(notice_);
    column->addStretch(1);
    drawn_ = new QCheckBox(tr("Draw the reference on the timeline"), this);
    drawn_->setObjectName(QStringLiteral("scoreDrawn"));
    drawn_->setToolTip(tr("Its curves are drawn as thin lines behind those of the take, from the take's start"));
    drawn_->setChecked(score_.drawn());
    connect(drawn_, &QCheckBox::toggled, &score_, &ScoreController::setDrawn);
    column->addWidget(drawn_);
    layOutFoot();
}

void ScoreDialog::layOutRows(QGridLayout& grid) {
    int place = 1;
    for (const ScoreValue value : allScoreValues) {
        auto* title = new QLabel(scoreTitle(value), this);
        title->setToolTip(scoreDefinition(value));
        Row& row = rows_[static_cast<std::size_t>(value)];
        row = {makeScoreLabel("score_", tr("Take"), value, this),
               makeScoreLabel("reference_", tr("Reference"), value, this), makeScoreLabel("verdict_", {}, value, this)};
        for (QLabel* number : {row.own, row.reference}) number->setFont(numberFont(font()));
        grid.addWidget(title, place, 0);
        grid.addWidget(row.own, place, 1, Qt::AlignRight);
        grid.addWidget(row.reference, place, 2, Qt::AlignRight);
        grid.addWidget(row.verdict, place++, 3);
    }
}

void ScoreDialog::layOutFoot() {
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("scoreProgress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setToolTip(tr("Progress of the scoring."));
    progress_->setAccessibleName(progress_->toolTip());
    cancel_ = makeButton(tr("Cancel"), {}, QStringLiteral("cancelScoreButton"), this);
    cancel_->setToolTip(tr("Stop scoring"));
    connect(cancel_, &QPushButton::clicked, this, [this] {
        score_.cancel();
        notice_->tell(Notice::Kind::information, tr("Scoring was cancelled; choose a take to start it again."));
    });
    auto* close = makeButton(tr("Close"), {}, QStringLiteral("closeScoreButton"), this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    auto* row = new QHBoxLayout;
    row->addWidget(progress_, 1);
    row->addWidget(cancel_);
    row->addStretch(1);
    row->addWidget(close);
    static_cast<QBoxLayout*>(layout())->addLayout(row);
}

ChoiceBox* ScoreDialog::makeChoice(const char* name, const QString& label) {
    auto* choice = new ChoiceBox(this);
    choice->setObjectName(QLatin1String(name));
    choice->setAccessibleName(label);
    choice->setMinimumWidth(150);
    connect(choice, &QComboBox::activated, this, &ScoreDialog::choose);
    return choice;
}

/// Any take but the scored one can be the reference.
void ScoreDialog::offerTakes() {
    QStringList names, ids, others{tr("No reference")}, otherIds{QStringLiteral("0")};
    for (const TakeInfo& take : mill_.allTakes()) {
        names << takeName(take.name);
        ids << QString::number(take.id);
        if (take.id == score_.take()) continue;
        others << names.back();
        otherIds << ids.back();
    }
    take_->offer(names, ids, QString::number(score_.take()));
    reference_->offer(others, otherIds, QString::number(score_.reference()));
}

void ScoreDialog::choose() {
    notice_->clear();
    score_.choose(take_->currentData().toString().toLongLong(), reference_->currentData().toString().toLongLong());
}

void ScoreDialog::showState() {
    offerTakes(); // takes may have been added, named or removed
    for (const ScoreValue value : allScoreValues) showRow(value);
    drawn_->setEnabled(score_.reference() != 0);
    showProgress();
}

void ScoreDialog::showRow(ScoreValue value) {
    const Row& row = rows_[static_cast<std::size_t>(value)];
    const std::vector<TakeScore>& scores = score_.scores();
    row.own->setText(scores.empty() ? QString() : scoreText(value, scores.front()[value], unit_));
    const bool compared = scores.size() > 1;
    row.reference->setText(compared ? scoreText(value, scores.back()[value], unit_) : QString());
    const ScoreVerdict verdict = compared ? verdictOf(value, scores.front(), scores.back()) : ScoreVerdict{};
    row.verdict->setText(compared ? verdictText(value, verdict, unit_) : QString());
    // The text gives the verdict as well, so colour is not the only cue.
    setLook(row.verdict, verdict.kind == ScoreVerdict::Kind::better  ? "inOrder"
                         : verdict.kind == ScoreVerdict::Kind::worse ? "force"
                                                                     : "quiet");
    // A label's name hides its text from a screen reader.
    for (QLabel* label : {row.own, row.reference, row.verdict}) label->setAccessibleDescription(label->text());
}

void ScoreDialog::showProgress() {
    progress_->setVisible(score_.busy());
    cancel_->setVisible(score_.busy());
    progress_->setValue(static_cast<int>(1000.0 * score_.fraction()));
}

} // namespace burin
