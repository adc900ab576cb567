// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/sheet_content.h"
#include "ui/workbench/controller.h"

#include <QString>

#include <functional>
#include <memory>
#include <string>

namespace burin {

/// Writes the setup sheet of the setup in use, in the background; the stock before any milling is embedded again for
/// it.
class SheetController final : public Controller {
    Q_OBJECT
public:
    /// Makes the page of a sheet, HTML. Called in a thread of the task; may wait for the user interface's thread.
    using Draw = std::function<Result<std::string>(const std::shared_ptr<const SheetContent>&, Progress&)>;

    using Controller::Controller;
    void setDraw(Draw draw) { draw_ = std::move(draw); } ///< before the first `write`
    /// A sheet is being prepared, drawn or written.
    bool writing() const { return asked_ || desk_.tasks.running(TaskKind::sheet); }
    /// @param project its title @param file is written completely or not at all
    void write(const QString& project, const QString& file);

signals:
    void written(const QString& file);

private:
    void make(SheetSource source, const QString& file);

    Draw draw_;
    bool asked_ = false; ///< the project is being read
};

} // namespace burin
