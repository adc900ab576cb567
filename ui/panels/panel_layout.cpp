// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/panel_layout.h"

#include <QCoreApplication>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QTimer>
#include <QVariant>

#include <algorithm>

namespace burin {

namespace {

constexpr int panelWidth = 320, panelMargin = 16, panelSpacing = 8;
constexpr int longestUnbroken = 20; // characters that always fit a panel
constexpr QChar breakHere(0x200B);  // zero width space

/// A column whose minimum height is the height at the panel's width. (QVBoxLayout uses the height at its minimum width,
/// where wrapped texts have many lines; a scroll area then ends far below them.)
class PanelLayout : public QVBoxLayout {
public:
    using QVBoxLayout::QVBoxLayout;
    QSize minimumSize() const override {
        const QSize least = QVBoxLayout::minimumSize();
        if (!hasHeightForWidth()) return least;
        return {least.width(), minimumHeightForWidth(std::max(least.width(), panelWidth))};
    }
};

QString breakable(const QString& text) {
    QString result;
    int unbroken = 0;
    for (const QChar c : text) {
        result.append(c);
        unbroken = c.isSpace() && c != QChar(QChar::Nbsp) ? 0 : unbroken + 1;
        const bool joint = QStringLiteral("/\\_-.").contains(c) && unbroken > 4;
        if (!joint && unbroken < longestUnbroken) continue;
        if (c.isHighSurrogate()) continue;
        result.append(breakHere);
        unbroken = 0;
    }
    return result;
}

/// Scrolls only downwards, so that it is never narrower than what it shows.
class FormArea : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    QSize minimumSizeHint() const override {
        const int beside = verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
        return {widget()->minimumSizeHint().width() + beside, QScrollArea::minimumSizeHint().height()};
    }
};

} // namespace

QVBoxLayout* makePanelLayout(QWidget* panel) {
    auto* layout = new PanelLayout(panel);
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(panelSpacing);
    return layout;
}

QLabel* makeSectionTitle(const QString& text, QWidget* parent) {
    auto* title = new QLabel(text.toUpper(), parent);
    title->setProperty("look", "section");
    title->setContentsMargins(0, panelSpacing, 0, 0);
    title->setAccessibleName(text);
    return title;
}

QLabel* makeWrappedLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    label->setSizePolicy(policy);
    label->setMinimumWidth(1);
    return label;
}

void setWrappedText(QLabel* label, const QString& text) {
    if (label->accessibleName() == text && !label->text().isEmpty() == !text.isEmpty()) return;
    label->setAccessibleName(text);
    label->setText(breakable(text));
}

void bringIntoView(QWidget* widget) {
    const auto scroll = [widget] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // the position depends on pending layouts
        for (QWidget* parent = widget->parentWidget(); parent != nullptr; parent = parent->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(parent)) area->ensureWidgetVisible(widget);
    };
    QTimer::singleShot(0, widget, scroll);
}

void addCard(QBoxLayout* list, QWidget* card, int place) {
    list->insertWidget(place, card);
    card->show();
}

QScrollArea* makeListArea(QWidget* rows, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setWidget(rows);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus); // it scrolls with the keyboard focus from row to row
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    return area;
}

QScrollArea* makeFormArea(QWidget* form, QWidget* parent) {
    auto* area = new FormArea(parent);
    area->setWidget(form);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

void setLook(QWidget* widget, const char* look) {
    if (widget->property("look").toByteArray() == look) return;
    widget->setProperty("look", QByteArray(look));
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
    widget->update();
}

} // namespace burin
