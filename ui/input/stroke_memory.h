// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A stroke as it was drawn.
struct DrawnStroke {
    std::vector<glm::dvec3> places; ///< mm, setup frame: all of them, or its corners
    double grain = 0.0;             ///< mm, the coarsest of them, as StylusTarget has it; 0: they are exact
};

/// The strokes that were drawn since milling began, newest last: what a line goes on from, and what is repeated. One
/// that is taken back is the last one no more. Thread: user interface.
class StrokeMemory {
public:
    void begin(); ///< a new stroke; what was taken back is forgotten
    /// Of the stroke that is drawn; a place that follows its like is no new one.
    void add(const glm::dvec3& place, double grain);
    void takeBack(bool undo); ///< the last one; false: the one that was taken back last is there again

    /// The stroke that is drawn, else the last one; empty: there is none.
    const DrawnStroke& last() const noexcept;
    bool empty() const noexcept { return last().places.empty(); }

private:
    std::vector<DrawnStroke> strokes_, undone_;
};

} // namespace burin
