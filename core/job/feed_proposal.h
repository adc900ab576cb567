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

/// The limit that determines a proposed feed.
enum class FeedBound : std::uint8_t {
    chip,    ///< the chip load of the material's tables
    plunge,  ///< the tool plunges
    thinned, ///< the chip is thin, and at most twice the tables' feed is proposed
    load,    ///< what tool and spindle withstand
    limit,   ///< the largest chip load of the tool, or the machine's feed
};

/// A feed for a cut, based on the tables of the materials that are cut.
struct FeedProposal {
    double feed = 0.0;                    ///< mm/min
    double spindleSpeed = 0.0;            ///< 1/min: the lowest for the materials of the cut
    PropertyIndex material = airProperty; ///< the one that requires the lowest feed
    FeedBound bound = FeedBound::chip;
};

/// Returns the feed at which the mean chip is as thick as in a slot at the tables' feed: with a small radial depth of
/// cut, where chips are thin, up to twice the feed in a slot. The feed is limited by what tool and spindle withstand
/// (forceLimit, with the mean force over a revolution), by the tool's largest chip load and by the machine's feed. A
/// plunge gets the plunge feed. With several materials, the lowest feed counts. Limits that are not stated are ignored.
/// The engaged surface is underestimated by up to 0.5 rad (Engagement), so that chips are taken as thicker than they
/// are and the feed tends to be too low.
/// @param properties of the workpiece
/// @return empty if nothing is cut, the tool doesn't turn, or a material lacks values for the tool
std::optional<FeedProposal> proposeFeed(const SmoothedCut& cut, const Tool& tool, const MachineProfile& machine,
                                        const PropertyList& properties);

} // namespace burin
