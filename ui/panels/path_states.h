// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/path/drawn_edit.h"
#include "core/path/evaluate.h"
#include "core/path/milling_side.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

/// What the panels of the path show. Panels own no model: they get one of these and tell by signals what the user
/// wants.
namespace burin {

/// What a drag of a place of the path changes.
enum class DragChoice { level, x, y, z, surface };

/// A computed pass of a path.
struct PassRow {
    std::int64_t id = 0;
    QString name, figures;
    bool computed = true; ///< it can be computed again; false: it is of a program
    QString measured{};   ///< what it does to the stock, several lines; empty: not measured
    friend bool operator==(const PassRow&, const PassRow&) = default;
};

struct PathState {
    struct Tool {
        std::string id;
        QString name;
    };
    std::vector<Tool> milled;                     ///< the tools that have takes
    Tool tool;                                    ///< in force
    std::vector<PassRow> passes;                  ///< of the path, in its order
    double passLeftOut = 0.0, passInTheWay = 0.0; ///< mm of the newest pass, see PlannedPass
    std::size_t unreachedHoles = 0;               ///< of the newest pass
    bool measurePossible = false;                 ///< the passes can be measured now
    bool passPossible = false;                    ///< one can be computed now
    bool hasTakes = false;                        ///< of the tool in force
    bool someWithoutPath = false;                 ///< of those that milled
    bool exists = false;
    StoredPath path;
    std::vector<TakeInfo> takes;       ///< all, for their names and times
    glm::dvec3 zero{0.0};              ///< mm, of the program, in the setup frame
    std::vector<EditReport> reports;   ///< of the newest evaluation, one for each enabled edit, in order
    std::optional<double> errorBudget; ///< mm
    std::size_t points = 0;
    double cuttingLength = 0.0;                         ///< mm
    double climbLength = 0.0, conventionalLength = 0.0; ///< mm of it; the rest cuts on both sides, or from above
    std::optional<MillingSide> selectedSide;            ///< of what is chosen; nothing: not the same everywhere
    bool outdated = false;                              ///< takes or edits changed since
    bool busy = false;
    bool waiting = false; ///< for the workpiece; then it is evaluated by itself
    std::optional<SourceStretch> selection;
    DragChoice drag = DragChoice::level;
    bool drawing = false;                   ///< a stroke is being drawn in the selection's stead
    std::optional<DrawnField> drawnField{}; ///< of an edit, that is being drawn
    QString problem;
    QString missingBefore; ///< tools whose paths are milled before and can't be made
};

} // namespace burin
