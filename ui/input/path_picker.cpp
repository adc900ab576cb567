// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/path_picker.h"

#include <utility>

namespace burin {

PathPicker::PathPicker(Appearance appearance, QObject* parent) : QObject(parent), appearance_(std::move(appearance)) {}

bool PathPicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    const auto place = nearestPlace(
        event.position, moves_.size(),
        [this](std::size_t i) -> std::optional<PathPiece> {
            return PathPiece{moves_[i].first, moves_[i].second};
        },
        appearance_);
    taken_ = place.has_value();
    if (place) emit chosen(place->piece);
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
