// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

namespace burin {

/// Plans milling of threads with a thread mill of one tooth: external ones as planStudThreads does, internal ones in
/// round upright holes.
///
/// *What may be cut.* Nothing of the part: its hole has to be drawn at the major diameter of the thread (within 0.02
/// mm), and the thread's crests are stock that stays in front of its wall. A hole that is drawn at another diameter is
/// refused. In the stock the hole has to be drilled before, wide enough for the tool and as deep as it goes.
///
/// *Path.* A helix with a turn for each pitch; its radius is that of the hole less that of the tool, so that the tooth
/// reaches the circle of the hole exactly. The tool comes down on the axis of the hole, is led onto the helix by half a
/// turn of half its radius, which is tangent to it and lies on the surface of the thread (it rises by a quarter of the
/// pitch), and leaves it the same way. Right-hand threads are climb milled from the bottom up (anticlockwise), cut
/// conventionally from the top down; left-hand ones the other way round. Of several passes, each removes as much as the
/// others from a full triangle: the depth grows with the square root of their number. Chords leave the helix by 0.0005
/// mm at most.
///
/// *Depth.* From half a pitch above the top of the hole (or `top`), so that the thread is complete there, to half a
/// pitch beyond its bottom if that is open and drilled, at least to the bottom; in a blind hole to
/// where the point of a drill of 118° that stands on its bottom ends; or as `depth` and `bottom` say, but no farther.
/// Holes that are not drilled as deep or as wide, or in which the part stops the tool or its holder before, or the
/// crests of the thread its holder, are left out and counted.
///
/// *Feed.* Feeds of tables are those of the cutting edge. The centre of the tool moves on a smaller circle, by (D - d)
/// / D (D: diameter cut, d: of the tool; Sandvik Coromant, "Thread milling", internal): `PlannedPass::feedShares`.
///
/// Errors: notSupported (threadTooth); argumentInvalid (a point without a hole, or in a hole of another diameter, with
/// facets farther than 0.007 mm inside of its circle, or too narrow for the tool); cancelled.
Result<PlannedPass> planThreads(const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
