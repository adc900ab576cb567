// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/tool/tool.h"

namespace burin {

/// The tooth of a thread mill.
struct ThreadTooth {
    double radius = 0.0; ///< mm from the axis, of its crest
    double height = 0.0; ///< mm above the tip, of the middle of its crest
    double flat = 0.0;   ///< mm along the axis, of its crest
};

/// Finds the one tooth of a thread mill, and checks that it cuts the profile of a pitch: nowhere wider than the groove
/// of the basic profile (60°, a flat of P/8 at the major diameter, ISO 68-1:1998) by more than 0.005 mm on either side,
/// and at the pitch line narrower than P/2 by no more than 0.01 mm, which makes the pitch diameter 0.017 mm too small:
/// a tooth for a smaller pitch would leave a thread that no gauge enters. The neck above the tooth has to pass the
/// crests at the minor diameter.
/// Errors: notSupported (what the tool would have to be).
Result<ThreadTooth> threadTooth(const Cutter& cutter, double pitch);

/// The same for external threads. Their roots may be flatter than the crests of internal ones, so that a tooth may cut
/// several pitches: its flat has to be from P/8 to P/4, those of the basic profile at major and minor diameter (ISO
/// 68-1:1998), each within 0.005 mm, and its flanks have 60° within 0.005 mm. The neck has to pass the crests at the
/// major diameter.
/// Errors: notSupported (what the tool would have to be).
Result<ThreadTooth> externalThreadTooth(const Cutter& cutter, double pitch);

/// The height above the tip up to which shank and holder pass the crests of a thread while the tooth is at its root,
/// mm; infinite if all of the holder does. @param depth mm, of the thread
double neckLength(const Cutter& cutter, double depth);

} // namespace burin
