// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/shortcut_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize dialogSize(560, 560);
constexpr int placeRole = Qt::UserRole;

QString textOf(const QAction& action) {
    return action.iconText().remove(QChar(0x2026)); // "…"
}

QPushButton* makeButton(const QString& text, const QString& tip, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setAutoDefault(false);
    return button;
}

} // namespace

ShortcutDialog::ShortcutDialog(const std::vector<ShortcutRow>& rows, QWidget* parent) : QDialog(parent), rows_(rows) {
    setObjectName(QStringLiteral("shortcutDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    resize(dialogSize);
    auto* layout = new QVBoxLayout(this);
    search_ = new QLineEdit(this);
    search_->setObjectName(QStringLiteral("shortcutSearch"));
    search_->setPlaceholderText(tr("Search"));
    search_->setAccessibleName(tr("Search"));
    search_->setToolTip(tr("Show only actions whose name, tooltip or shortcut contains this."));
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    list_ = new QTreeWidget(this);
    list_->setObjectName(QStringLiteral("shortcutList"));
    list_->setAccessibleName(tr("Actions and their shortcuts"));
    list_->setHeaderLabels({tr("Action"), tr("Shortcut")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        auto* item = new QTreeWidgetItem(list_, {textOf(*rows_[i].action)});
        item->setData(0, placeRole, static_cast<int>(i));
        item->setToolTip(0, rows_[i].action->toolTip());
    }
    layout->addWidget(list_, 1);
    auto* line = new QHBoxLayout;
    keys_ = new QKeySequenceEdit(this);
    keys_->setObjectName(QStringLiteral("shortcutKeys"));
    keys_->setAccessibleName(tr("New shortcut"));
    keys_->setToolTip(tr("Click here and press the new shortcut."));
    line->addWidget(keys_, 1);
    assign_ =
        makeButton(tr("&Assign"), tr("Assign this shortcut to the selected action."), "assignShortcutButton", this);
    clear_ = makeButton(tr("&Remove"), tr("Remove the shortcut of the selected action."), "removeShortcutButton", this);
    reset_ = makeButton(tr("Re&set"), tr("Reset the shortcut of the selected action to its default."),
                        "resetShortcutButton", this);
    for (QPushButton* button : {assign_, clear_, reset_}) line->addWidget(button);
    layout->addLayout(line);
    conflict_ = new QLabel(this);
    conflict_->setObjectName(QStringLiteral("shortcutConflict"));
    conflict_->setWordWrap(true);
    layout->addWidget(conflict_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(QCoreApplication::translate("Buttons", "Close"));
    buttons->button(QDialogButtonBox::Close)->setToolTip(QCoreApplication::translate("Buttons", "Close this window."));
    QPushButton* all = makeButton(tr("Reset all"), tr("Reset the shortcuts of all actions to their defaults."),
                                  "resetShortcutsButton", this);
    buttons->addButton(all, QDialogButtonBox::ResetRole);
    layout->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(all, &QPushButton::clicked, this, &ShortcutDialog::resetAll);
    connect(search_, &QLineEdit::textChanged, this, &ShortcutDialog::showOnly);
    connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutDialog::choose);
    connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutDialog::refresh);
    connect(assign_, &QPushButton::clicked, this, [this] { assign(keys_->keySequence()); });
    connect(clear_, &QPushButton::clicked, this, [this] { assign({}); });
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (const ShortcutRow* row = chosen()) assign(row->first);
    });
    list_->setCurrentItem(list_->topLevelItem(0));
    refresh();
}

const ShortcutRow* ShortcutDialog::chosen() const {
    const QTreeWidgetItem* item = list_->currentItem();
    return item != nullptr ? &rows_[static_cast<std::size_t>(item->data(0, placeRole).toInt())] : nullptr;
}

const ShortcutRow* ShortcutDialog::holderOf(const QKeySequence& keys, const QAction* except) const {
    const auto found = std::ranges::find_if(rows_, [&](const ShortcutRow& row) {
        return row.action != except && !keys.isEmpty() && row.action->shortcut() == keys;
    });
    return found == rows_.end() ? nullptr : &*found;
}

void ShortcutDialog::choose() {
    if (const ShortcutRow* row = chosen()) keys_->setKeySequence(row->action->shortcut());
    refresh();
}

void ShortcutDialog::assign(const QKeySequence& keys) {
    const ShortcutRow* row = chosen();
    if (row == nullptr) return;
    if (const ShortcutRow* other = holderOf(keys, row->action)) other->action->setShortcut({});
    row->action->setShortcut(keys);
    keys_->setKeySequence(keys);
    refresh();
    emit changed();
}

void ShortcutDialog::resetAll() {
    for (const ShortcutRow& row : rows_) row.action->setShortcut(row.first);
    choose();
    emit changed();
}

void ShortcutDialog::showOnly(const QString& text) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const bool fits = item->text(0).contains(text, Qt::CaseInsensitive) ||
                          item->text(1).contains(text, Qt::CaseInsensitive) ||
                          item->toolTip(0).contains(text, Qt::CaseInsensitive);
        item->setHidden(!fits);
    }
}

void ShortcutDialog::refresh() {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const ShortcutRow& row = rows_[static_cast<std::size_t>(item->data(0, placeRole).toInt())];
        item->setText(1, row.action->shortcut().toString(QKeySequence::NativeText));
        QFont own = list_->font();
        own.setBold(row.action->shortcut() != row.first);
        item->setFont(1, own);
    }
    const ShortcutRow* row = chosen();
    const QKeySequence keys = keys_->keySequence();
    assign_->setEnabled(row != nullptr && keys != row->action->shortcut());
    clear_->setEnabled(row != nullptr && !row->action->shortcut().isEmpty());
    reset_->setEnabled(row != nullptr && row->action->shortcut() != row->first);
    const ShortcutRow* other = row != nullptr ? holderOf(keys, row->action) : nullptr;
    conflict_->setText(other != nullptr ? tr("“%1” has this shortcut and would lose it.").arg(textOf(*other->action))
                                        : QString());
}

} // namespace burin
