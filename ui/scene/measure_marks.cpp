// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/measure_marks.h"

#include <cmath>

namespace burin {

namespace {

constexpr QPointF beside(14.0, 10.0); // device-independent pixels from the position to the text

} // namespace

void MeasureMarks::setPalette(const Palette& palette) {
    lines_.setColours(palette.chosenPath, palette.pathHalo);
    colour_ = palette.text;
    plate_ = palette.panel;
    plate_.setAlphaF(0.85F);
}

void MeasureMarks::set(const std::optional<MeasureMark>& mark) {
    mark_ = mark;
    lines_.set(mark ? mark->lines : PlaceChains{});
    label_.setVisible(mark && !mark->text.isEmpty());
}

void MeasureMarks::place(const CameraView& view, const QSizeF& size, double ratio) {
    if (!mark_ || mark_->text.isEmpty()) return;
    label_.set(mark_->text, colour_, plate_, ratio);
    label_.setUpperLeft((appearanceOf(view, size, mark_->place) + beside) * ratio,
                        static_cast<int>(std::lround(size.height() * ratio)));
}

} // namespace burin
