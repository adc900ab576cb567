// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/piece_profile.h"

#include <algorithm>
#include <cmath>

namespace burin {

PieceProfile::PieceProfile(const RevolvedPiece& piece) noexcept {
    const ProfileDisc top{piece.topRadius, piece.top};
    if (piece.bulges()) {
        const auto sineAt = [&](double height) {
            return std::clamp((height - piece.bulgeCentreHeight) / piece.bulgeRadius, -1.0, 1.0);
        };
        arc_ = {piece.bulgeCentreRadius, piece.bulgeCentreHeight, piece.bulgeRadius, sineAt(piece.bottom),
                sineAt(piece.top)};
        discs_ = {{{piece.bottomRadius, piece.bottom}, top}};
        count_ = 2;
        return;
    }
    side_ = {true, {piece.bottomRadius, piece.bottom + piece.cornerRadius}, top, 0.0, 1.0};
    const double widening = piece.topRadius - piece.bottomRadius, length = piece.top - piece.bottom;
    if (widening != 0.0) {
        const double flank = std::hypot(widening, length);
        side_.sine = -widening / flank;
        side_.cosine = length / flank;
    }
    if (piece.cornerRadius > 0.0) {
        arc_ = {piece.bottomRadius - piece.cornerRadius, piece.bottom + piece.cornerRadius, piece.cornerRadius, -1.0,
                0.0};
        discs_[count_++] = {arc_.centreRadius, piece.bottom};
    }
    discs_[count_++] = side_.lower;
    discs_[count_++] = top;
}

ProfileDisc PieceProfile::farthest(double sine, double cosine) const noexcept {
    if (arc_.radius > 0.0 && sine >= arc_.lowSine && sine <= arc_.highSine)
        return {arc_.centreRadius + arc_.radius * cosine, arc_.centreHeight + arc_.radius * sine};
    return *std::ranges::max_element(
        discs(), {}, [&](const ProfileDisc& disc) { return disc.radius * cosine + disc.height * sine; });
}

} // namespace burin
