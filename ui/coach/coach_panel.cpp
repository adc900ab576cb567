// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/coach_panel.h"

#include "ui/panels/announcement.h"
#include "ui/panels/buttons.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/panel_layout.h"
#include "ui/theme/theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include <array>

namespace burin {

namespace {

constexpr int coachWidth = 340, coachMargin = 16, coachPadding = 16; // pixels
constexpr double coachCorner = 10.0, coachEdge = 1.5;

void showTextOf(QLabel* label, const QString& text) {
    setWrappedText(label, text);
    label->setVisible(!text.isEmpty());
}

} // namespace

CoachPanel::CoachPanel(QWidget* window)
    : QFrame(window)
    , count_(makeSectionTitle({}, this))
    , title_(makeWrappedLabel(this))
    , text_(makeWrappedLabel(this))
    , key_(makeWrappedLabel(this))
    , note_(makeWrappedLabel(this))
    , back_(makeButton(tr("Back"), {}, QStringLiteral("coachBackButton"), this))
    , skip_(makeButton({}, {}, QStringLiteral("coachSkipButton"), this))
    , end_(makeButton({}, {}, QStringLiteral("coachEndButton"), this)) {
    setObjectName(QStringLiteral("coachPanel"));
    setFocusPolicy(Qt::StrongFocus);
    title_->setProperty("look", "title");
    key_->setProperty("look", "quiet");
    note_->setProperty("look", "accent");
    title_->setObjectName(QStringLiteral("coachTitle"));
    note_->setObjectName(QStringLiteral("coachNote"));
    back_->setToolTip(tr("Show the previous step"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(coachPadding, coachPadding, coachPadding, coachPadding);
    column->setSpacing(8);
    for (QLabel* label : {count_, title_, text_, key_, note_}) column->addWidget(label);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    for (QPushButton* button : {back_, skip_, end_}) row->addWidget(button, button == skip_ ? 1 : 0);
    column->addLayout(row);
    connect(back_, &QPushButton::clicked, this, &CoachPanel::backRequested);
    connect(skip_, &QPushButton::clicked, this, &CoachPanel::skipRequested);
    connect(end_, &QPushButton::clicked, this, &CoachPanel::endRequested);
    hide();
}

void CoachPanel::setState(const CoachState& state) {
    const bool finished = state.number == 0;
    const QString count =
        finished ? tr("First job") : tr("First job: step %1 of %2").arg(state.number).arg(state.steps);
    count_->setText(count.toUpper());
    count_->setAccessibleName(count);
    showTextOf(title_, state.title);
    showTextOf(text_, state.text);
    showTextOf(key_, state.key);
    showTextOf(note_, state.note);
    setEnabledKeepingFocus(back_, state.number != 1);
    skip_->setText(state.done ? tr("Next") : tr("Skip this step"));
    skip_->setToolTip(state.done ? tr("Go on to the step that is not done yet") : tr("Go on without this step"));
    skip_->setVisible(!finished);
    end_->setText(finished ? tr("Close") : tr("End"));
    end_->setToolTip(finished ? tr("Close the first job (Esc)") : tr("End the first job; the project stays (Esc)"));
    announce(state);
    layout()->invalidate(); // the new heights of the texts arrive later, by an event
    resize(coachWidth, layout()->heightForWidth(coachWidth));
}

void CoachPanel::announce(const CoachState& state) {
    setAccessibleName(count_->accessibleName() + QStringLiteral(": ") + state.title);
    QStringList sentences{state.text, state.key, state.note};
    sentences.removeAll(QString());
    setAccessibleDescription(sentences.join(QLatin1Char(' ')));
    if (state.number == saidNumber_) return;
    saidNumber_ = state.number;
    burin::announce(*this);
}

void CoachPanel::placeIn(const QRect& area, const QRect& target) {
    const QRect room = area.adjusted(coachMargin, coachMargin, -coachMargin, -coachMargin);
    const int right = room.right() + 1 - width(), bottom = room.bottom() + 1 - height();
    const std::array corners{QPoint(right, bottom), QPoint(room.left(), bottom), QPoint(right, room.top()),
                             room.topLeft()};
    const auto covered = [&](int corner) {
        const QRect both = QRect(corners[static_cast<std::size_t>(corner)], size()) & target;
        return both.isEmpty() ? 0 : both.width() * both.height();
    };
    for (int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
        if (covered(corner) < covered(corner_)) corner_ = corner; // ties keep the present corner
    move(corners[static_cast<std::size_t>(corner_)]);
}

void CoachPanel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? activePalette().part : activePalette().accent, coachEdge));
    painter.setBrush(activePalette().panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), coachCorner, coachCorner);
}

} // namespace burin
