// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/upright.h"
#include "core/path/apply.h"
#include "core/path/entry_planner.h"
#include "core/path/link_room.h"
#include "core/path/omission.h"
#include "core/path/shank_watch.h"
#include "core/path/stroke_access.h"
#include "core/path/stroke_steps.h"

#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// Joins strokes to one path, with rapids between them. Parts that cannot be reached, and parts that would take shank
/// or holder into material, are left out: the tool retracts before such a part and continues behind it.
class Linker {
public:
    /// Keeps references to all of them. @param watch of the stock before the path; null: there is none to touch
    Linker(LinkRoom& room, const PartGuard& guard, const PathContext& context, const EntryPlanner& planner,
           ShankWatch* watch);

    /// @param stroke of at least one point; has to stay unchanged until the last stroke was added
    void add(const PathStroke& stroke, const StrokeAccess& access);
    /// Retracts behind the last stroke to the height above everything.
    void leave();

    std::vector<PathPoint> points;
    std::vector<Omission> omissions;
    std::vector<StrokeEntry> entries;
    Deviation leftOut; ///< of points left out because they would have caused back-steps

private:
    /// The next part to append, and how it is entered.
    struct Piece {
        const PathStroke* stroke = nullptr;
        StrokeAccess access;
        bool joined = false;                        ///< reached straight from the last point
        std::vector<StrokePoint> way;               ///< from above to the point where it is entered
        std::optional<EntryPlanner::Entry> entry{}; ///< in material
        bool longer = false;                        ///< has a longer first move, by `withLongStart`
    };
    /// How much of a piece can be machined.
    struct Rehearsal {
        std::size_t reached = 0; ///< the last step that is clear
        std::optional<ToolSection> touching{};
    };

    /// Empty if the stroke can only be entered by a plunge, and the tool must not plunge.
    std::optional<Piece> begin(const PathStroke& stroke, const StrokeAccess& access);
    void enterFromAbove(Piece& piece) const;
    bool stepsBack(const Piece& piece) const;
    void begunLonger(Piece& piece);
    bool joinsWithBackStep(const PathStroke& stroke) const;
    void append(const Piece& piece);
    void addWatched(const PathStroke& stroke, const StrokeAccess& access);
    std::size_t appendUntilContact(const PathStroke& whole, const Piece& piece, std::span<const StrokeStep> steps,
                                   const Rehearsal& rehearsal);
    Rehearsal rehearse(const Piece& piece, std::span<const StrokeStep> steps);
    std::optional<ToolSection> rehearseEntry(const Piece& piece);
    std::optional<std::size_t> clearFrom(const std::vector<StrokeStep>& steps, std::size_t first);
    void leaveOut(const PathStroke& part, OmissionReason reason);
    bool mayTouch(const PathStroke& stroke) const;

    void make(const PathPoint& point);
    void go(const glm::dvec3& tip, MoveKind kind) { make({{tip, uprightAxis}, kind, 0.0, 0, -1}); }
    std::optional<glm::dvec3> turnAt(const PathStroke& stroke, std::size_t end, std::size_t before) const;
    void turn(const PathStroke& stroke, std::size_t end, std::size_t before);
    void depart();
    void swingOut();
    std::vector<StrokePoint> swingIn(const PathStroke& stroke, std::size_t entry) const;
    glm::dvec3 lift(double height) const;
    void travel(const LinkRoute& route, const glm::dvec3& entry);
    void enter(const Piece& piece);
    void cut(const PathStroke& stroke, std::size_t index, const std::optional<PathArc>& arc);
    void clear(const glm::dvec3& tip, const std::optional<PathArc>& arc);

    LinkRoom& room_;
    const PartGuard& guard_;
    const EntryPlanner& planner_;
    ShankWatch* watch_;
    double stockTop_, shortestKept_;                              // mm
    double lastRequired_ = 0.0;                                   // mm from the part, of the stroke before
    bool mustLift_ = false;                                       // something was left out since the last stroke
    bool rehearsed_ = false;                                      // the watch has already cut the present moves
    std::deque<PathStroke> pieces_;                               // parts of strokes that are not appended completely
    std::vector<std::pair<const PathStroke*, std::size_t>> back_; // points back to where the last stroke can be left
};

} // namespace burin
