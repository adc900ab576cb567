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
    QPointer<QWidget> widget; ///< null if nothing visible is meant
    QRect rect;               ///< logical pixels of the widget: the visible part of all of it or of one entry
    QString way; ///< instruction if the widget only leads to the target of the step; empty if it is the target

    /// Returns `rect` in the coordinates of another widget of the same window.
    QRect rectIn(const QWidget& other) const;
};

/// Returns what to press next for a step: its target, or if that is hidden, a widget that leads to it.
Pointed pointAt(const QWidget& window, const FirstJobStep& step, const Workbench& workbench);

} // namespace burin
