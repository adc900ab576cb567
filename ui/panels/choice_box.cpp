// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/choice_box.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>

namespace burin {

namespace {

constexpr int textPadding = 6; // padding of the label in its rectangle, from the style sheet

} // namespace

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(8);
}

QString ChoiceBox::elided() const {
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect room = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    const QString text = currentIndex() < 0 ? placeholderText() : currentText();
    const int icon = option.currentIcon.isNull() ? 0 : option.iconSize.width() + textPadding;
    return fontMetrics().elidedText(text, Qt::ElideRight, room.width() - textPadding - icon);
}

void ChoiceBox::showPopup() {
    view()->setMinimumWidth(std::max(width(), view()->sizeHintForColumn(0) + 2 * textPadding));
    QComboBox::showPopup();
}

void ChoiceBox::offer(const QStringList& texts, const QStringList& ids, const QString& chosen) {
    const QSignalBlocker quiet(this);
    bool same = count() == texts.size();
    for (int i = 0; same && i < count(); ++i) same = itemText(i) == texts[i] && itemData(i).toString() == ids[i];
    if (!same) {
        clear();
        for (int i = 0; i < texts.size(); ++i) addItem(texts[i], ids[i]);
    }
    setCurrentIndex(findData(chosen));
}

bool ChoiceBox::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && elided() != currentText()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), currentText(), this);
        return true;
    }
    return QComboBox::event(event);
}

void ChoiceBox::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = elided();
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

void ChoiceBox::showEvent(QShowEvent* event) {
    QComboBox::showEvent(event);
    giveLabel();
}

/// On Unix, Qt gives the chosen text as the name of a box; what it is for is read from its label alone. A box without a
/// label next to it has a hidden one.
void ChoiceBox::giveLabel() {
    if (accessibleName().isEmpty() || parentWidget() == nullptr) return;
    for (const QLabel* label : parentWidget()->findChildren<QLabel*>(Qt::FindDirectChildrenOnly))
        if (label->buddy() == this) return;
    auto* label = new QLabel(accessibleName(), parentWidget());
    label->setBuddy(this);
    label->hide();
}

void ChoiceBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QComboBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace burin
