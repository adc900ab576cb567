// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/notice.h"

#include "ui/panels/panel_layout.h"
#include "ui/theme/colour.h"
#include "ui/theme/icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace burin {

namespace {

constexpr int noticeIconSize = 18, noticePaddingAcross = 12, noticePaddingAlong = 8, noticeGap = 8;
constexpr double tint = 0.12, noticeCorner = 8.0;

ColourRole roleOf(Notice::Kind kind) {
    switch (kind) {
    case Notice::Kind::information:
        return &Palette::part;
    case Notice::Kind::passed:
        return &Palette::inOrder;
    case Notice::Kind::warning:
        return &Palette::accent;
    case Notice::Kind::error:
        return &Palette::force;
    }
    return &Palette::text;
}

QString iconOf(Notice::Kind kind) {
    switch (kind) {
    case Notice::Kind::information:
        return QStringLiteral("information");
    case Notice::Kind::passed:
        return QStringLiteral("passed");
    case Notice::Kind::warning:
        return QStringLiteral("warning");
    case Notice::Kind::error:
        return QStringLiteral("error");
    }
    return {};
}

} // namespace

Notice::Notice(QWidget* parent) : QFrame(parent), text_(makeWrappedLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(noticePaddingAcross + noticeIconSize + noticeGap, noticePaddingAlong, noticePaddingAcross,
                            noticePaddingAlong);
    row->addWidget(text_);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    hide();
}

void Notice::tell(Kind kind, const QString& sentence) {
    if (kind != kind_) update();
    kind_ = kind;
    setWrappedText(text_, sentence);
    const QString kindName = kind == Kind::warning ? tr("Warning") : kind == Kind::error ? tr("Error") : QString();
    setAccessibleName(kindName.isEmpty() ? sentence : kindName + QStringLiteral(": ") + sentence);
    setVisible(!sentence.isEmpty());
}

QString Notice::sentence() const {
    return text_->accessibleName();
}

void Notice::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(activePalette().panel, activePalette().*roleOf(kind_), tint));
    painter.drawRoundedRect(rect(), noticeCorner, noticeCorner);
    themedIcon(iconOf(kind_), roleOf(kind_))
        .paint(&painter, {noticePaddingAcross, noticePaddingAlong, noticeIconSize, noticeIconSize});
}

} // namespace burin
