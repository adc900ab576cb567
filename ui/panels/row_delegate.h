// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/row_list.h"

#include <QStyledItemDelegate>

namespace burin {

/// Paints the rows of a RowList. Text that doesn't fit is elided with "…" and shown in full in the tooltip.
class RowDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    /// Whether titles and details are wrapped over as many lines as they need instead: for whole sentences.
    void setTextsWrap(bool wrap) { wrap_ = wrap; }
    static void fill(QListWidgetItem& item, const ListRow& row);

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

private:
    /// The rectangles of the parts of a row, in pixels of its view.
    struct Places {
        QRect title, detail;
    };
    void paintText(QPainter& painter, const QRect& room, const QString& text) const;
    Places placesOf(const QStyleOptionViewItem& option, const QModelIndex& index, const QRect& row) const;

    bool wrap_ = false;
};

} // namespace burin
