// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"

#include <QMenu>
#include <QMenuBar>
#include <QObject>

namespace burin {

/// The menu bar: which action stands where.
class Menus final : public QObject {
    Q_OBJECT
public:
    Menus(QMenuBar& bar, const Actions& actions);
    void setRecentFiles(const QStringList& files);

signals:
    void recentChosen(const QString& file);

private:
    QMenu* recent_ = nullptr;
};

} // namespace burin
