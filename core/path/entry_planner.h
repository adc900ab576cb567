// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/link_room.h"
#include "core/path/shank_watch.h"
#include "core/path/stroke.h"
#include "core/path/stroke_entry.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// A stroke that begins plumb down begins at the bottom of that instead: how the tool gets there is for its entry, and
/// standing there its flutes remove what they would have removed on the way. @param stroke not empty
void beginAtBottom(PathStroke& stroke);

/// Finds how the tool goes down to strokes that begin in material: along their own beginning, which removes nothing
/// that they don't, else in a helix beside them, else straight down.
class EntryPlanner {
public:
    /// Keeps references to all of them. @param watch of the stock as it is now; null: the height map stands for it
    EntryPlanner(const Link& edit, const LinkRoom& room, const PartGuard& guard, const PathContext& context,
                 ShankWatch* watch);

    struct Entry {
        EntryForm form = EntryForm::plunge;
        std::size_t point = 0;        ///< of the stroke, where it ends
        std::vector<StrokePoint> way; ///< from above the material to that point; none for a plunge
        double depth = 0.0;           ///< mm of material above that point; 0: nothing stands there
        bool stepsBack = false;       ///< the tool turns at the stroke's beginning, and there is no room to
    };
    /// @param first the earliest point of the stroke that can be reached from above
    /// @return nothing where no material is in the way, or where links are to plunge
    std::optional<Entry> into(const PathStroke& stroke, std::size_t first) const;

    /// Whether a straight move leads down into material more steeply than a tool should.
    bool plunges(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Whether a way down, as links round it, would meet material that is to be ramped into.
    bool meetsMaterial(const std::vector<StrokePoint>& way) const;
    /// Whether the tool may go straight down where nothing else fits.
    bool mayPlunge() const noexcept { return mayPlunge_; }

private:
    /// mm of material above a tip; with `all`, also what only a rim of a fifth of the radius meets.
    double depthAt(const glm::dvec3& tip, bool all = false) const;
    /// How a ramp leads into the stroke: it turns there and goes on along it, or the stroke is first gone back to its
    /// beginning; where its first move is short, room for turns is taken beyond it, or there is none.
    enum class RampEnd { turns, passes, noRoom };
    std::vector<StrokePoint> rampInto(const PathStroke& stroke, double height, RampEnd end) const;
    std::vector<StrokePoint> rampBeside(const PathStroke& stroke, const glm::dvec3& next) const;
    std::vector<StrokePoint> helixInto(const PathStroke& stroke, double depth) const;
    std::optional<std::size_t> freePoint(const PathStroke& stroke, std::size_t from) const;
    bool clearsShank(const std::vector<StrokePoint>& way) const;

    bool on_, mayPlunge_;
    double slope_;    ///< of ramps and helices, at most
    double diameter_; ///< mm
    double stockTop_; ///< mm
    double safeHeight_;
    const LinkRoom& room_;
    const PartGuard& guard_;
    const PathContext& context_;
    ShankWatch* watch_;
};

} // namespace burin
