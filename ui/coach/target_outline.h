// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/pointed.h"

namespace burin {

/// A frame around what the coach points at, over the window or menu that this is in. It takes no mouse and no keyboard.
class TargetOutline final : public QWidget {
    Q_OBJECT
public:
    explicit TargetOutline(QWidget* window);
    void surround(const Pointed& pointed); ///< nothing that is seen: it is hidden

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace burin
