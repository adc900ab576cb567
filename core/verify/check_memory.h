// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "core/verify/excess.h"
#include "core/verify/gouge.h"
#include "core/verify/kept_check.h"
#include "core/verify/kept_dips.h"
#include "core/verify/kept_rows.h"
#include "core/verify/known_moves.h"
#include "core/verify/outline.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// What a KeptCheck keeps.
struct CheckMemory {
    std::string basis;                     ///< basisText of the check that it is from
    std::optional<EmbeddedSetup> embedded; ///< fresh; empty: not kept
    std::vector<ShrunkOutline> outlines;   ///< by tool
    KnownMoves moves;
    std::size_t movesOfProgram = 0; ///< the last one
    KeptDips obstacles, passes;
    KeptRows rows;
    KeptGouges gouges;
    KeptReach reach;

    std::size_t bytes() const noexcept;
};

/// What the results for a move depend on besides the move, as text; meshes by a digest. Numbers are exact. Excludes
/// what KeptCheck leaves to its owner.
std::string basisText(const VerifyRequest& request, std::span<const Tool> tools);

} // namespace burin
