// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/first_job_steps.h"

#include <QPointer>
#include <QRect>
#include <QWidget>

namespace burin {

/// What the coach points at.
struct Pointed {
    QPointer<QWidget> widget; ///< null: nothing that is seen
    QRect rect;               ///< logical pixels of the widget: all of it, an entry of it, or what is seen of that
    QString way; ///< what the user does there, where it only leads to what the step means; empty: it is meant

    /// In the frame of another widget of the same window.
    QRect rectIn(const QWidget& other) const;
};

/// What is to be pressed next for a step: what it means, or where that is hidden the way there.
Pointed pointAt(const QWidget& window, const FirstJobStep& step, const Workbench& workbench);

} // namespace burin
