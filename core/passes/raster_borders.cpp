// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/raster_borders.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace burin {
namespace {

/// Walks from square to square.
class Borders {
public:
    Borders(const std::vector<double>& room, int columns, int rows, double beyond)
        : room_(room), columns_(columns), rows_(rows), beyond_(beyond) {}

    /// Ring coordinates are in squares from the first grid point.
    std::vector<PlanRing> rings() {
        for (int row = -1; row < rows_; ++row)
            for (int column = -1; column < columns_; ++column) cross(column, row);
        std::vector<PlanRing> rings;
        while (!next_.empty()) {
            PlanRing& ring = rings.emplace_back();
            const std::int64_t first = next_.begin()->first;
            std::int64_t edge = first;
            do {
                ring.push_back(placeOn(edge));
                const auto step = next_.find(edge);
                edge = step->second;
                next_.erase(step);
            } while (edge != first);
        }
        return rings;
    }

private:
    double at(int column, int row) const noexcept {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return beyond_;
        return room_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column)];
    }
    /// Index of the edge from a point to the next one along x, or along y.
    std::int64_t edgeOf(int column, int row, bool upwards) const noexcept {
        return ((row + 1) * static_cast<std::int64_t>(columns_ + 2) + column + 1) * 2 + (upwards ? 1 : 0);
    }
    glm::dvec2 placeOn(std::int64_t edge) const noexcept {
        const bool upwards = edge % 2 == 1;
        const int column = static_cast<int>(edge / 2 % (columns_ + 2)) - 1;
        const int row = static_cast<int>(edge / 2 / (columns_ + 2)) - 1;
        const double here = at(column, row), there = upwards ? at(column, row + 1) : at(column + 1, row);
        const double share = here / (here - there);
        return glm::dvec2(column, row) + (upwards ? glm::dvec2(0.0, share) : glm::dvec2(share, 0.0));
    }
    void cross(int column, int row) {
        const std::array<double, 4> corners{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                            at(column, row + 1)};
        const std::array<std::int64_t, 4> edges{edgeOf(column, row, false), edgeOf(column + 1, row, true),
                                                edgeOf(column, row + 1, false), edgeOf(column, row, true)};
        for (std::size_t i = 0; i < 4; ++i) {
            // the border begins here, with room after it
            if (!(corners[i] <= 0.0 && corners[(i + 1) % 4] > 0.0)) continue;
            std::size_t last = (i + 1) % 4;
            while (corners[(last + 1) % 4] > 0.0) last = (last + 1) % 4;
            next_.emplace(edges[i], edges[last]);
        }
    }

    const std::vector<double>& room_;
    int columns_, rows_;
    double beyond_;
    std::unordered_map<std::int64_t, std::int64_t> next_;
};

} // namespace

std::vector<PlanRing> bordersOf(const std::vector<double>& room, int columns, int rows, double beyond) {
    return Borders(room, columns, rows, beyond).rings();
}

} // namespace burin
