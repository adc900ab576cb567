// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/visible_texts.h"

#include "ui/panels/elided_label.h"
#include "ui/panels/row_list.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionButton>

namespace burin::testing {

namespace {

/// All that one widget says.
QStringList textsOf(const QWidget& widget) {
    QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription(), widget.statusTip()};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts << button->text();
    if (const auto* field = qobject_cast<const QDoubleSpinBox*>(&widget))
        texts << field->suffix() << field->prefix() << field->specialValueText();
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
        for (int i = 0; i < choice->count(); ++i)
            texts << choice->itemText(i) << choice->itemData(i, Qt::ToolTipRole).toString();
    if (const auto* list = qobject_cast<const RowList*>(&widget))
        for (const ListRow& row : list->rows())
            texts << row.title << row.value << row.detail << row.badge << row.toolTip;
    return texts;
}

QString nameOf(const QWidget& widget) {
    return widget.objectName().isEmpty() ? QString::fromLatin1(widget.metaObject()->className()) : widget.objectName();
}

QString withoutMnemonics(QString text) {
    return text.remove(QLatin1Char('&'));
}

bool fits(const QLabel& label) {
    if (label.text().isEmpty() || Qt::mightBeRichText(label.text())) return true;
    const QRect room = label.contentsRect();
    const int flags = label.wordWrap() ? Qt::TextWordWrap : 0;
    const QRect needed = label.fontMetrics().boundingRect(QRect(0, 0, room.width(), 1 << 20), flags, label.text());
    return needed.width() <= room.width() && needed.height() <= room.height();
}

/// @param contents  what the style leaves of the button for text and icon
bool fits(const QAbstractButton& button, int contents) {
    const int icon = button.icon().isNull() ? 0 : button.iconSize().width() + 4;
    return button.fontMetrics().horizontalAdvance(withoutMnemonics(button.text())) + icon <= contents;
}

int contentsOf(const QAbstractButton& button, QStyle::SubElement element) {
    QStyleOptionButton option;
    option.initFrom(&button);
    option.text = button.text();
    option.icon = button.icon();
    option.iconSize = button.iconSize();
    return button.style()->subElementRect(element, &option, &button).width();
}

bool fits(const QWidget& widget) {
    if (qobject_cast<const ElidedLabel*>(&widget) != nullptr) return true;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return fits(*label);
    if (const auto* button = qobject_cast<const QPushButton*>(&widget))
        return fits(*button, contentsOf(*button, QStyle::SE_PushButtonContents));
    if (const auto* box = qobject_cast<const QCheckBox*>(&widget))
        return fits(*box, contentsOf(*box, QStyle::SE_CheckBoxContents));
    return true;
}

/// Whether a scroll area that can't go sideways cuts it off on a side.
bool isCutOff(const QWidget& widget) {
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        const auto* area = qobject_cast<const QScrollArea*>(parent);
        if (area == nullptr || !area->viewport()->isAncestorOf(&widget)) continue;
        const int left = widget.mapTo(area->viewport(), QPoint(0, 0)).x();
        if (left < 0 || left + widget.width() > area->viewport()->width()) return true;
    }
    return false;
}

} // namespace

std::vector<VisibleText> clippedTexts(QWidget& window) {
    std::vector<VisibleText> clipped;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || (fits(*widget) && !isCutOff(*widget))) continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const QString text = label != nullptr ? label->text() : button != nullptr ? button->text() : QString();
        clipped.push_back({nameOf(*widget), QStringLiteral("%1 (%2 px)").arg(text).arg(widget->width())});
    }
    return clipped;
}

std::vector<VisibleText> visibleTexts(QWidget& window) {
    std::vector<VisibleText> shown;
    const auto add = [&](const QString& where, const QStringList& texts) {
        for (QString text : texts)
            if (!text.remove(QChar(0x200B)).trimmed().isEmpty())
                shown.push_back({where, text}); // where lines may break
    };
    add(QStringLiteral("title"), {window.windowTitle()});
    for (const QWidget* widget : window.findChildren<QWidget*>())
        if (widget->isVisible()) add(nameOf(*widget), textsOf(*widget));
    for (const QMenu* menu : window.findChildren<QMenu*>())
        for (const QAction* action : menu->actions())
            add(action->objectName(), {action->text(), action->toolTip(), action->statusTip()});
    return shown;
}

} // namespace burin::testing
