// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <string>
#include <vector>

namespace burin {

/// What became of a part's bodies when its file was read again. Names of bodies.
struct PartUpdate {
    std::vector<std::string> changed; ///< of another shape
    std::vector<std::string> added;   ///< part, of the stock's material, until somebody says otherwise
    std::vector<std::string> removed;
    bool stockStays = false; ///< in a setup with recordings or passes: stock and program zero stay where they are

    bool nothing() const noexcept { return changed.empty() && added.empty() && removed.empty(); }
};

/// Puts a part that was changed in the CAD system in the place of the one of a project, in all of its setups: the
/// placement stays, and roles and materials of bodies go by their names (several of one name: in their order; one body
/// in the place of one: whatever its name). Where nothing was milled yet, a stock that goes by the part follows it;
/// else stock and zero stay where they are. Recordings, paths and passes stay; a program is out of date. A part that
/// was mirrored is mirrored as before. The project is not saved.
/// @param model as its file has it
/// Errors: those of placeStock (roles that leave no part, above all): nothing has changed; those of Project.
Result<PartUpdate> updatePart(Project& project, const Model& model);

/// mm per unit of a file of the part that states no unit: as the one before was read.
double fileUnitAsBefore(const Model& before) noexcept;

} // namespace burin
