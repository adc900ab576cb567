// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <map>
#include <vector>

namespace burin {

/// The samples that are switched off, complete for each take that is listed: increasing and disjoint.
using SwitchedOff = std::map<std::int64_t, std::vector<SampleRange>>;

/// Returns the present state of these takes. Errors: those of Project.
Result<SwitchedOff> switchedOff(const Project& project, const SwitchedOff& of);
/// Returns the state with an interval of a take switched off or on. Errors: nameUnknown, argumentInvalid (no part of it
/// lies within the take).
Result<SwitchedOff> withInterval(const Project& project, std::int64_t take, const SampleRange& interval, bool off);
/// Returns the state with everything switched off that was recorded after a moment, in the setup in use: for continuing
/// to mill from there (punch-in). Empty if nothing was recorded after it. Errors: those of Project.
Result<SwitchedOff> offAfter(const Project& project, const TakeMoment& moment);
/// Stores the state; each take is changed completely or not at all. Errors: those of Project::setSwitchedOff.
Result<void> setSwitchedOff(Project& project, const SwitchedOff& off);

} // namespace burin
