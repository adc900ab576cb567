// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/tool_bounds.h"

namespace burin {

/// The layers of bounds, for the trace of a session.
std::vector<TracedSession::Layer> tracedLayers(const ToolBounds& bounds);

/// The bounds of a session that plays a trace (SessionRequest::replayed): those of the session that recorded it, with
/// the same layers in the same initial state, also those that only the window has (the stock, to touch it off; a
/// machine travel that is switched off). A trace that does not state its layers, or that never switches one and has
/// others than this project, is played with those of the project.
/// @param travel of the project @param allowance mm, of a boundary that did not grow
/// Errors: those of ToolBounds::build and asGrown; argumentInvalid (it switches layers that this project does not
/// have).
Result<ToolBounds> boundsAsTraced(const MillingContext& milling, const AxisMode& axis, TravelPlacement travel,
                                  double allowance, const SessionTrace& trace, Progress& progress);

} // namespace burin
