// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/span_rows.h"

// Internal to core/tool: the inner loops of SpanRows.
namespace burin::kernels {

inline constexpr float unitsAVoxel = static_cast<float>(SpanRows::unitsAVoxel);
inline constexpr float nowhere = 1e9F; ///< above every height: no part of the piece

/// Computes `UprightRows::count` rows, from the first on.
void planRows(const SpanRows::Upright& piece, std::int32_t firstRow, SpanRows::UprightRows& rows) noexcept;
using Intervals = std::span<const RowSpans>;
/// Intervals must be in the order of their rows. Spans of rows next to a requested one may be written as well, and are
/// meaningless.
void uprightSpans(SpanRows::Shape shape, const SpanRows::Upright& piece, const SpanRows::UprightRows& rows,
                  Intervals intervals) noexcept;
/// The same for processors without AVX-512; identical to the last bit, which a test checks.
namespace any_processor {
void planRows(const SpanRows::Upright& piece, std::int32_t firstRow, SpanRows::UprightRows& rows) noexcept;
void uprightSpans(SpanRows::Shape shape, const SpanRows::Upright& piece, const SpanRows::UprightRows& rows,
                  Intervals intervals) noexcept;
} // namespace any_processor

/// @param margin voxels by which the shadow at the move's end is enlarged
void planTiltedRows(const TiltedPiece& piece, const TiltedShadow& shadow, float margin, std::int32_t firstRow,
                    TiltedRows& rows) noexcept;
void tiltedBall(const TiltedPiece& piece, const TiltedRows& rows, Intervals intervals) noexcept;
void tiltedFlat(const TiltedPiece& piece, const TiltedRows& rows, Intervals intervals) noexcept;
void tiltedBullNose(const TiltedPiece& piece, const TiltedRows& rows, Intervals intervals) noexcept;

} // namespace burin::kernels
