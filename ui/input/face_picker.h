// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/body_picker.h"

namespace burin {

/// Picks a point on a model: the next click on it selects the point, Esc cancels. Thread: user interface.
class FacePicker : public BodyPicker {
    Q_OBJECT
public:
    using BodyPicker::BodyPicker;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;

signals:
    void cancelled();
};

} // namespace burin
