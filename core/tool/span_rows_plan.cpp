// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/whole_registers.h"
#include "core/tool/span_rows_kernels.h"

namespace burin::kernels {

namespace any_processor {
namespace {
using namespace eight_lanes;
#include "core/tool/span_rows_plan_lanes.h"
} // namespace

BURIN_VECTORISED void planRows(const SpanRows::Upright& piece, std::int32_t firstRow,
                               SpanRows::UprightRows& rows) noexcept {
    planAll(piece, firstRow, rows);
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
#include "core/tool/span_rows_plan_lanes.h"

void planRows(const SpanRows::Upright& piece, std::int32_t firstRow, SpanRows::UprightRows& rows) noexcept {
    planAll(piece, firstRow, rows);
}
} // namespace
} // namespace avx512
BURIN_AVX512_END
#endif

void planRows(const SpanRows::Upright& piece, std::int32_t firstRow, SpanRows::UprightRows& rows) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::planRows(piece, firstRow, rows);
#endif
    any_processor::planRows(piece, firstRow, rows);
}

} // namespace burin::kernels
