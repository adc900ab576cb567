// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/take_list.h"

#include "ui/panels/buttons.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QFrame>
#include <QGridLayout>

#include <algorithm>

namespace burin {

namespace {

bool same(const TakeRow& one, const TakeRow& other) {
    return one.strokes == other.strokes && one.info.id == other.info.id && one.info.name == other.info.name &&
           one.info.toolId == other.info.toolId && one.info.sampleCount == other.info.sampleCount &&
           one.info.complete == other.info.complete && one.info.stylus == other.info.stylus;
}

QString detailOf(const TakeRow& take) {
    QStringList parts{QString::fromStdString(take.info.toolId)};
    parts.append(take.strokes == 1 ? TakeList::tr("1 stroke")
                                   : TakeList::tr("%n strokes", nullptr, static_cast<int>(take.strokes)));
    parts.append(TakeList::tr("%1 samples").arg(countText(take.info.sampleCount)));
    if (!take.info.complete) parts.append(TakeList::tr("incomplete"));
    return parts.join(QStringLiteral(" · "));
}

} // namespace

TakeList::TakeList(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)) {
    rows_->setContentsMargins(0, 0, 0, 0);
    rows_->setSpacing(4);
}

void TakeList::setTakes(const std::vector<TakeRow>& takes) {
    if (std::ranges::equal(takes, takes_, same)) return;
    takes_ = takes;
    while (QLayoutItem* item = rows_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // the row whose button was just pressed may be among them
        delete item;
    }
    for (auto take = takes_.rbegin(); take != takes_.rend(); ++take) rows_->addWidget(makeRow(*take));
}

void TakeList::setRemovable(bool removable) {
    if (removable == removable_) return;
    removable_ = removable;
    for (QToolButton* button : findChildren<QToolButton*>()) button->setEnabled(removable);
}

QWidget* TakeList::makeRow(const TakeRow& take) {
    auto* row = new QFrame(this);
    row->setProperty("look", "card");
    auto* grid = new QGridLayout(row);
    grid->setContentsMargins(10, 6, 4, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    const QString name = takeName(take.info.name);
    grid->addWidget(new ElidedLabel(name, row), 0, 0);
    auto* duration = new QLabel(durationText(static_cast<double>(take.info.sampleCount) * take.info.tickPeriod), row);
    duration->setFont(numberFont(font()));
    grid->addWidget(duration, 0, 1, Qt::AlignRight);
    auto* detail = new ElidedLabel(detailOf(take), row);
    detail->setProperty("look", "small");
    grid->addWidget(detail, 1, 0, 1, 2);
    const qint64 id = take.info.id;
    QToolButton* remove = makeIconButton(QStringLiteral("remove"), tr("Remove the take “%1”").arg(name),
                                         QStringLiteral("removeTake%1").arg(id), row);
    remove->setEnabled(removable_);
    connect(remove, &QToolButton::clicked, this, [this, id] { emit removalRequested(id); });
    grid->addWidget(remove, 0, 2, 2, 1, Qt::AlignVCenter);
    grid->setColumnStretch(0, 1);
    return row;
}

} // namespace burin
