// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/ui/window_driver.h"

#include <QDialog>
#include <QPointer>
#include <QSet>

#include <functional>

namespace burin::testing {

/// Opens every dialog that the menus offer now and, by their buttons that end with "…", those that they offer in turn.
/// Each is looked at once, open, and then rejected. Dialogs for files and colours, which are Qt's own, and questions
/// are only rejected.
class DialogWalk : public QObject {
public:
    using Look = std::function<void(QDialog& dialog)>;
    DialogWalk(WindowDriver& driver, Look look);
    void walk();
    const QSet<QString>& seen() const { return seen_; } ///< names of the dialogs that were looked at

private:
    void goOn();
    void act();
    void visit(QDialog& dialog);

    WindowDriver& driver_;
    Look look_;
    QSet<QString> seen_;
    QSet<QDialog*> open_; ///< whose visit is under way; some may be behind the dialog that they opened
};

} // namespace burin::testing
