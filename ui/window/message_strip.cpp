// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/message_strip.h"

#include "ui/theme/icon.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace burin {

MessageStrip::MessageStrip(QWidget* parent) : QWidget(parent), notice_(new Notice(this)) {
    setObjectName(QStringLiteral("messageStrip"));
    notice_->setObjectName(QStringLiteral("messageNotice"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 0);
    layout->setSpacing(8);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("dismissMessageButton"));
    close->setProperty("look", "flat");
    close->setIcon(themedIcon(QStringLiteral("cancel"), &Palette::quietText));
    close->setToolTip(tr("Put this message away."));
    connect(close, &QToolButton::clicked, this, &MessageStrip::dismiss);
    layout->addWidget(notice_, 1);
    layout->addWidget(close);
    hide();
}

void MessageStrip::tell(Notice::Kind kind, const QString& sentence) {
    notice_->tell(kind, sentence);
    setVisible(true);
}

void MessageStrip::dismiss() {
    hide();
    notice_->clear();
}

} // namespace burin
