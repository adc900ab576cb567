// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/sheet_content.h"
#include "ui/workbench/controller.h"

#include <QString>

namespace burin {

/// Gathers what the sheet of the setup in use tells, in the background: how the stock lies before anything is milled is
/// made anew for it.
class SheetController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;
    bool gathering() const { return asked_ || desk_.tasks.running(TaskKind::sheet); }
    /// @param project its title @param file where the sheet is to be written, handed on to `gathered`
    void gather(const QString& project, const QString& file);

signals:
    void gathered(const std::shared_ptr<const burin::SheetContent>& content, const QString& file);

private:
    void embed(SheetSource source, const QString& file);
    bool asked_ = false; ///< the project is being read
};

} // namespace burin
