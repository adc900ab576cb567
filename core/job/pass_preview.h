// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/computed_pass.h"

namespace burin {

/// A coarse preview of a pass, shown before the pass is computed.
struct PassPreview {
    std::vector<TipLine> strokes; ///< about every `every`th row, with fewer points than in the pass
    double every = 1.0;
    double length = 0.0;                  ///< mm, of the complete pass, estimated
    double duration = 0.0;                ///< s, of the complete pass at the feed of tool and material, without links
    double leftOut = 0.0, inTheWay = 0.0; ///< mm of the complete pass, estimated, see PlannedPass
    double leftToHand = 0.0;              ///< the same
    std::size_t unreachedHoles = 0;
};

/// Plans with so few rows and such coarse rasters that it takes only some tenths of a second. Thread-safe.
/// Errors: those of planOn. @param milling with the pass's tool
Result<PassPreview> previewPass(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                                Progress& progress);

} // namespace burin
