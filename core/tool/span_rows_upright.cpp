// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/whole_registers.h"
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace any_processor {
namespace {
using namespace eight_lanes;
#include "core/tool/span_rows_upright_lanes.h"
} // namespace

BURIN_VECTORISED void uprightSpans(SpanRows::Shape shape, const SpanRows::Upright& piece,
                                   const SpanRows::UprightRows& rows, Stretches stretches) noexcept {
    coverAny(shape, piece, rows, stretches);
}
} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 {
namespace {
using namespace sixteen_lanes;
// Before the names of eight lanes.
using sixteen_lanes::Floats;
using sixteen_lanes::floatsOf;
using sixteen_lanes::Integers;
using sixteen_lanes::least;
using sixteen_lanes::most;
using sixteen_lanes::rootsOf;
using sixteen_lanes::wholeOf;
#include "core/tool/span_rows_upright_lanes.h"

void uprightSpans(SpanRows::Shape shape, const SpanRows::Upright& piece, const SpanRows::UprightRows& rows,
                  Stretches stretches) noexcept {
    coverAny(shape, piece, rows, stretches);
}
} // namespace
} // namespace avx512
BURIN_AVX512_END
#endif

void uprightSpans(SpanRows::Shape shape, const SpanRows::Upright& piece, const SpanRows::UprightRows& rows,
                  Stretches stretches) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::uprightSpans(shape, piece, rows, stretches);
#endif
    any_processor::uprightSpans(shape, piece, rows, stretches);
}

} // namespace burin::kernels
