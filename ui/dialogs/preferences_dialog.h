// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/dialogs/preferences.h"

#include <QDialog>

class QComboBox;

namespace burin {

/// Unit, theme and language. A change takes effect at once; that of the language at the next start.
class PreferencesDialog final : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(const Preferences& preferences, QWidget* parent = nullptr);
    Preferences preferences() const;

signals:
    void preferencesChanged(const burin::Preferences& preferences);

private:
    QComboBox* unit_ = nullptr;
    QComboBox* theme_ = nullptr;
    QComboBox* language_ = nullptr;
};

} // namespace burin
