// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/sheet_controller.h"

#include <memory>
#include <utility>

namespace burin {

void SheetController::gather(const QString& project, const QString& file) {
    if (gathering()) return;
    asked_ = true;
    emit changed();
    desk_.project.ask([name = project.toStdString()](const Project& asked) { return sheetSource(asked, name); },
                      [this, file](Result<SheetSource> source) {
                          asked_ = false;
                          if (source)
                              embed(std::move(*source), file);
                          else
                              emit failed(source.error());
                          emit changed();
                      });
}

void SheetController::embed(SheetSource source, const QString& file) {
    desk_.tasks.start(
        TaskKind::sheet, tr("Preparing the setup sheet"),
        [source = std::move(source)](Progress& progress) -> Result<std::shared_ptr<const SheetContent>> {
            Result<SheetContent> content = sheetContent(source, progress);
            if (!content) return std::move(content).error();
            return std::make_shared<const SheetContent>(std::move(*content));
        },
        [this, file](const Result<std::shared_ptr<const SheetContent>>& content) {
            if (content)
                emit gathered(*content, file);
            else if (content.error().code != ErrorCode::cancelled)
                emit failed(content.error());
            emit changed();
        });
}

} // namespace burin
