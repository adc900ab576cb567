// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/help/key_list.h"

#include <QMenu>
#include <QMenuBar>
#include <QObject>

namespace burin {

/// The menu bar: the order of the actions.
class Menus final : public QObject {
    Q_OBJECT
public:
    Menus(QMenuBar& bar, const Actions& actions);
    /// Shortcuts, menu by menu.
    std::vector<KeySection> keys() const;
    void setRecentFiles(const QStringList& files);

signals:
    void recentChosen(const QString& file);

private:
    QMenuBar& bar_;
    QMenu* recent_ = nullptr;
};

} // namespace burin
