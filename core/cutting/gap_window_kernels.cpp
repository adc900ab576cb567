// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/gap_window_kernels.h"

#include "core/base/vector_masks.h"

#include <bit>

namespace burin::kernels {

namespace any_processor {
using namespace vector_masks;
#include "core/cutting/gap_window_rows.h"

BURIN_VECTORISED bool grow(const GapWindow::Rows& rows, GapWindow::Sums& sums, Growth& growth) noexcept {
    return growAll(rows, sums, growth);
}
} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 {
using namespace vector_masks_avx512;
#include "core/cutting/gap_window_rows.h"

bool grow(const GapWindow::Rows& rows, GapWindow::Sums& sums, Growth& growth) noexcept {
    return growAll(rows, sums, growth);
}
} // namespace avx512
BURIN_AVX512_END
#endif

bool growGaps(const GapWindow::Rows& rows, GapWindow::Sums& sums, Growth& growth) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::grow(rows, sums, growth);
#endif
    return any_processor::grow(rows, sums, growth);
}

} // namespace burin::kernels
