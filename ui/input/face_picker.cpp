// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/face_picker.h"

#include "ui/input/body_picker.h"

#include <optional>
#include <utility>

namespace burin {

bool FacePicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton || !model_) return false;
    const std::optional<SeenBody> seen = bodyOn(sightOf(event), *model_);
    taken_ = seen.has_value();
    if (seen) emit picked(seen->place);
    return taken_;
}

bool FacePicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

bool FacePicker::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape) return false;
    emit cancelled();
    return true;
}

QString FacePicker::escapeMeaning() {
    return tr("Esc: pick no face");
}

} // namespace burin
