// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/restyling.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QStyle>
#include <QWidget>

namespace burin {

namespace {

constexpr qint64 pieceTime = 10; // ms

void restyle(QWidget& widget) {
    widget.style()->polish(&widget);
    QEvent changed(QEvent::StyleChange);
    QCoreApplication::sendEvent(&widget, &changed);
}

} // namespace

Restyling::Restyling(QApplication& application) : QObject(&application), application_(application) {
    pieces_.setInterval(0);
    connect(&pieces_, &QTimer::timeout, this, &Restyling::stylePiece);
}

void Restyling::begin(const QString& sheet) {
    // A new sheet visits every widget for which the style has cached rules, about a millisecond each: clear that cache
    // first.
    application_.style()->unpolish(&application_);
    application_.setStyleSheet(sheet);
    hidden_.clear();
    pending_.clear();
    std::vector<QPointer<QWidget>> visible;
    for (QWidget* window : QApplication::topLevelWidgets()) collect(*window, visible);
    for (const QPointer<QWidget>& widget : visible)
        if (widget) restyle(*widget);
    application_.installEventFilter(this);
    pieces_.start();
}

void Restyling::collect(QWidget& widget, std::vector<QPointer<QWidget>>& visible) {
    if (widget.testAttribute(Qt::WA_WState_Polished)) { // the others are styled when they are first shown
        if (widget.isVisible()) {
            visible.emplace_back(&widget);
        } else {
            hidden_.emplace_back(&widget);
            pending_.insert(&widget);
        }
    }
    for (QObject* child : widget.children())
        if (auto* inner = qobject_cast<QWidget*>(child); inner != nullptr && !inner->isWindow())
            collect(*inner, visible);
}

bool Restyling::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Show || !pending_.remove(watched)) return false;
    restyle(*static_cast<QWidget*>(watched));
    return false;
}

void Restyling::stylePiece() {
    QElapsedTimer clock;
    clock.start();
    while (!hidden_.empty() && clock.elapsed() < pieceTime) {
        const QPointer<QWidget> widget = hidden_.back();
        hidden_.pop_back();
        if (widget && pending_.remove(widget.data())) restyle(*widget);
    }
    if (!hidden_.empty()) return;
    pieces_.stop();
    pending_.clear();
    application_.removeEventFilter(this);
}

} // namespace burin
