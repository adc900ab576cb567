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

/// Makes a stroke that begins with a vertical descent begin at the bottom of it instead: how the tool gets there is
/// decided by its entry, and at the bottom its flutes remove what they would have removed during the descent.
/// @param stroke not empty
void beginAtBottom(PathStroke& stroke);

/// Plans how the tool descends to strokes that begin in material: by a ramp along their own beginning, which removes
/// nothing that they don't, else by a helix beside them, else straight down.
class EntryPlanner {
public:
    /// Keeps references to all of them. @param watch of the stock as it is now; null: the height map is used instead
    EntryPlanner(const Link& edit, const LinkRoom& room, const PartGuard& guard, const PathContext& context,
                 ShankWatch* watch);

    struct Entry {
        EntryForm form = EntryForm::plunge;
        std::size_t point = 0;        ///< index in the stroke, where the entry ends
        std::vector<StrokePoint> way; ///< from above the material to that point; empty for a plunge
        double depth = 0.0;           ///< mm of material above that point; 0: none
        bool stepsBack = false;       ///< the tool turns at the stroke's beginning without enough room
    };
    /// @param first the earliest point of the stroke that can be reached from above
    /// @return empty if no material is in the way, or if links are to plunge
    std::optional<Entry> into(const PathStroke& stroke, std::size_t first) const;

    /// Whether a straight move descends into material more steeply than a tool should.
    bool plunges(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Whether a descent, as links round it, would meet material that has to be entered by a ramp.
    bool meetsMaterial(const std::vector<StrokePoint>& way) const;
    /// Whether the tool may plunge straight down if nothing else fits.
    bool mayPlunge() const noexcept { return mayPlunge_; }

private:
    /// mm of material above a tip; with `all`, also material that only the outer fifth of the radius meets.
    double depthAt(const glm::dvec3& tip, bool all = false) const;
    /// How a ramp leads into the stroke. `turns`: it turns there and continues along the stroke. `passes`: the stroke
    /// is first followed back to its beginning. If the stroke's first move is short, both take room for turns beyond
    /// it; `noRoom` does not.
    enum class RampEnd { turns, passes, noRoom };
    std::vector<StrokePoint> rampInto(const PathStroke& stroke, double height, RampEnd end) const;
    std::vector<StrokePoint> rampBeside(const PathStroke& stroke, const glm::dvec3& next) const;
    std::vector<StrokePoint> helixInto(const PathStroke& stroke, double depth) const;
    std::optional<std::size_t> freePoint(const PathStroke& stroke, std::size_t from) const;
    bool clearsShank(const std::vector<StrokePoint>& way) const;

    bool on_, mayPlunge_;
    double slope_;    ///< steepest slope of ramps and helices
    double diameter_; ///< mm
    double stockTop_; ///< mm
    double safeHeight_;
    const LinkRoom& room_;
    const PartGuard& guard_;
    const PathContext& context_;
    ShankWatch* watch_;
};

} // namespace burin
