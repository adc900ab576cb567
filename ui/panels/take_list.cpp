// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/take_list.h"

#include "ui/panels/buttons.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QFrame>
#include <QGridLayout>
#include <QScrollArea>

#include <algorithm>
#include <memory>

namespace burin {

namespace {

constexpr int rowsSeen = 3, rowGap = 4; // visible at once; pixels

bool same(const TakeRow& one, const TakeRow& other) {
    return one.strokes == other.strokes && one.recording == other.recording && one.replaying == other.replaying &&
           one.info.id == other.info.id && one.info.name == other.info.name && one.tool == other.tool &&
           one.info.sampleCount == other.info.sampleCount && one.info.seconds == other.info.seconds &&
           one.info.complete == other.info.complete && one.info.stylus == other.info.stylus;
}

QString detailOf(const TakeRow& take) {
    QStringList parts{take.tool};
    parts.append(take.replaying      ? TakeList::tr("being replayed")
                 : take.strokes == 1 ? TakeList::tr("1 stroke")
                                     : TakeList::tr("%n strokes", nullptr, static_cast<int>(take.strokes)));
    if (take.recording) {
        parts.append(TakeList::tr("recording")); // the number of samples is known once they are written
        return parts.join(QStringLiteral(" · "));
    }
    parts.append(TakeList::tr("%1 samples").arg(countText(take.info.sampleCount)));
    if (!take.info.complete) parts.append(TakeList::tr("incomplete"));
    return parts.join(QStringLiteral(" · "));
}

} // namespace

TakeList::TakeList(const QString& whenEmpty, QWidget* parent) : QWidget(parent) {
    auto* rows = new QWidget;
    auto* content = new QVBoxLayout(rows);
    content->setContentsMargins(0, 0, 0, 0);
    content->setSpacing(rowGap);
    empty_ = makeWrappedLabel(rows);
    empty_->setProperty("look", "quiet");
    setWrappedText(empty_, whenEmpty);
    content->addWidget(empty_);
    layout_ = new QVBoxLayout;
    layout_->setSpacing(rowGap);
    content->addLayout(layout_);
    content->addStretch(1);
    const std::unique_ptr<QWidget> like(makeRow({}).widget);
    area_ = makeListArea(rows, this);
    area_->setFixedHeight(rowsSeen * (like->sizeHint().height() + rowGap) - rowGap);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area_);
    showEmpty(true);
}

void TakeList::setTakes(const std::vector<TakeRow>& takes) {
    const auto sameTake = [](const TakeRow& one, const TakeRow& other) { return one.info.id == other.info.id; };
    const bool rowsStand = std::ranges::equal(takes, takes_, sameTake);
    if (!rowsStand) makeRows(takes);
    showEmpty(takes.empty());
    // A take that is being recorded changes with each update: its row is kept and updated.
    for (std::size_t i = 0; rowsStand && i < takes.size(); ++i)
        if (!same(takes[i], takes_[i])) show(rows_[i], takes[i]);
    takes_ = takes;
}

/// The text fits, but Qt requests the height that it would have in a narrow column.
void TakeList::showEmpty(bool empty) {
    empty_->setVisible(empty);
    area_->setVerticalScrollBarPolicy(empty ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
}

void TakeList::makeRows(const std::vector<TakeRow>& takes) {
    rows_.clear();
    while (QLayoutItem* item = layout_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // the row whose button was just pressed may be among them
        delete item;
    }
    for (const TakeRow& take : takes) {
        rows_.push_back(makeRow(take));
        addCard(layout_, rows_.back().widget, 0); // the newest first
    }
}

void TakeList::setRemovable(bool removable) {
    if (removable == removable_) return;
    removable_ = removable;
    for (QToolButton* button : findChildren<QToolButton*>()) setEnabledKeepingFocus(button, removable);
}

TakeList::Row TakeList::makeRow(const TakeRow& take) {
    Row row;
    auto* frame = new QFrame(this);
    row.widget = frame;
    frame->setProperty("look", "card");
    auto* grid = new QGridLayout(frame);
    grid->setContentsMargins(10, 6, 4, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    row.name = new ElidedLabel({}, frame);
    grid->addWidget(row.name, 0, 0);
    row.duration = new QLabel(frame);
    row.duration->setFont(numberFont(font()));
    grid->addWidget(row.duration, 0, 1, Qt::AlignRight);
    row.detail = new ElidedLabel({}, frame);
    row.detail->setProperty("look", "small");
    grid->addWidget(row.detail, 1, 0, 1, 2);
    row.remove = makeIconButton(QStringLiteral("remove"), tr("Delete this take"),
                                QStringLiteral("removeTake%1").arg(take.info.id), frame);
    setEnabledKeepingFocus(row.remove, removable_);
    connect(row.remove, &QToolButton::clicked, this, [this, id = take.info.id] { emit removalRequested(id); });
    grid->addWidget(row.remove, 0, 2, 2, 1, Qt::AlignVCenter);
    grid->setColumnStretch(0, 1);
    show(row, take);
    return row;
}

void TakeList::show(const Row& row, const TakeRow& take) {
    row.name->setText(takeName(take.info.name));
    row.remove->setAccessibleName(row.name->text() + QStringLiteral(", ") + row.remove->toolTip());
    row.duration->setText(take.info.seconds ? durationText(*take.info.seconds) : tr("damaged"));
    row.detail->setText(detailOf(take));
}

} // namespace burin
