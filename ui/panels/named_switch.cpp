// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/named_switch.h"

#include "ui/panels/elided_label.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QMouseEvent>

namespace burin {

NamedSwitch::NamedSwitch(const QString& name, const QString& toolTip, QWidget* parent)
    : QWidget(parent), box_(new QCheckBox(this)), title_(new ElidedLabel({}, this)), news_(new ElidedLabel({}, this)) {
    box_->setObjectName(name + QStringLiteral("Switch"));
    box_->setToolTip(toolTip);
    connect(box_, &QCheckBox::clicked, this, &NamedSwitch::switched);
    news_->setObjectName(name + QStringLiteral("News"));
    news_->setProperty("look", "small");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(box_);
    row->addWidget(title_, 1);
    row->addWidget(news_);
}

void NamedSwitch::show(const QString& title, bool on, const QString& news) {
    if (title_->text() != title) {
        title_->setText(title);
        box_->setAccessibleName(title);
    }
    box_->setChecked(on); // doesn't emit `clicked`
    if (news_->text() != news) news_->setText(news);
}

void NamedSwitch::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && box_->isEnabled()) box_->click();
}

} // namespace burin
