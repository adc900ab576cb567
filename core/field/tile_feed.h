// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/base/ring.h"
#include "core/field/brick_field.h"

#include <array>
#include <span>

namespace burin {

/// A tile of a GrowingField has come, or is to be let go.
struct TileNews {
    std::uint32_t tile = 0;
    const BrickField* bricks = nullptr; ///< null: it is to be let go; otherwise it stays until `answer` lets it go
};

/// What passes between a GrowingField and a loop that reads it. Neither side waits, locks or allocates.
class TileFeed {
public:
    explicit TileFeed(std::size_t tiles) : news_(2 * tiles + 2), answers_(2 * tiles + 2) {}

    // ---- Loop's thread
    bool next(TileNews& news) noexcept { return news_.pop({&news, 1}) == 1; }
    /// To news that a tile is to be let go: from now on the loop does not read it, or it goes on doing so.
    void answer(std::uint32_t tile, bool letGo) noexcept { answers_.push({tile, letGo}); }
    /// The tiles nearest to it are made first.
    void toolAt(const glm::dvec3& tip) noexcept { tool_.post(tip); }

private:
    friend class GrowingField;
    struct Answer {
        std::uint32_t tile = 0;
        bool letGo = false;
    };
    // A tile comes, and is asked for once until that is answered: the rings are never full.
    Ring<TileNews> news_;
    Ring<Answer> answers_;
    Mailbox<glm::dvec3> tool_;
};

} // namespace burin
