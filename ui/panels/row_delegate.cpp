// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/row_delegate.h"

#include "ui/theme/colour.h"
#include "ui/theme/icon.h"
#include "ui/theme/number_font.h"

#include <QPainter>

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

/// The icon or swatch at the left; gives the room that it takes.
int paintMark(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, const QRect& line) {
    if (const QColor swatch = index.data(swatchRole).value<QColor>(); swatch.isValid()) {
        painter.setPen(activePalette().border);
        painter.setBrush(swatch);
        const QRectF square(line.left() + 0.5, line.center().y() - 0.5 * swatchSize, swatchSize, swatchSize);
        painter.drawRoundedRect(square, 2.0, 2.0);
        return swatchSize + gap;
    }
    const QIcon icon = index.data(iconRole).value<QIcon>();
    if (icon.isNull()) return 0;
    const QRect square(line.left(), line.center().y() - iconSize / 2, iconSize, iconSize);
    icon.paint(&painter, square, Qt::AlignCenter,
               (option.state & QStyle::State_Enabled) ? QIcon::Normal : QIcon::Disabled);
    return iconSize + gap;
}

/// The badge, right-aligned at `right`; gives the room that it takes.
int paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, int right) {
    const QString badge = textOf(index, badgeRole);
    if (badge.isEmpty()) return 0;
    painter.setFont(detailFont(option.font));
    const int width = painter.fontMetrics().horizontalAdvance(badge) + gap;
    const QRectF frame(right - width + 0.5, option.rect.top() + paddingAlong + 0.5, width,
                       option.fontMetrics.height() - 1.0);
    painter.setPen(activePalette().accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(frame, 4.0, 4.0);
    painter.drawText(frame, Qt::AlignCenter, badge);
    return width + gap;
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

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const Palette& colours = activePalette();
    const bool enabled = (option.state & QStyle::State_Enabled) != 0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintGround(*painter, option);
    QRect room = option.rect.adjusted(paddingAcross, paddingAlong, -paddingAcross, -paddingAlong);
    QRect line(room.left(), room.top(), room.width(), option.fontMetrics.height());
    room.setLeft(room.left() + paintMark(*painter, option, index, line));
    line.setLeft(room.left());

    painter->setFont(numberFont(option.font));
    painter->setPen(enabled ? colours.text : colours.quietText);
    const QString value = textOf(index, valueRole);
    painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, value);
    int titleWidth = line.width() - (value.isEmpty() ? 0 : painter->fontMetrics().horizontalAdvance(value) + gap);
    titleWidth -= paintBadge(*painter, option, index, line.left() + titleWidth);
    painter->setFont(option.font);
    painter->setPen(enabled ? colours.text : colours.quietText);
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                      option.fontMetrics.elidedText(textOf(index, titleRole), Qt::ElideRight, titleWidth));

    painter->setFont(detailFont(option.font));
    painter->setPen(colours.quietText);
    const QRect second(room.left(), line.bottom() + 1, room.width(), painter->fontMetrics().height());
    painter->drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(textOf(index, detailRole), Qt::ElideRight, second.width()));
    painter->restore();
}

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    int height = option.fontMetrics.height() + 2 * paddingAlong;
    if (!textOf(index, detailRole).isEmpty()) height += QFontMetrics(detailFont(option.font)).height() + 1;
    return {96, height};
}

} // namespace burin
