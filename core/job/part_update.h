// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <string>
#include <vector>

namespace burin {

/// The changes of a part's bodies when its file was read again, by the names of bodies.
struct PartUpdate {
    std::vector<std::string> changed; ///< have another shape
    std::vector<std::string> added;   ///< with role part and the stock's material until changed
    std::vector<std::string> removed;
    bool stockStays = false; ///< a setup has recordings or passes: its stock and program zero stay where they are

    bool nothing() const noexcept { return changed.empty() && added.empty() && removed.empty(); }
};

/// Replaces the part of a project by one that was changed in the CAD system, in all of its setups. The placement is
/// kept; roles and materials are assigned to bodies by name (several bodies of one name: in order; one body replacing
/// one: regardless of its name). In an assembly that is the path; where a path is gone, the path below a renamed
/// assembly of the first level, or else the name of the body alone. A colour that the new file doesn't state is kept.
/// If nothing was milled yet, a stock that is derived from the part follows it; otherwise stock and zero stay where
/// they are. Recordings, paths and passes are kept; a program becomes out of date. A mirrored part is mirrored again.
/// The project is not saved.
/// @param model as read from its file
/// Errors: those of placeStock (mainly roles that leave no part), nothing is changed then; those of Project.
Result<PartUpdate> updatePart(Project& project, const Model& model);

} // namespace burin
