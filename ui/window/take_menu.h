// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/workbench.h"

#include <QWidget>

namespace burin {

/// Shows what can be done with a take, and with what lies at one of its samples: stroke, stretch that is off. Deletes
/// itself. @param sample of the take
void showTakeMenu(Workbench& workbench, std::int64_t take, std::uint64_t sample, const QPoint& globalPosition,
                  QWidget* parent);

/// The same of a marker of the timeline. @param marker its place among them
void showMarkerMenu(Workbench& workbench, std::size_t marker, const QPoint& globalPosition, QWidget* parent);
/// Asks for a name, and marks the moment that is shown.
void addMarker(Workbench& workbench, QWidget* parent);

} // namespace burin
