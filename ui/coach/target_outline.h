// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/pointed.h"

namespace burin {

/// A frame around the target of the coach, over the window or menu that contains it. It ignores mouse and keyboard.
class TargetOutline final : public QWidget {
    Q_OBJECT
public:
    explicit TargetOutline(QWidget* window);
    /// Hides the frame if nothing visible is meant. @param panel stays above the frame if both are in the same window
    void surround(const Pointed& pointed, QWidget& panel);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace burin
