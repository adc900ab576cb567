// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace burin {

/// Lower half of a symmetric, positive definite matrix whose entries lie within three of the diagonal: row i holds
/// (i, i), (i, i - 1), (i, i - 2), (i, i - 3). Linear time and memory.
class BandMatrix {
public:
    static constexpr std::size_t width = 4;

    explicit BandMatrix(std::size_t size) : rows_(size) {}
    /// @param row at least `column`, by less than `width`
    void add(std::size_t row, std::size_t column, double value) noexcept { rows_[row][row - column] += value; }

    /// Solves for each coordinate; `right` becomes the solution, the matrix its factors (LDLᵀ). May be called once
    /// only.
    void solve(std::vector<glm::dvec3>& right) noexcept;

private:
    std::vector<std::array<double, width>> rows_;
};

} // namespace burin
