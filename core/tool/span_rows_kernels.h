// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/span_rows.h"

// Within core/tool: the inner loops of SpanRows.
namespace burin::kernels {

inline constexpr float unitsAVoxel = 256.0F;
inline constexpr float nowhere = 1e9F; ///< above every height: no part of the piece

void planRows(const SpanRows::Upright& piece, std::int32_t firstRow, SpanRows::UprightRows& rows) noexcept;
using Stretches = std::span<const RowSpans>;
void uprightBall(const SpanRows::Upright& piece, const SpanRows::UprightRows& rows, Stretches stretches) noexcept;
void uprightFlat(const SpanRows::Upright& piece, const SpanRows::UprightRows& rows, Stretches stretches) noexcept;
void uprightBullNose(const SpanRows::Upright& piece, const SpanRows::UprightRows& rows, Stretches stretches) noexcept;

/// @param margin voxels that the shadow of the way's end is grown by
void planTiltedRows(const TiltedPiece& piece, const TiltedShadow& shadow, float margin, std::int32_t firstRow,
                    TiltedRows& rows) noexcept;
void tiltedBall(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept;
void tiltedFlat(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept;
void tiltedBullNose(const TiltedPiece& piece, const TiltedRows& rows, Stretches stretches) noexcept;

} // namespace burin::kernels
