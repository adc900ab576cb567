// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/message_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

namespace burin {

MessageStrip::MessageStrip(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("messageStrip"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(16, 8, 8, 8);
    layout->setSpacing(12);
    mark_ = new QLabel(this);
    mark_->setObjectName(QStringLiteral("messageMark"));
    text_ = new QLabel(this);
    text_->setObjectName(QStringLiteral("messageText"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("dismissMessageButton"));
    close->setText(QStringLiteral("✕"));
    close->setToolTip(tr("Put this message away."));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &MessageStrip::dismiss);
    layout->addWidget(mark_);
    layout->addWidget(text_, 1);
    layout->addWidget(close);
    hide();
}

void MessageStrip::show(Kind kind, const QString& sentence) {
    // Signs beside colours: red and green never carry meaning alone.
    mark_->setText(kind == Kind::information ? QStringLiteral("i") : QStringLiteral("!"));
    setProperty("kind", kind == Kind::error ? "error" : kind == Kind::warning ? "warning" : "information");
    text_->setText(sentence);
    style()->unpolish(this);
    style()->polish(this);
    setVisible(true);
}

void MessageStrip::dismiss() {
    hide();
    text_->clear();
}

} // namespace burin
