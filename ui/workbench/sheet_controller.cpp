// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/sheet_controller.h"

#include "core/base/file.h"

#include <filesystem>
#include <memory>
#include <utility>

namespace burin {

namespace {

constexpr double shareOfPreparing = 0.6; // of the time; the rest is drawing

} // namespace

void SheetController::write(const QString& project, const QString& file) {
    if (writing()) return;
    asked_ = true;
    emit changed();
    desk_.project.ask([name = project.toStdString()](const Project& asked) { return sheetSource(asked, name); },
                      [this, file](Result<SheetSource> source) {
                          asked_ = false;
                          if (source)
                              make(std::move(*source), file);
                          else
                              emit failed(source.error());
                          emit changed();
                      });
}

void SheetController::make(SheetSource source, const QString& file) {
    desk_.tasks.start(
        TaskKind::sheet, tr("Preparing the setup sheet"),
        [source = std::move(source), draw = draw_,
         path = std::filesystem::path(file.toStdString())](Progress& progress) -> Result<void> {
            std::shared_ptr<const SheetContent> shared;
            {
                const ProgressPart part(progress, 0.0, shareOfPreparing);
                Result<SheetContent> content = sheetContent(source, progress);
                if (!content) return std::move(content).error();
                shared = std::make_shared<const SheetContent>(std::move(*content));
            }
            const ProgressPart part(progress, shareOfPreparing, 1.0);
            const Result<std::string> page = draw(shared, progress);
            return page ? writeFileAtomically(path, *page) : Result<void>(page.error());
        },
        [this, file](const Result<void>& made) {
            if (made)
                emit written(file);
            else if (made.error().code != ErrorCode::cancelled)
                emit failed(made.error());
            emit changed();
        });
}

} // namespace burin
