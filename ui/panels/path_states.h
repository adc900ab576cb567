// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/passes/pass_request.h"
#include "core/path/drawn_edit.h"
#include "core/path/evaluate.h"
#include "core/path/milling_side.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

/// States of the path panels. Panels own no model: they are given one of these states and report the user's requests by
/// signals.
namespace burin {

/// What dragging a point of the path changes.
enum class DragChoice { level, x, y, z, surface };

/// A computed pass of a path.
struct PassRow {
    std::int64_t id = 0;
    QString name, figures;
    bool computed = true;  ///< whether it can be computed again; false: it comes from a program
    QString measured{};    ///< its effect on the stock, several lines; empty: not measured
    bool outdated = false; ///< hand strokes that it depends on have changed since it was computed
    friend bool operator==(const PassRow&, const PassRow&) = default;
};

/// The point of a path at the time on the timeline.
struct TimelinesPlace {
    std::optional<Moment> moment;    ///< empty: the present
    std::optional<glm::dvec3> place; ///< mm, setup frame; empty: the path doesn't have that moment
};

/// Editing with the stylus, which changes while it moves.
struct StylusEditState {
    bool active = false;
    bool device = false;                                   ///< whether a device moves the tool, which has a reach
    double reach = 0.0, leastReach = 0.0, mostReach = 0.0; ///< mm
    QString text;                                          ///< what it does, while active
    QString missing;                                       ///< why it is not possible; empty: it is
};

struct PathState {
    struct Tool {
        std::string id;
        QString name;
    };
    std::vector<Tool> milled;                     ///< the tools that have takes
    Tool tool;                                    ///< the current tool
    std::vector<PassRow> passes;                  ///< the path's passes, in order
    double passLeftOut = 0.0, passInTheWay = 0.0; ///< mm of the newest pass, see PlannedPass
    std::size_t unreachedHoles = 0;               ///< of the newest pass
    HoleWork holeWork = HoleWork::drilling;       ///< of the newest pass
    bool refreshPossible = false;                 ///< whether the passes that are out of date can be computed now
    bool measurePossible = false;                 ///< whether the passes can be measured now
    bool passPossible = false;                    ///< whether a pass can be computed now
    bool toolTurns = true;                        ///< whether the loaded tool turns; one that doesn't has no passes
    bool hasTakes = false;                        ///< whether the current tool has takes
    bool someWithoutPath = false;                 ///< whether some tools with takes have no path
    bool exists = false;
    StoredPath path;
    std::vector<TakeInfo> takes;       ///< all takes, for their names and times
    glm::dvec3 zero{0.0};              ///< program zero, mm, setup frame
    std::vector<EditReport> reports;   ///< of the newest evaluation, one for each enabled edit, in order
    std::optional<double> errorBudget; ///< mm
    std::size_t points = 0;
    double cuttingLength = 0.0;                         ///< mm
    double climbLength = 0.0, conventionalLength = 0.0; ///< mm of it; the remainder cuts on both sides, or from above
    std::optional<MillingSide> selectedSide;            ///< of the selection; empty: not the same everywhere
    bool outdated = false;                              ///< whether takes or edits have changed since the evaluation
    bool busy = false;
    bool waiting = false; ///< whether it waits for the workpiece; it is then evaluated automatically
    std::optional<SourceInterval> selection;
    TimelinesPlace atTime;
    DragChoice drag = DragChoice::level;
    bool drawing = false;                   ///< whether a replacement stroke for the selection is being drawn
    std::optional<DrawnField> drawnField{}; ///< the field of an edit that is being drawn
    QString problem;
    QString missingBefore; ///< tools whose paths are milled earlier and can't be computed
};

} // namespace burin
