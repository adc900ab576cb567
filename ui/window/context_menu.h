// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <functional>

class QMenu;
class QWidget;

namespace burin {

/// Creates a menu of the actions on one object, with its title. Deletes itself when closed.
QMenu* makeContextMenu(const char* name, const QString& title, QWidget* parent);
/// @param name object name of the action
void addEntry(QMenu& menu, const QString& text, const QString& tip, const char* name, const std::function<void()>& use);
/// Asks for a name. Empty if none was given.
QString askName(const QString& title, const QString& before, QWidget* parent);

} // namespace burin
