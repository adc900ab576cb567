// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/computed_pass.h"

namespace burin {

/// A pass in outline: what a user sees of it before it is computed.
struct PassPreview {
    std::vector<TipLine> strokes; ///< of rows every `every`th or so, with fewer places than the pass has
    double every = 1.0;
    double length = 0.0;                  ///< mm, of the whole pass, estimated
    double duration = 0.0;                ///< s, of the same at the feed of tool and material, without links
    double leftOut = 0.0, inTheWay = 0.0; ///< mm of the whole pass, estimated, see PlannedPass
    std::size_t unreachedHoles = 0;
};

/// Plans with so few rows, and rasters so coarse, that it is done within some tenths of a second. Any thread.
/// Errors: those of planOn. @param milling with the pass's tool
Result<PassPreview> previewPass(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                                Progress& progress);

} // namespace burin
