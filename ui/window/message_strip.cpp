// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/message_strip.h"

#include "ui/theme/icon.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>

namespace burin {

MessageStrip::MessageStrip(QWidget* parent)
    : QWidget(parent), notice_(new Notice(this)), close_(new QToolButton(this)) {
    setObjectName(QStringLiteral("messageStrip"));
    notice_->setObjectName(QStringLiteral("messageNotice"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    close_->setObjectName(QStringLiteral("dismissMessageButton"));
    close_->setProperty("look", "flat");
    close_->setIcon(themedIcon(QStringLiteral("cancel"), &Palette::quietText));
    close_->setToolTip(tr("Close this message."));
    close_->setAccessibleName(close_->toolTip());
    connect(close_, &QToolButton::clicked, this, &MessageStrip::dismiss);
    layout->addWidget(notice_, 1);
    layout->addWidget(close_);
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
    // Not by the layout, which hears of the new height of the text with a later event.
    const int width = area_->width() - freeAtRight_;
    const QMargins around = layout()->contentsMargins();
    const QSize button = close_->sizeHint();
    const int text = notice_->fitTo(width - around.left() - around.right() - layout()->spacing() - button.width());
    setGeometry(0, 0, width, around.top() + std::max(text, button.height()) + around.bottom());
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
