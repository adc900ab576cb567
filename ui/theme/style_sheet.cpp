// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/style_sheet.h"

#include "core/base/file.h"
#include "ui/theme/colour.h"

#include <QDir>

#include <algorithm>
#include <vector>

namespace burin {

namespace {

// @name is a placeholder for a colour or a folder. A rule for every widget would nearly double the time to change the
// theme: common properties, such as the colours of a selection, come from the palette.
constexpr const char* rules = R"(
QMainWindow, QDialog { background: @panel; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QToolTip, QLabel[look="message"] { background: @field; color: @text; border: 1px solid @border; border-radius: 4px; padding: 4px 6px; }

QLabel[look="title"] { font-size: 11pt; font-weight: 600; }
QLabel[look="section"] { color: @quietText; font-size: 8pt; font-weight: 600; }
QLabel[look="quiet"] { color: @quietText; }
QLabel[look="small"] { color: @quietText; font-size: 9pt; }
QLabel[look="key"] { background: @button; border-radius: 4px; padding: 1px 6px; font-size: 8.5pt; }
QLabel[look="accent"] { color: @accent; }
QLabel[look="force"] { color: @force; }
QLabel[look="inOrder"] { color: @inOrder; }
QLabel[look="badge"] { color: @accent; border: 1px solid @accentEdge; border-radius: 4px; padding: 0px 4px;
    font-size: 8pt; }
QLabel:disabled { color: @disabled; }
QFrame[look="card"] { background: @card; border: none; border-radius: 8px; }
QFrame[look="line"] { background: @border; border: none; max-height: 1px; }

QPushButton, QToolButton { background: @button; color: @text; border: 1px solid @button; border-radius: 8px;
    padding: 7px 10px; }
QToolButton { padding: 6px; }
QPushButton:hover, QToolButton:hover { background: @buttonHover; border-color: @buttonHover; }
QPushButton:pressed, QToolButton:pressed { background: @buttonPressed; border-color: @buttonPressed; }
QPushButton:focus, QToolButton:focus { border-color: @focus; }
QPushButton:disabled, QToolButton:disabled { background: @buttonOff; border-color: @buttonOff; color: @disabled; }
QPushButton[look="primary"] { background: @accent; border-color: @accent; color: @onAccent; font-weight: 600; }
QPushButton[look="primary"]:hover { background: @accentHover; border-color: @accentHover; }
QPushButton[look="primary"]:pressed { background: @accentPressed; border-color: @accentPressed; }
QPushButton[look="primary"]:focus { border: 2px solid @text; padding: 6px 9px; }
QPushButton[look="primary"]:disabled { background: @buttonOff; border-color: @buttonOff; color: @disabled; }
QPushButton[look="record"] { background: @forceFill; border-color: @force; color: @force; font-weight: 600; }
QPushButton[look="record"]:hover { background: @forceHover; }
QPushButton[look="record"]:focus { border: 2px solid @text; padding: 6px 9px; }
QPushButton[look="record"]:checked { background: @force; border-color: @force; color: @onForce; }
QPushButton[look="record"]:disabled { background: @buttonOff; border-color: @buttonOff; color: @disabled; }
QPushButton[look="choice"] { border-radius: 6px; padding: 5px 8px; background: @field; border-color: @border; }
QPushButton[look="choice"]:hover { background: @button; }
QPushButton[look="choice"]:checked { background: @accentFill; border-color: @accent; color: @accent; }
QPushButton[look="choice"]:focus { border-color: @focus; }
QPushButton[look="choice"]:disabled { color: @disabled; background: @panel; }
QPushButton[look="choice"]:checked:disabled { border-color: @border; }
QToolButton[look="flat"] { background: transparent; border-color: transparent; padding: 4px; }
QToolButton[look="flat"]:hover { background: @button; }
QToolButton[look="flat"]:focus { border-color: @focus; }
QToolButton[look="toggle"] { background: transparent; border-color: transparent; padding: 4px; }
QToolButton[look="toggle"]:hover { background: @button; }
QToolButton[look="toggle"]:checked { background: @accentFill; border-color: @accent; }
QToolButton[look="toggle"]:focus { border-color: @focus; }
QToolButton::menu-indicator { image: none; }

QLineEdit, QAbstractSpinBox, QComboBox { background: @field; color: @text; border: 1px solid @border;
    border-radius: 6px; padding: 5px 8px; min-height: 18px; }
QLineEdit:hover, QAbstractSpinBox:hover, QComboBox:hover { border-color: @borderHover; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border: 2px solid @focus; padding: 4px 7px; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: @disabled; background: @panel; }
QComboBox::drop-down { border: none; width: 26px; subcontrol-position: center right; }
QComboBox::down-arrow { image: url("@icons/chevron-down.svg"); width: 12px; height: 12px; }
QComboBox { combobox-popup: 0; }
QComboBox QAbstractItemView { background: @field; border: 1px solid @border; border-radius: 6px; padding: 4px;
    outline: none; }

QCheckBox, QRadioButton { spacing: 8px; border: 1px solid transparent; border-radius: 4px; padding: 2px; }
QCheckBox:focus, QRadioButton:focus { border-color: @focus; }
QCheckBox:disabled { color: @disabled; }
QCheckBox::indicator, QRadioButton::indicator, QTreeView::indicator { width: 16px; height: 16px; border: 1px solid @controlEdge;
    border-radius: 4px; background: @field; }
QRadioButton::indicator { border-radius: 8px; }
QTreeView::indicator { width: 12px; height: 12px; }
QCheckBox::indicator:hover, QRadioButton::indicator:hover, QTreeView::indicator:hover { border-color: @accent; }
QCheckBox::indicator:checked, QTreeView::indicator:checked { background: @accent; border-color: @accent; image: url("@icons/@tick.svg"); }
QRadioButton::indicator:checked { background: @accent; border: 4px solid @field; }
QCheckBox::indicator:disabled { border-color: @border; background: @panel; }
QCheckBox::indicator:checked:disabled { background: @border; }

QAbstractScrollArea { border: none; background: transparent; }
QListView, QTreeView, QTableView, QPlainTextEdit, QTextBrowser { background: @field; border: 1px solid @border;
    border-radius: 8px; outline: none; }
QListView:focus, QTreeView:focus, QTableView:focus, QPlainTextEdit:focus { border-color: @focus; }
QListView::item, QTreeView::item { border-radius: 4px; padding: 3px; }
QListView::item:hover, QTreeView::item:hover { background: @button; }
QListView::item:selected, QTreeView::item:selected { background: @accentFill; color: @text; }
QHeaderView::section { background: transparent; color: @quietText; border: none; padding: 4px; }
QScrollBar { background: transparent; border: none; }
QScrollBar:vertical { width: 10px; }
QScrollBar:horizontal { height: 10px; }
QScrollBar::handle { background: @scrollHandle; border-radius: 3px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 32px; }
QScrollBar::handle:horizontal { min-width: 32px; }
QScrollBar::handle:hover { background: @quietText; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0px; height: 0px; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QMenuBar { background: @window; color: @text; border: none; padding: 2px 4px; }
QMenuBar::item { background: transparent; padding: 5px 10px; border-radius: 6px; }
QMenuBar::item:selected, QMenuBar::item:pressed { background: @button; }
QMenu { background: @panel; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 6px 24px 6px 12px; border-radius: 4px; }
QMenu::item:selected { background: @accentFill; }
QMenu::item:disabled { color: @disabled; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
QMenu::icon { padding-left: 8px; }
QStatusBar { background: @window; color: @quietText; }
QStatusBar::item { border: none; }
QStatusBar QLabel[look="force"] { color: @force; font-weight: 600; }
QToolBar { background: @window; border: none; spacing: 4px; padding: 4px; }
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; }
QSplitter::handle { background: @window; }
QProgressBar { background: @field; border: none; border-radius: 3px; min-height: 6px; max-height: 6px; color: transparent; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QTabBar::tab { background: transparent; color: @quietText; padding: 6px 12px; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabWidget::pane { border: none; }
)";

using Replacement = std::pair<QString, QString>;

std::vector<Replacement> replacements(const Palette& palette) {
    std::vector<Replacement> named;
    const auto colour = [&named](const char* name, const QColor& value) {
        named.emplace_back(QLatin1Char('@') + QLatin1String(name), value.name());
    };
    const QColor button = mixed(palette.panel, palette.text, 0.08);
    colour("window", palette.window);
    colour("panel", palette.panel);
    colour("field", palette.field);
    colour("border", palette.border);
    colour("borderHover", mixed(palette.border, palette.text, 0.25));
    colour("controlEdge", mixed(palette.border, palette.text, 0.35));
    colour("text", palette.text);
    colour("quietText", palette.quietText);
    colour("disabled", mixed(palette.panel, palette.quietText, 0.65));
    colour("accent", palette.accent);
    colour("onAccent", readableOn(palette.accent));
    colour("accentHover", mixed(palette.accent, palette.text, 0.12));
    colour("accentPressed", mixed(palette.accent, palette.panel, 0.2));
    colour("accentFill", mixed(palette.panel, palette.accent, 0.16));
    colour("accentEdge", mixed(palette.panel, palette.accent, 0.5));
    colour("focus", palette.part);
    colour("force", palette.force);
    colour("onForce", readableOn(palette.force));
    colour("forceFill", mixed(palette.panel, palette.force, 0.12));
    colour("forceHover", mixed(palette.panel, palette.force, 0.2));
    colour("inOrder", palette.inOrder);
    colour("button", button);
    colour("buttonHover", mixed(palette.panel, palette.text, 0.14));
    colour("buttonPressed", mixed(palette.panel, palette.text, 0.2));
    colour("buttonOff", mixed(palette.panel, palette.text, 0.04));
    colour("card", mixed(palette.panel, palette.text, 0.04));
    colour("scrollHandle", mixed(palette.panel, palette.text, 0.25));
    const QString folder = QString::fromStdString((resourceDirectory() / "icons").string());
    named.emplace_back(QStringLiteral("@icons"), QDir::fromNativeSeparators(folder));
    const bool darkTick = readableOn(palette.accent).lightness() < 128;
    named.emplace_back(QStringLiteral("@tick"), darkTick ? QStringLiteral("tick-dark") : QStringLiteral("tick-light"));
    // "@accent" is a prefix of "@accentFill": replace longer names first.
    std::ranges::sort(named, std::greater(), [](const Replacement& one) { return one.first.size(); });
    return named;
}

} // namespace

QString styleSheet(const Palette& palette) {
    QString sheet = QString::fromLatin1(rules);
    for (const auto& [name, value] : replacements(palette)) sheet.replace(name, value);
    return sheet;
}

} // namespace burin
