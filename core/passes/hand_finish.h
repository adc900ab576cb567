// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/passes/pass_ground.h"
#include "core/passes/pass_request.h"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace burin {

class SurfaceTrace;

/// Where strokes of the hand have finished the part, as a pass sees it. A stroke counts where its tip is at most the
/// finish height h above the surface of tips of the pass. Beside it the rounded end of the tool, of radius r, leaves no
/// more than h as far as w = sqrt(h (2 r - h)), measured between tips: exact on planes of any slope. A flat end of
/// radius f adds f to that on level faces. On hollow faces the ridges are higher than h, on convex ones lower, as those
/// between rows of a given step-over are. Any number of threads may ask.
class HandFinish {
public:
    struct Near {
        double distance = 0.0; ///< mm, from a tip to the nearest tip of a stroke
        double left = 0.0;     ///< mm: height of that one above the surface of tips; below 0 under an allowance
    };

    /// When cancelled, strokes are missing. @param trace of the pass
    HandFinish(const PassRequest& request, const PassGround& ground, const SurfaceTrace& trace,
               const Progress& progress);

    bool empty() const noexcept { return moves_.empty(); } ///< no stroke counts
    double height() const noexcept { return height_; }     ///< h, mm
    /// Whether the part is finished at a tip of the pass.
    bool isFinishedAt(const glm::dvec3& tip) const { return reaches(tip, 1.0); }
    /// Whether the pass would cut there what is finished: its own tool reaches as far as that of the hand.
    bool isDisturbedAt(const glm::dvec3& tip) const { return reaches(tip, 2.0); }
    /// The nearest stroke that counts, if it is no farther away than `within`, mm.
    std::optional<Near> nearest(const glm::dvec3& tip, double within) const;

private:
    /// A move between two tips of a stroke, both of which count.
    struct Move {
        glm::dvec3 from, to;
        double leftFrom, leftTo;
    };
    void add(const Move& move);
    bool reaches(const glm::dvec3& tip, double widths) const;
    std::int64_t cellOf(double x, double y) const noexcept;
    template <class Visit>
    void visitNear(const glm::dvec3& tip, double within, const Visit& visit) const;

    double height_, rounded_, flat_; // mm: h, w and f
    double cell_;                    // mm
    std::vector<Move> moves_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

/// Treats strokes of the hand as the request wants it (HandStrokes::keepOff and blend): ends strokes of the pass before
/// what they finished, or goes on over its border for the overlap and rises there to the height that the hand left.
/// Borders are exact to 0.005 mm along the pass. No point of the pass gets lower. What is left out is added to
/// `PlannedPass::leftToHand`. Thread-safe; cancellable.
void heedHandStrokes(PlannedPass& planned, const PassRequest& request, const PassGround& ground, Progress& progress);

} // namespace burin
