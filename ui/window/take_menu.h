// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

namespace burin {

/// Shows the menu of a take, and of what is at one of its samples: a stroke, or an interval that is switched off.
/// Deletes itself. @param sample of the take
void showTakeMenu(Workbench& workbench, std::int64_t take, std::uint64_t sample, const QPoint& globalPosition,
                  QWidget* parent);

/// Connects the actions that apply to the chosen take.
void connectTakeActions(Workbench& workbench, const Actions& actions);

/// The same for a marker of the timeline. @param marker its index
void showMarkerMenu(Workbench& workbench, std::size_t marker, const QPoint& globalPosition, QWidget* parent);
/// Asks for a name and marks the moment that is shown.
void addMarker(Workbench& workbench, QWidget* parent);

} // namespace burin
