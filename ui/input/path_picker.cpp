// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/path_picker.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

double distanceToLine(const QPointF& place, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0) : 0.0;
    const QPointF off = place - (from + share * along);
    return std::hypot(off.x(), off.y());
}

} // namespace

PathPicker::PathPicker(std::function<QPointF(const glm::dvec3&)> appearance, QObject* parent)
    : QObject(parent), appearance_(std::move(appearance)) {}

bool PathPicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    double nearest = reach;
    std::optional<std::size_t> move;
    for (std::size_t i = 0; i < moves_.size(); ++i) {
        const double distance =
            distanceToLine(event.position, appearance_(moves_[i].first), appearance_(moves_[i].second));
        if (distance >= nearest) continue;
        nearest = distance;
        move = i;
    }
    taken_ = move.has_value();
    if (move) emit chosen(*move);
    return taken_;
}

bool PathPicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

} // namespace burin
