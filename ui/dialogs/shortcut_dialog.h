// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QKeySequence>

#include <vector>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace burin {

/// An action with its default shortcut.
struct ShortcutRow {
    QAction* action = nullptr; ///< outlives the dialog
    QKeySequence first;
};

/// Lists all actions with their shortcuts, which can be changed: at once, until they are reset. A shortcut used by
/// another action is removed from it; the dialog announces this before.
class ShortcutDialog final : public QDialog {
    Q_OBJECT
public:
    explicit ShortcutDialog(const std::vector<ShortcutRow>& rows, QWidget* parent = nullptr);

signals:
    void changed(); ///< the shortcut of some action

private:
    void choose();
    void assign(const QKeySequence& keys);
    void resetAll();
    void showOnly(const QString& text);
    void refresh();
    const ShortcutRow* chosen() const;
    const ShortcutRow* holderOf(const QKeySequence& keys, const QAction* except) const;

    std::vector<ShortcutRow> rows_;
    QLineEdit* search_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QKeySequenceEdit* keys_ = nullptr;
    QLabel* conflict_ = nullptr;
    QPushButton *assign_ = nullptr, *clear_ = nullptr, *reset_ = nullptr;
};

} // namespace burin
