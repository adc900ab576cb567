// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/keep_clear.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

constexpr double shortest = 0.2; // mm of a move that is examined separately

/// Checks whether a move keeps clear of all obstacles.
class Clearances {
public:
    Clearances(std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles) {
        for (const ObstacleSolid& obstacle : obstacles)
            if (obstacle.on)
                askers_.push_back({std::make_unique<ClearanceAsker>(*obstacle.surface, tool), obstacle.margin});
    }
    bool none() const noexcept { return askers_.empty(); }
    bool allow(const glm::dvec3& from, const glm::dvec3& to) {
        return std::ranges::all_of(askers_, [&](Asked& one) { return one.asker->keeps(from, to, one.margin); });
    }

private:
    struct Asked {
        std::unique_ptr<ClearanceAsker> asker; // it can't be moved
        double margin;                         // mm
    };
    std::vector<Asked> askers_;
};

/// The pieces of a stroke that keep clear; the length between them, mm, is added to `lost`.
std::vector<TipLine> clearPieces(const TipLine& stroke, Clearances& clearances, double& lost) {
    std::vector<TipLine> pieces;
    bool open = false;
    const auto go = [&](const glm::dvec3& from, const glm::dvec3& to) {
        if (!open) pieces.push_back({from});
        open = true;
        pieces.back().push_back(to);
    };
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const glm::dvec3 &from = stroke[i - 1], &to = stroke[i];
        if (clearances.allow(from, to)) {
            go(from, to);
            continue;
        }
        const double length = glm::distance(from, to);
        const int steps = std::max(1, static_cast<int>(std::ceil(length / shortest)));
        for (int k = 0; k < steps; ++k) {
            const glm::dvec3 first = glm::mix(from, to, static_cast<double>(k) / steps);
            const glm::dvec3 last = glm::mix(from, to, static_cast<double>(k + 1) / steps);
            if (clearances.allow(first, last)) {
                go(first, last);
            } else {
                open = false;
                lost += length / steps;
            }
        }
    }
    return pieces;
}

} // namespace

void keepClear(PlannedPass& planned, std::span<const RevolvedPiece> tool, std::span<const ObstacleSolid> obstacles,
               const Progress& progress) {
    Clearances clearances(tool, obstacles);
    if (clearances.none()) return;
    std::vector<TipLine> clear;
    for (const TipLine& stroke : planned.strokes) {
        if (progress.cancelled()) return;
        for (TipLine& piece : clearPieces(stroke, clearances, planned.inTheWay)) clear.push_back(std::move(piece));
    }
    planned.strokes = std::move(clear);
}

} // namespace burin
