// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/base/ring.h"
#include "core/field/brick_field.h"

#include <array>
#include <span>

namespace burin {

/// A tile of a GrowingField has become available, or is to be released.
struct TileNews {
    std::uint32_t tile = 0;
    const BrickField* bricks = nullptr; ///< null: to be released; otherwise valid until `answer` releases it
};

/// Communication between a GrowingField and a loop that reads it. Neither side waits, locks or allocates.
class TileFeed {
public:
    explicit TileFeed(std::size_t tiles) : news_(2 * tiles + 2), answers_(2 * tiles + 2) {}

    // ---- Loop's thread
    bool next(TileNews& news) noexcept { return news_.pop({&news, 1}) == 1; }
    /// Answers a request to release a tile: from now on the loop does not read it, or it keeps reading it.
    void answer(std::uint32_t tile, bool letGo) noexcept { answers_.push({tile, letGo}); }
    /// The tiles nearest to the tool are made first.
    void toolAt(const glm::dvec3& tip) noexcept { tool_.post(tip); }

private:
    friend class GrowingField;
    struct Answer {
        std::uint32_t tile = 0;
        bool letGo = false;
    };
    // A tile becomes available, and its release is requested only once until answered: the rings are never full.
    Ring<TileNews> news_;
    Ring<Answer> answers_;
    Mailbox<glm::dvec3> tool_;
};

} // namespace burin
