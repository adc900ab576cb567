// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/growing_boundary.h"

#include <utility>

namespace burin {

GrowingBoundary::GrowingBoundary(std::shared_ptr<GrowingField> field, const glm::dmat3& turn)
    : GrowingBoundary(std::move(field), turn, Tiles()) {
    feed_ = field_->feed();
    if (!field_->whole()) return;
    for (TileNews news; feed_->next(news);) inForce_[news.tile] = news.bricks;
}

GrowingBoundary::GrowingBoundary(std::shared_ptr<GrowingField> field, const glm::dmat3& turn, Tiles made)
    : field_(std::move(field))
    , layout_(field_->layout())
    , turn_(turn)
    , turns_(turn != glm::dmat3(1.0))
    , made_(std::move(made))
    , inForce_(layout_.count(), nullptr) {}

PoseSample GrowingBoundary::at(const ToolPose& pose, double) noexcept {
    const glm::dvec3 tip = turns_ ? turn_ * pose.tip : pose.tip, kept = layout_.kept(tip);
    const BrickField* const tile = inForce_[layout_.tileOf(kept)];
    const FieldSample sample = tile != nullptr ? tile->sampleInside(kept) : field_->outline(kept);
    // rotated back by the transposed matrix
    const glm::dvec3 gradient = turns_ ? sample.gradient * turn_ : sample.gradient;
    return {sample.clearance, gradient, glm::dvec3(0.0), sample.fine && kept == tip};
}

std::optional<TileChange> GrowingBoundary::nextChange(const ToolPose& tool) noexcept {
    if (!feed_) return std::nullopt;
    const glm::dvec3 tip = turn_ * tool.tip;
    feed_->toolAt(tip);
    while (feed_->next(news_)) {
        if (news_.bricks != nullptr) return TileChange{news_.tile, true};
        if (layout_.distance(news_.tile, tip) > layout_.edge) return TileChange{news_.tile, false};
        feed_->answer(news_.tile, false); // the tool has come near in the meantime
    }
    return std::nullopt;
}

void GrowingBoundary::apply(const TileChange& change) noexcept {
    if (change.tile >= inForce_.size()) return; // belongs to another boundary
    if (!feed_) {
        const bool made = change.there && change.tile < made_.size();
        inForce_[change.tile] = made ? made_[change.tile].get() : nullptr;
        return;
    }
    if (news_.tile != change.tile || (news_.bricks != nullptr) != change.there) return; // belongs to another session
    inForce_[change.tile] = news_.bricks;
    if (news_.bricks == nullptr) feed_->answer(change.tile, true);
}

} // namespace burin
