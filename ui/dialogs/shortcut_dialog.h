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

/// An action with the keys that it has at first.
struct ShortcutRow {
    QAction* action = nullptr; ///< outlives the dialog
    QKeySequence first;
};

/// All actions with their keys, which can be changed: at once, for as long as nobody resets them. Keys that another
/// action has are taken from it, and the dialog says so before.
class ShortcutDialog final : public QDialog {
    Q_OBJECT
public:
    explicit ShortcutDialog(const std::vector<ShortcutRow>& rows, QWidget* parent = nullptr);

signals:
    void changed(); ///< keys of some action

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
