// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/whole_registers.h"
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace {
using Shape = SpanRows::Shape;
using Upright = SpanRows::Upright;
using End = SpanRows::End;
using Rows = SpanRows::UprightRows;
} // namespace

namespace any_processor {
namespace {
using namespace eight_lanes;
#include "core/tool/span_rows_plan_lanes.h"
#include "core/tool/span_rows_upright_lanes.h"
} // namespace

BURIN_VECTORISED void planRows(const Upright& piece, std::int32_t firstRow, Rows& rows) noexcept {
    planAll(piece, firstRow, rows);
}

BURIN_VECTORISED void uprightSpans(Shape shape, const Upright& piece, const Rows& rows, Intervals intervals) noexcept {
    coverAny(shape, piece, rows, intervals);
}
} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 {
namespace {
BURIN_USING_SIXTEEN_LANES
#include "core/tool/span_rows_plan_lanes.h"
#include "core/tool/span_rows_upright_lanes.h"

void planRows(const Upright& piece, std::int32_t firstRow, Rows& rows) noexcept {
    planAll(piece, firstRow, rows);
}

void uprightSpans(Shape shape, const Upright& piece, const Rows& rows, Intervals intervals) noexcept {
    coverAny(shape, piece, rows, intervals);
}
} // namespace
} // namespace avx512
BURIN_AVX512_END
#endif

void planRows(const Upright& piece, std::int32_t firstRow, Rows& rows) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::planRows(piece, firstRow, rows);
#endif
    any_processor::planRows(piece, firstRow, rows);
}

void uprightSpans(Shape shape, const Upright& piece, const Rows& rows, Intervals intervals) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::uprightSpans(shape, piece, rows, intervals);
#endif
    any_processor::uprightSpans(shape, piece, rows, intervals);
}

} // namespace burin::kernels
