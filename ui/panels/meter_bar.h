// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QWidget>

namespace burin {

/// A bar next to a number that shows the value's share of its scale. Its accessible description is the share in
/// percent; its name is given by whoever places it.
class MeterBar : public QWidget {
    Q_OBJECT
public:
    explicit MeterBar(ColourRole role, QWidget* parent = nullptr);
    void setShare(double share); ///< 0 … 1; values outside are clamped
    void setRole(ColourRole role);
    double share() const noexcept { return share_; }
    ColourRole role() const noexcept { return role_; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColourRole role_;
    double share_ = 0.0;
};

} // namespace burin
