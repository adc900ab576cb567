// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/band_solver.h"

#include <algorithm>

namespace burin {

void BandMatrix::solve(std::vector<glm::dvec3>& right) noexcept {
    const std::size_t size = rows_.size();
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t reach = std::min(i, width - 1);
        for (std::size_t k = reach; k > 0; --k) { // column i - k, from the left
            double sum = rows_[i][k];
            for (std::size_t m = k + 1; m <= reach; ++m) sum -= rows_[i][m] * rows_[i - k][m - k] * rows_[i - m][0];
            rows_[i][k] = sum / rows_[i - k][0];
        }
        for (std::size_t k = 1; k <= reach; ++k) {
            rows_[i][0] -= rows_[i][k] * rows_[i][k] * rows_[i - k][0];
            right[i] -= rows_[i][k] * right[i - k];
        }
    }
    for (std::size_t i = size; i-- > 0;) {
        right[i] /= rows_[i][0];
        for (std::size_t k = 1; k < width && i + k < size; ++k) right[i] -= rows_[i + k][k] * right[i + k];
    }
}

} // namespace burin
