// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "ui/scene/picture.h"
#include "ui/sheet/setup_sheet.h"

#include <QObject>
#include <QTimer>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Passes a page from the thread that draws it to the one that waits for it.
class SheetHandover {
public:
    void report(double fraction); ///< drawing thread. @param fraction that is done, 0 … 1
    void give(Result<std::string> page);
    /// Waits for the page, and passes its progress on. Errors: cancelled, those of `give`.
    Result<std::string> wait(Progress& progress);

private:
    std::mutex guard_;
    std::condition_variable given_;
    double fraction_ = 0.0;
    std::optional<Result<std::string>> page_;
};

/// Draws the pictures of a setup sheet between the events of the user interface, makes the page from them, gives it to
/// `to` and deletes itself. Stops when nobody waits any more.
class SheetDrawing final : public QObject {
    Q_OBJECT
public:
    SheetDrawing(std::shared_ptr<const SheetContent> content, LengthUnit unit, std::weak_ptr<SheetHandover> to,
                 QObject* parent);

private:
    void goOn();
    void end();

    std::shared_ptr<const SheetContent> content_;
    LengthUnit unit_;
    std::weak_ptr<SheetHandover> to_;
    std::vector<std::string> pictures_; ///< PNG, those drawn so far
    std::optional<PictureDrawing> drawing_;
    QTimer turn_;
};

/// Has a sheet drawn in the thread of `owner`, the user interface's, and waits for the page in the calling one, another
/// thread. @param owner outlives the call @param unit asked in the thread of `owner`. Errors: those of
/// PictureDrawing::begin, cancelled.
Result<std::string> drawSheet(QObject& owner, const std::shared_ptr<const SheetContent>& content,
                              std::function<LengthUnit()> unit, Progress& progress);

} // namespace burin
