// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/sheet_drawing.h"

#include <chrono>
#include <utility>

namespace burin {

namespace {

constexpr std::chrono::milliseconds betweenTurns(20); // time for the mesher and for the user's input

} // namespace

void SheetHandover::report(double fraction) {
    const std::lock_guard lock(guard_);
    fraction_ = fraction;
}

void SheetHandover::give(Result<std::string> page) {
    const std::lock_guard lock(guard_);
    page_ = std::move(page);
    given_.notify_one();
}

Result<std::string> SheetHandover::wait(Progress& progress) {
    std::unique_lock lock(guard_);
    while (!given_.wait_for(lock, std::chrono::milliseconds(50), [this] { return page_.has_value(); })) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "setup sheet", {}, {}};
        progress.report(fraction_);
    }
    return std::move(*page_);
}

SheetDrawing::SheetDrawing(std::shared_ptr<const SheetContent> content, LengthUnit unit,
                           std::weak_ptr<SheetHandover> to, QObject* parent)
    : QObject(parent), content_(std::move(content)), unit_(unit), to_(std::move(to)) {
    connect(&turn_, &QTimer::timeout, this, &SheetDrawing::goOn);
    turn_.start(betweenTurns);
}

/// One step in each call, so that the thread is never blocked for long.
void SheetDrawing::goOn() {
    const std::shared_ptr<SheetHandover> to = to_.lock();
    if (!to) {
        end();
    } else if (pictures_.size() == sheetViews.size()) {
        to->give(setupSheet(*content_, unit_, pictures_));
        end();
    } else if (!drawing_) {
        Result<PictureDrawing> begun = PictureDrawing::begin(sheetPicture(*content_));
        if (!begun) {
            to->give(begun.error());
            end();
            return;
        }
        drawing_ = std::move(*begun);
    } else if (drawing_->ready()) {
        pictures_.push_back(drawing_->draw(sheetViews[pictures_.size()]));
        to->report(static_cast<double>(pictures_.size()) / static_cast<double>(sheetViews.size()));
    }
}

void SheetDrawing::end() {
    turn_.stop();
    deleteLater();
}

Result<std::string> drawSheet(QObject& owner, const std::shared_ptr<const SheetContent>& content,
                              std::function<LengthUnit()> unit, Progress& progress) {
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "setup sheet", {}, {}};
    const auto handover = std::make_shared<SheetHandover>();
    QMetaObject::invokeMethod(&owner, [&owner, content, unit = std::move(unit), to = std::weak_ptr(handover)] {
        new SheetDrawing(content, unit(), to, &owner); // deletes itself
    });
    return handover->wait(progress);
}

} // namespace burin
