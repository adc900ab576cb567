// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/view_dock.h"

#include "ui/panels/buttons.h"

#include <QAction>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>

namespace burin {

ViewDock::ViewDock(const Look& look, QAction& shown, QMainWindow& view)
    : QDockWidget(look.title, &view), shown_(shown) {
    setObjectName(look.name);
    setTitleBarWidget(makeTitleBar(look));
    view.addDockWidget(look.area, this);
    const bool below = look.area == Qt::BottomDockWidgetArea || look.area == Qt::TopDockWidgetArea;
    view.resizeDocks({this}, {look.size}, below ? Qt::Vertical : Qt::Horizontal);
    hide();
    connect(&shown, &QAction::toggled, this, [this] { follow(); });
}

QWidget* ViewDock::makeTitleBar(const Look& look) {
    auto* bar = new QWidget(this);
    const QString name = look.name.left(1).toUpper() + look.name.mid(1);
    QToolButton* single =
        makeIconButton(QStringLiteral("float"), tr("Make it a window of its own, or put it back next to the view"),
                       QStringLiteral("float") + name, bar);
    QToolButton* back = makeIconButton(QStringLiteral("cancel"), look.closeTip, QStringLiteral("close") + name, bar);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(8, 2, 4, 2);
    row->setSpacing(4);
    if (look.titleBar != nullptr) {
        row->addWidget(look.titleBar, 1);
    } else {
        auto* title = new QLabel(look.title, bar);
        title->setProperty("look", "section");
        row->addWidget(title, 1);
    }
    row->addWidget(single);
    row->addWidget(back);
    connect(single, &QToolButton::clicked, this, [this] { setFloating(!isFloating()); });
    connect(back, &QToolButton::clicked, this, &QWidget::close);
    return bar;
}

void ViewDock::setUsed(bool used) {
    used_ = used;
    follow();
}

bool ViewDock::wanted() const {
    return shown_.isChecked();
}

void ViewDock::follow() {
    setVisible(wanted() && used_);
}

void ViewDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    shown_.setChecked(false);
}

} // namespace burin
