// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/message_strip.h"

#include "ui/theme/icon.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

namespace burin {

MessageStrip::MessageStrip(QWidget* parent) : QWidget(parent), notice_(new Notice(this)) {
    setObjectName(QStringLiteral("messageStrip"));
    notice_->setObjectName(QStringLiteral("messageNotice"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("dismissMessageButton"));
    close->setProperty("look", "flat");
    close->setIcon(themedIcon(QStringLiteral("cancel"), &Palette::quietText));
    close->setToolTip(tr("Close this message."));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, this, &MessageStrip::dismiss);
    layout->addWidget(notice_, 1);
    layout->addWidget(close);
    hide();
}

void MessageStrip::tell(Notice::Kind kind, const QString& sentence) {
    notice_->tell(kind, sentence);
    fit();
    setVisible(true);
    raise();
}

void MessageStrip::layOver(QWidget* area, int freeAtRight) {
    if (area_ == area) return;
    freeAtRight_ = freeAtRight;
    if (area_ != nullptr) area_->removeEventFilter(this);
    area_ = area;
    area_->installEventFilter(this);
    const bool shown = !isHidden();
    setParent(area_);
    setVisible(shown);
    fit();
    raise();
}

void MessageStrip::fit() {
    if (area_ == nullptr) return;
    layout()->invalidate(); // the new height of the text arrives with a later event
    const int width = area_->width() - freeAtRight_;
    setGeometry(0, 0, width, layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height());
}

bool MessageStrip::eventFilter(QObject* watched, QEvent* event) {
    if (watched == area_ && event->type() == QEvent::Resize) fit();
    return QWidget::eventFilter(watched, event);
}

void MessageStrip::dismiss() {
    hide();
    notice_->clear();
}

} // namespace burin
