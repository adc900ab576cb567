// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/face_picker.h"

namespace burin {

bool FacePicker::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape) return false;
    emit cancelled();
    return true;
}

QString FacePicker::escapeMeaning() {
    return tr("Esc: cancel the selection of a face");
}

} // namespace burin
