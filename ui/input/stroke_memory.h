// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace burin {

/// A stroke as it was drawn.
struct DrawnStroke {
    std::vector<glm::dvec3> places; ///< mm, setup frame: all points, or the corners
    std::vector<glm::dvec3> axes;   ///< unit, the tool axis at each of them
    double grain = 0.0;             ///< mm, the largest value of its points, as in StylusTarget; 0: they are exact
};

/// The strokes drawn since milling began, newest last: lines continue from the last one, and it can be repeated. An
/// undone stroke is removed, and a stroke cancelled before the spindle was turned on is discarded. The caller passes
/// the number of strokes that have turned on the spindle so far, `begun`: they do so in the order in which they were
/// drawn. Thread: user interface.
class StrokeMemory {
public:
    void begin(std::uint64_t begun); ///< a new stroke; undone strokes are discarded
    /// Adds a point to the current stroke; one that equals the previous one only changes its axis. @param axis unit
    void add(const glm::dvec3& place, double grain, const glm::dvec3& axis);
    /// Discards the strokes that have not turned on the spindle. Strokes undone before them can be redone again.
    void giveUp(std::uint64_t begun);
    /// Removes the last stroke that turned on the spindle; false: restores the one undone last.
    void takeBack(bool undo, std::uint64_t begun);

    /// The current stroke, else the last one; empty: none.
    const DrawnStroke& last() const noexcept;
    bool empty() const noexcept { return last().places.empty(); }

private:
    struct Numbered {
        DrawnStroke stroke;
        std::uint64_t number = 0; ///< from 1, in the order in which they turn on the spindle
    };
    void recall(std::uint64_t begun);

    std::vector<Numbered> strokes_, undone_;
    std::vector<Numbered> givenUp_;      ///< by the last call, in order
    std::vector<Numbered> undoneBefore_; ///< could be redone until a stroke was begun
    std::uint64_t drawn_ = 0,
                  replacedBy_ = 0; ///< number of the newest stroke; of the one that discarded `undoneBefore_`
};

} // namespace burin
