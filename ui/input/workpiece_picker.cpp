// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/workpiece_picker.h"

#include "core/volume/operations/ray_cast.h"

#include <utility>

namespace burin {

bool WorkpiecePicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    const VolumeSnapshot workpiece = shown_();
    if (workpiece.empty()) return false;
    const std::optional<RayHit> hit = castRay(workpiece, sightOf(event).seenOrigin(), event.rayDirection);
    taken_ = hit.has_value();
    if (hit) emit chosen(hit->place, event.rayDirection);
    return taken_;
}

bool WorkpiecePicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

bool WorkpiecePicker::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape) return false;
    emit cancelled();
    return true;
}

QString WorkpiecePicker::escapeMeaning() {
    return tr("Esc: end measuring");
}

} // namespace burin
