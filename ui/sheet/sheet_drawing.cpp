// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/sheet_drawing.h"

#include <chrono>
#include <utility>

namespace burin {

namespace {

constexpr std::chrono::milliseconds betweenTurns(20); // the mesher's time, and the user's

} // namespace

SheetDrawing::SheetDrawing(std::shared_ptr<const SheetContent> content, LengthUnit unit, QObject* parent)
    : QObject(parent), content_(std::move(content)), unit_(unit) {
    connect(&turn_, &QTimer::timeout, this, &SheetDrawing::goOn);
    turn_.start(betweenTurns);
}

/// One thing a turn: none holds the thread up for long.
void SheetDrawing::goOn() {
    if (pictures_.size() == sheetViews.size()) {
        turn_.stop();
        emit drawn(setupSheet(*content_, unit_, pictures_));
    } else if (!drawing_) {
        Result<PictureDrawing> begun = PictureDrawing::begin(sheetPicture(*content_));
        if (!begun) {
            turn_.stop();
            emit drawn(begun.error());
            return;
        }
        drawing_ = std::move(*begun);
    } else if (drawing_->ready()) {
        pictures_.push_back(drawing_->draw(sheetViews[pictures_.size()]));
    }
}

} // namespace burin
