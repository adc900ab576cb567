// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Plans milling of external threads with a thread mill of one tooth, on round upright studs.
///
/// *What may be cut.* Nothing of the part: its stud has to be drawn at the minor diameter that the mill cuts, d - 2
/// externalDepth (within 0.02 mm), and the thread's crests are stock in front of its wall. In the stock the stud has to
/// be milled to the major diameter before: 0.2 P narrower at most, 0.1 mm wider, and as much as the raster of the stock
/// hides (a fifth of its spacing). Around it the stock has to be gone down to the thread's lowest tip.
///
/// *Path.* A helix of whole turns, one for each pitch; its radius is that of the stud and that of the tool. The tool
/// comes down beside the stud, 0.5 mm clear of the crests, is led onto the helix by half a circle that is tangent to
/// it, and leaves it the same way, at the same angle; there the part leaves the most room. The height follows the angle
/// about the stud all the way, so that the tooth stays in its groove. Right-hand threads are climb milled from the top
/// down (clockwise), cut conventionally from the bottom up; left-hand ones the other way round. Several passes divide
/// the depth as those of planThreads do.
///
/// *Depth.* From at least half a pitch above the top of the stud (or `top`), so that the thread is complete there, down
/// to where the tool is 0.1 mm above what the part has around the stud (the thread runs out at the shoulder), or as
/// `depth` and `bottom` say. Studs beside which the part stops the tool or its holder, or the crests of the thread its
/// holder, more than a pitch above their foot or before the stated depth, and studs that are not milled to the major
/// diameter, are left out and counted.
///
/// *Feed.* Feeds of tables are those of the cutting edge. The centre of the tool moves on a larger circle, by (D + d) /
/// D (D: diameter cut, d: of the tool; Sandvik Coromant, "Thread milling", external): `PlannedPass::feedShares`.
///
/// Errors: notSupported (externalThreadTooth); argumentInvalid (a point without a stud, or on one of another diameter);
/// cancelled.
Result<PlannedPass> planStudThreads(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
