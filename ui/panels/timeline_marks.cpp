// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What the timeline draws besides the takes that were read: takes under way, and the chosen part of the path.
#include "ui/panels/timeline_view.h"
#include "ui/theme/colour.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace burin {

void TimelineView::paintGrowing(QPainter& painter) const {
    const Palette& palette = activePalette();
    const QRect row = clipRow();
    double start = state_.recorded->seconds();
    for (const GrowingClip& clip : state_.growing) {
        const QRectF area(QPointF(placeOf(start), row.top()),
                          QPointF(std::max(placeOf(start) + 2.0, placeOf(start + clip.seconds) - 1.0), row.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(mixed(palette.panel, palette.force, 0.35));
        painter.drawRoundedRect(area, 3, 3);
        for (const auto& [begin, end] : clip.strokes) {
            const double left = placeOf(start + begin), right = placeOf(start + end);
            painter.fillRect(QRectF(left, row.bottom() - 7, std::max(1.0, right - left), 5), palette.force);
        }
        painter.setPen(palette.text);
        const QRectF text = area.adjusted(6, 0, -4, -6);
        if (text.width() > 20)
            painter.drawText(
                text, Qt::AlignLeft | Qt::AlignVCenter,
                painter.fontMetrics().elidedText(clip.name, Qt::ElideRight, static_cast<int>(text.width())));
        start += clip.seconds;
    }
}

/// Marks the moments of the chosen part of the path in the colour that it has in the view.
void TimelineView::paintPointed(QPainter& painter) const {
    if (!state_.pointed) return;
    const Palette& palette = activePalette();
    const QRect row = clipRow();
    if (!state_.pointed->hasMoment) {
        const QString text = tr("The selected point was computed: no take has it");
        const QRectF flag(row.left(), row.top() + 4,
                          std::min(row.width(), painter.fontMetrics().horizontalAdvance(text) + 12), row.height() - 8);
        painter.fillRect(flag, palette.chosenPath);
        painter.setPen(palette.pathHalo);
        painter.drawText(flag.adjusted(6, 0, -4, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(flag.width()) - 10));
        return;
    }
    painter.save();
    painter.setClipRect(row.adjusted(-1, -3, 2, 3));
    const double left = std::round(placeOf(state_.pointed->first)), right = std::round(placeOf(state_.pointed->last));
    const auto mark = [&](const QRectF& area) {
        painter.fillRect(area.adjusted(-1, -1, 1, 1), palette.pathHalo);
        painter.fillRect(area, palette.chosenPath);
    };
    if (right > left) mark(QRectF(left, row.top(), right - left, 3));
    for (const double x : {left, right}) mark(QRectF(x, row.top(), 2, row.height()));
    painter.restore();
}

} // namespace burin
