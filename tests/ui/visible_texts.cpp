// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/visible_texts.h"

#include "ui/panels/elided_label.h"
#include "ui/panels/row_list.h"
#include "ui/panels/step_button.h"
#include "ui/theme/number_font.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionButton>
#include <QToolButton>
#include <QToolTip>

namespace burin::testing {

namespace {

/// All texts that one widget shows.
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

/// @param contents  width that the style leaves for the button's text and icon
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

/// The tooltip of a widget; empty if there is none.
QString toolTipOf(QWidget& widget) {
    const QPoint middle = widget.rect().center(), onScreen = widget.mapToGlobal(middle);
    const QString before = QStringLiteral("of another widget");
    QToolTip::showText(onScreen, before, &widget);
    QHelpEvent rest(QEvent::ToolTip, middle, onScreen);
    QApplication::sendEvent(&widget, &rest);
    const QString told = QToolTip::text();
    QToolTip::hideText();
    return told == before ? QString() : told;
}

/// The text may end in "…" if the tooltip shows all of it.
bool isToldInWhole(QWidget& widget, const QString& text, int room) {
    return widget.fontMetrics().horizontalAdvance(text) <= room || toolTipOf(widget).contains(text);
}

bool fits(QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return isToldInWhole(box, box.currentText(), room.width());
}

/// @param index  of a visible row
bool isToldInWhole(RowList& list, int index) {
    const ListRow& row = list.rows()[static_cast<std::size_t>(index)];
    const QRect place = list.visualItemRect(list.item(index));
    const QPoint onScreen = list.viewport()->mapToGlobal(place.center());
    QToolTip::hideText();
    QHelpEvent rest(QEvent::ToolTip, place.center(), onScreen);
    QApplication::sendEvent(list.viewport(), &rest);
    const QString told = QToolTip::text();
    QToolTip::hideText();
    // Both lines begin after the icon or swatch; the first one ends before what is shown at its right.
    constexpr int margins = 16, iconRoom = 24, swatchRoom = 18, gap = 8;
    const int room = place.width() - margins - (!row.icon.isEmpty() ? iconRoom : row.swatch.isValid() ? swatchRoom : 0);
    const QFont figures = numberFont(list.font());
    QFont small = figures;
    small.setPointSizeF(0.88 * small.pointSizeF());
    const auto width = [](const QFont& font, const QString& text) {
        return text.isEmpty() ? 0 : QFontMetrics(font).horizontalAdvance(text);
    };
    const auto behind = [&](const QFont& font, const QString& text) {
        return text.isEmpty() ? 0 : width(font, text) + gap;
    };
    const int title = room - behind(figures, row.value) - (row.badge.isEmpty() ? 0 : behind(small, row.badge) + gap);
    return (width(list.font(), row.title) <= title || told.contains(row.title)) &&
           (width(small, row.detail) <= room || told.contains(row.detail));
}

/// Sentences over several lines are as high as they need; otherwise each row has a tooltip for the text that ends in
/// "…".
bool fits(RowList& list) {
    for (int i = 0; i < list.count(); ++i) {
        const QRect place = list.visualItemRect(list.item(i));
        const bool wraps = place.height() > 3 * list.fontMetrics().lineSpacing();
        if (!wraps && place.intersects(list.viewport()->rect()) && !isToldInWhole(list, i)) return false;
    }
    return true;
}

/// A number field with its unit, or a text field, unless its tooltip shows the text.
bool fits(const QLineEdit& field) {
    constexpr int cursorRoom = 4; // pixels
    const QString& text = field.text().isEmpty() ? field.placeholderText() : field.text();
    const QMargins margins = field.textMargins();
    const int room = field.contentsRect().width() - margins.left() - margins.right() - cursorRoom;
    return field.hasFocus() || (!text.isEmpty() && field.toolTip().contains(text)) ||
           field.fontMetrics().horizontalAdvance(text) <= room;
}

/// The second line of a step: its summary.
bool fits(StepButton& step) {
    const QString progress = step.accessibleDescription().section(QStringLiteral(": "), 0, 0);
    const QString line = step.accessibleDescription().mid(progress.size() + 2);
    return toolTipOf(step).contains(line) && toolTipOf(step).contains(step.text());
}

bool fits(QWidget& widget) {
    if (auto* elided = qobject_cast<ElidedLabel*>(&widget))
        return isToldInWhole(*elided, elided->text(), elided->contentsRect().width());
    if (auto* choice = qobject_cast<QComboBox*>(&widget)) return fits(*choice);
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) return fits(*field);
    if (auto* list = qobject_cast<RowList*>(&widget)) return fits(*list);
    if (auto* step = qobject_cast<StepButton*>(&widget)) return fits(*step);
    if (const auto* tool = qobject_cast<const QToolButton*>(&widget))
        return tool->width() >= tool->minimumSizeHint().width();
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return fits(*label);
    if (const auto* button = qobject_cast<const QPushButton*>(&widget))
        return fits(*button, contentsOf(*button, QStyle::SE_PushButtonContents));
    if (const auto* box = qobject_cast<const QCheckBox*>(&widget))
        return fits(*box, contentsOf(*box, QStyle::SE_CheckBoxContents));
    return true;
}

/// Whether a side of the widget is cut off by the window or by a scroll area that cannot scroll sideways.
bool isCutOff(const QWidget& widget) {
    if (widget.mapTo(widget.window(), QPoint(widget.width(), 0)).x() > widget.window()->width()) return true;
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
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || (fits(*widget) && !isCutOff(*widget))) continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const auto* choice = qobject_cast<const QComboBox*>(widget);
        const auto* field = qobject_cast<const QLineEdit*>(widget);
        const QString text = label != nullptr    ? label->text()
                             : button != nullptr ? button->text()
                             : choice != nullptr ? choice->currentText()
                             : field != nullptr  ? field->text() + field->placeholderText()
                                                 : QString();
        clipped.push_back({nameOf(*widget), QStringLiteral("%1 (%2 px)").arg(text).arg(widget->width())});
    }
    return clipped;
}

std::vector<VisibleText> visibleTexts(QWidget& window) {
    std::vector<VisibleText> shown;
    const auto add = [&](const QString& where, const QStringList& texts) {
        for (QString text : texts)
            if (!text.remove(QChar(0x200B)).trimmed().isEmpty())
                shown.push_back({where, text}); // U+200B marks where lines may break
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
