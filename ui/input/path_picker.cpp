// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/path_picker.h"

#include <utility>

namespace burin {

PathPicker::PathPicker(Appearance appearance, QObject* parent) : QObject(parent), appearance_(std::move(appearance)) {}

bool PathPicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    const auto move = nearestSegment(
        event.position, moves_.size(), [this](std::size_t i) { return moves_[i]; }, appearance_);
    taken_ = move.has_value();
    if (move) emit chosen(*move);
    return taken_;
}

bool PathPicker::move(const ViewportEvent& event) {
    if (event.buttons == Qt::NoButton) emit hovered(event.position);
    return taken_;
}

bool PathPicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

} // namespace burin
