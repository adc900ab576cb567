// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/row_delegate.h"

#include "ui/theme/colour.h"
#include "ui/theme/icon.h"
#include "ui/theme/number_font.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace burin {

namespace {

enum Role { titleRole = Qt::UserRole, valueRole, detailRole, iconRole, swatchRole, badgeRole };

constexpr int paddingAcross = 8, paddingAlong = 5, gap = 8, iconSize = 16, swatchSize = 10;
constexpr double detailSize = 0.88, chosenTint = 0.16, hoverTint = 0.05, corner = 5.0;

QFont detailFont(const QFont& base) {
    QFont font = numberFont(base);
    font.setPointSizeF(detailSize * base.pointSizeF());
    return font;
}

QString textOf(const QModelIndex& index, Role role) {
    return index.data(role).toString();
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
    const Palette& colours = activePalette();
    const bool chosen = (option.state & QStyle::State_Selected) != 0;
    const bool hover = (option.state & QStyle::State_MouseOver) != 0;
    if (!chosen && !hover) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(chosen ? mixed(colours.field, colours.accent, chosenTint)
                            : mixed(colours.field, colours.text, hoverTint));
    painter.drawRoundedRect(QRectF(option.rect).adjusted(2.0, 1.0, -2.0, -1.0), corner, corner);
}

/// The width of the icon or swatch at the left.
int markWidth(const QModelIndex& index) {
    if (index.data(swatchRole).value<QColor>().isValid()) return swatchSize + gap;
    return index.data(iconRole).value<QIcon>().isNull() ? 0 : iconSize + gap;
}

void paintMark(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, const QPoint& left) {
    if (const QColor swatch = index.data(swatchRole).value<QColor>(); swatch.isValid()) {
        painter.setPen(activePalette().border);
        painter.setBrush(swatch);
        painter.drawRoundedRect(QRectF(left.x() + 0.5, left.y() - 0.5 * swatchSize, swatchSize, swatchSize), 2.0, 2.0);
        return;
    }
    const QRect square(left.x(), left.y() - iconSize / 2, iconSize, iconSize);
    index.data(iconRole).value<QIcon>().paint(&painter, square, Qt::AlignCenter,
                                              (option.state & QStyle::State_Enabled) ? QIcon::Normal : QIcon::Disabled);
}

/// The width of value and badge to the right of the title.
int badgeWidth(const QStyleOptionViewItem& option, const QString& badge) {
    return QFontMetrics(detailFont(option.font)).horizontalAdvance(badge) + gap;
}
int valueWidth(const QStyleOptionViewItem& option, const QModelIndex& index) {
    const QString value = textOf(index, valueRole), badge = textOf(index, badgeRole);
    return (value.isEmpty() ? 0 : QFontMetrics(numberFont(option.font)).horizontalAdvance(value) + gap) +
           (badge.isEmpty() ? 0 : badgeWidth(option, badge) + gap);
}

/// Paints the badge, right-aligned at `right`.
void paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QString& badge, int right) {
    painter.setFont(detailFont(option.font));
    const int width = badgeWidth(option, badge);
    const QRectF frame(right - width + 0.5, option.rect.top() + paddingAlong + 0.5, width,
                       option.fontMetrics.height() - 1.0);
    painter.setPen(activePalette().accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(frame, 4.0, 4.0);
    painter.drawText(frame, Qt::AlignCenter, badge);
}

} // namespace

void RowDelegate::fill(QListWidgetItem& item, const ListRow& row) {
    item.setData(titleRole, row.title);
    item.setData(valueRole, row.value);
    item.setData(detailRole, row.detail);
    item.setData(iconRole, row.icon.isEmpty() ? QIcon() : themedIcon(row.icon, row.iconRole));
    item.setData(swatchRole, row.swatch);
    item.setData(badgeRole, row.badge);
    item.setToolTip(row.toolTip);
    QStringList spoken{row.title, row.value, row.badge, row.detail};
    spoken.removeAll(QString());
    item.setData(Qt::AccessibleTextRole, spoken.join(QStringLiteral(", ")));
}

RowDelegate::Places RowDelegate::placesOf(const QStyleOptionViewItem& option, const QModelIndex& index,
                                          const QRect& row) const {
    const QRect room = row.adjusted(paddingAcross + markWidth(index), paddingAlong, -paddingAcross, -paddingAlong);
    const int width = std::max(1, room.width() - valueWidth(option, index));
    const auto heightOf = [this](const QFontMetrics& font, int across, const QString& text) {
        if (!wrap_) return font.height();
        return std::max(font.height(), font.boundingRect(QRect(0, 0, across, 10000), Qt::TextWordWrap, text).height());
    };
    const QFontMetrics detail(detailFont(option.font));
    const int height = heightOf(option.fontMetrics, width, textOf(index, titleRole));
    return {QRect(room.left(), room.top(), width, height),
            QRect(room.left(), room.top() + height + 1, room.width(),
                  heightOf(detail, room.width(), textOf(index, detailRole)))};
}

void RowDelegate::paintText(QPainter& painter, const QRect& room, const QString& text) const {
    if (wrap_)
        painter.drawText(room, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text);
    else
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, room.width()));
}

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const Palette& colours = activePalette();
    const bool enabled = (option.state & QStyle::State_Enabled) != 0;
    const Places places = placesOf(option, index, option.rect);
    const QString title = textOf(index, titleRole), value = textOf(index, valueRole), badge = textOf(index, badgeRole);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintGround(*painter, option);
    const QRect line(option.rect.left() + paddingAcross, places.title.top(), option.rect.width() - 2 * paddingAcross,
                     option.fontMetrics.height());
    if (markWidth(index) > 0) paintMark(*painter, option, index, {line.left(), line.center().y()});

    painter->setFont(numberFont(option.font));
    painter->setPen(enabled ? colours.text : colours.quietText);
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, value);
    const int valueRoom = value.isEmpty() ? 0 : painter->fontMetrics().horizontalAdvance(value) + gap;
    if (!badge.isEmpty()) paintBadge(*painter, option, badge, line.right() + 1 - valueRoom);
    painter->setFont(option.font);
    painter->setPen(enabled ? colours.text : colours.quietText);
    paintText(*painter, places.title, title);

    painter->setFont(detailFont(option.font));
    painter->setPen(colours.quietText);
    paintText(*painter, places.detail, textOf(index, detailRole));
    painter->restore();
}

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const QRect row(0, 0, view != nullptr ? view->viewport()->width() : option.rect.width(), 0);
    const Places places = placesOf(option, index, row);
    const bool hasDetail = !textOf(index, detailRole).isEmpty();
    return {96, (hasDetail ? places.detail.bottom() : places.title.bottom()) + 1 + paddingAlong};
}

bool RowDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                            const QModelIndex& index) {
    if (event->type() != QEvent::ToolTip || !index.isValid())
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    const Places places = placesOf(option, index, option.rect);
    QStringList texts;
    if (const QString title = textOf(index, titleRole);
        !wrap_ && option.fontMetrics.horizontalAdvance(title) > places.title.width())
        texts << title;
    if (const QString detail = textOf(index, detailRole);
        !wrap_ && QFontMetrics(detailFont(option.font)).horizontalAdvance(detail) > places.detail.width())
        texts << detail;
    texts << index.data(Qt::ToolTipRole).toString();
    texts.removeAll(QString());
    texts.removeDuplicates();
    QToolTip::showText(event->globalPos(), texts.join(QLatin1Char('\n')), view);
    return true;
}

} // namespace burin
