// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/row_list.h"

#include "ui/panels/row_delegate.h"

#include <QResizeEvent>
#include <QSignalBlocker>

#include <algorithm>

namespace burin {

RowList::RowList(QWidget* parent) : QListWidget(parent) {
    setItemDelegate(new RowDelegate(this));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setUniformItemSizes(false);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) emit rowChosen(row);
    });
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        if (row(item) == beforePress_) emit rowChosen(row(item));
    });
}

void RowList::setMaximumRows(int rows) {
    maximumRows_ = rows;
    updateGeometry();
}

void RowList::setLeastRows(int rows) {
    leastRows_ = rows;
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    followRows();
}

void RowList::setFillsHeight(bool fills) {
    setSizePolicy(QSizePolicy::Expanding, fills ? QSizePolicy::Expanding : QSizePolicy::Fixed);
}

void RowList::setTextsWrap(bool wrap) {
    static_cast<RowDelegate*>(itemDelegate())->setTextsWrap(wrap);
    scheduleDelayedItemsLayout();
    updateGeometry();
}

/// The height of rows with several lines depends on the width.
void RowList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    if (event->size().width() == event->oldSize().width()) return;
    scheduleDelayedItemsLayout();
    followRows();
}

void RowList::setRows(const std::vector<ListRow>& rows) {
    if (rows == rows_) return;
    const QSignalBlocker quiet(this);
    const bool sameCount = rows.size() == rows_.size();
    const int chosen = currentRow();
    rows_ = rows;
    if (!sameCount) {
        clear();
        for (std::size_t i = 0; i < rows.size(); ++i) addItem(new QListWidgetItem);
    }
    for (int i = 0; i < count(); ++i) RowDelegate::fill(*item(i), rows_[static_cast<std::size_t>(i)]);
    setCurrentRow(chosen < count() ? chosen : -1);
    followRows();
}

void RowList::followRows() {
    if (leastRows_ > 0) setMaximumHeight(heightOfRows(maximumRows_));
    updateGeometry();
}

void RowList::setChosen(int row) {
    if (row == currentRow()) return;
    const QSignalBlocker quiet(this);
    setCurrentRow(row);
    if (row >= 0) scrollToItem(item(row));
    viewport()->update();
}

int RowList::heightOfRows(int rows) const {
    int height = 2 * frameWidth();
    for (int i = 0; i < std::min(count(), rows); ++i) height += sizeHintForRow(i);
    return std::max(height + 4, 32);
}

QSize RowList::sizeHint() const {
    return {200, heightOfRows(leastRows_ > 0 ? std::min(leastRows_, maximumRows_) : maximumRows_)};
}

QSize RowList::minimumSizeHint() const {
    constexpr int leastWidth = 96, leastHeight = 32; // pixels
    if (leastRows_ > 0) return {leastWidth, sizeHint().height()};
    return {leastWidth, sizePolicy().verticalPolicy() == QSizePolicy::Fixed ? sizeHint().height() : leastHeight};
}

void RowList::mousePressEvent(QMouseEvent* event) {
    beforePress_ = currentRow();
    QListWidget::mousePressEvent(event);
}

} // namespace burin
