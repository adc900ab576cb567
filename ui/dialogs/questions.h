// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QWidget;

namespace burin {

enum class UnsavedAnswer { save, discard, cancel };

/// Asks whether to save unsaved changes. Dialog "unsavedDialog" with "saveButton", "discardButton", "cancelButton".
UnsavedAnswer askUnsaved(QWidget* parent, const QString& project);

/// Asks before something is deleted that undo can't restore. Dialog "confirmDialog" with "confirmButton",
/// "cancelButton".
bool confirm(QWidget* parent, const QString& question, const QString& consequence, const QString& confirmText);

/// Asks for the reason why a program that its check refused is exported nevertheless. Dialog "reasonDialog" with
/// "reasonField", "confirmButton" (only with a reason), "cancelButton". @param findings of the check, > 0
/// @return trimmed; empty: cancelled
QString askOverride(QWidget* parent, int findings);

/// Dialog "aboutDialog". @param version of the program
void showAbout(QWidget* parent, const QString& version);

} // namespace burin
