// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/notice.h"

#include "ui/panels/panel_layout.h"
#include "ui/theme/colour.h"
#include "ui/theme/icon.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>

namespace burin {

namespace {

constexpr int iconSize = 18;
constexpr double tint = 0.12, corner = 8.0;

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

Notice::Notice(QWidget* parent) : QFrame(parent), icon_(new QLabel(this)), text_(makeWrappedLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(8);
    icon_->setFixedSize(iconSize, iconSize);
    row->addWidget(icon_, 0, Qt::AlignTop);
    row->addWidget(text_, 1);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    showIcon();
    hide();
}

void Notice::tell(Kind kind, const QString& sentence) {
    if (kind != kind_) {
        kind_ = kind;
        showIcon();
        update();
    }
    setWrappedText(text_, sentence);
    const QString kindName = kind == Kind::warning ? tr("Warning") : kind == Kind::error ? tr("Error") : QString();
    setAccessibleName(kindName.isEmpty() ? sentence : kindName + QStringLiteral(": ") + sentence);
    setVisible(!sentence.isEmpty());
}

QString Notice::sentence() const {
    return text_->accessibleName();
}

void Notice::showIcon() {
    icon_->setPixmap(themedIcon(iconOf(kind_), roleOf(kind_)).pixmap(QSize(iconSize, iconSize), devicePixelRatioF()));
}

void Notice::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) showIcon();
    QFrame::changeEvent(event);
}

void Notice::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(activePalette().panel, activePalette().*roleOf(kind_), tint));
    painter.drawRoundedRect(rect(), corner, corner);
}

} // namespace burin
