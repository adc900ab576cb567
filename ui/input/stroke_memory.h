// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace burin {

/// A stroke as it was drawn.
struct DrawnStroke {
    std::vector<glm::dvec3> places; ///< mm, setup frame: all of them, or its corners
    double grain = 0.0;             ///< mm, the coarsest of them, as StylusTarget has it; 0: they are exact
};

/// The strokes that were drawn since milling began, newest last: what a line goes on from, and what is repeated. One
/// that is taken back is the last one no more, and one that was given up before it turned the spindle never was. Who
/// calls says how many of the strokes have turned it so far, `begun`: they do so in the order in which they were drawn.
/// Thread: user interface.
class StrokeMemory {
public:
    void begin(std::uint64_t begun); ///< a new stroke; what was taken back is forgotten
    /// Of the stroke that is drawn; a place that follows its like is no new one.
    void add(const glm::dvec3& place, double grain);
    /// Strokes that wait to turn the spindle never will. What was taken back before them can be put back again.
    void giveUp(std::uint64_t begun);
    /// The last one that turned the spindle; false: the one that was taken back last is there again.
    void takeBack(bool undo, std::uint64_t begun);

    /// The stroke that is drawn, else the last one; empty: there is none.
    const DrawnStroke& last() const noexcept;
    bool empty() const noexcept { return last().places.empty(); }

private:
    struct Numbered {
        DrawnStroke stroke;
        std::uint64_t number = 0; ///< from 1, in the order in which they turn the spindle
    };
    void recall(std::uint64_t begun);

    std::vector<Numbered> strokes_, undone_;
    std::vector<Numbered> givenUp_;      ///< by the newest call, the first of them first
    std::vector<Numbered> undoneBefore_; ///< what could be put back until a stroke was begun
    std::uint64_t drawn_ = 0,
                  replacedBy_ = 0; ///< number of the newest stroke; of the one that `undoneBefore_` went for
};

} // namespace burin
