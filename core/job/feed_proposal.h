// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recent_cut.h"
#include "core/machine/machine_profile.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"

#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// What keeps a proposed feed from being higher.
enum class FeedBound : std::uint8_t {
    chip,    ///< the chip that the material's tables give
    plunge,  ///< the tool plunges
    thinned, ///< the chip is thin, and more than twice the tables' feed is not proposed
    load,    ///< what tool and spindle bear
    limit,   ///< the greatest chip of the tool, or the machine's feed
};

/// A feed for a cut, by the tables of the materials that it goes through.
struct FeedProposal {
    double feed = 0.0;                    ///< mm/min
    double spindleSpeed = 0.0;            ///< 1/min: the least that a material of the cut asks for
    PropertyIndex material = airProperty; ///< that asks for the lowest feed
    FeedBound bound = FeedBound::chip;
};

/// The feed at which the mean chip is what it is in a slot at the tables' feed: in a shallow cut across, where chips
/// are thin, more than in a slot, up to twice; not more than tool and spindle bear (forceLimit, with the force in the
/// mean over a turn), than the tool's greatest chip and the machine's feed. A plunge gets the plunge feed. Of several
/// materials the most careful counts. Where limits are not stated they don't count. The engaged surface comes out up to
/// 0.5 rad short (Engagement), so that chips count as thicker than they are and the feed is rather too low.
/// @param properties of the workpiece
/// Nothing: nothing is cut, or a material lacks values for the tool.
std::optional<FeedProposal> proposeFeed(const SmoothedCut& cut, const Tool& tool, const MachineProfile& machine,
                                        const PropertyList& properties);

} // namespace burin
