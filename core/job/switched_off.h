// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <map>
#include <vector>

namespace burin {

/// Samples that are switched off, all of each take that is named: rising, apart.
using SwitchedOff = std::map<std::int64_t, std::vector<SampleRange>>;

/// As it is, of these takes. Errors: those of Project.
Result<SwitchedOff> switchedOff(const Project& project, const SwitchedOff& of);
/// As it will be with a stretch of a take off, or on. Errors: nameUnknown, argumentInvalid (nothing of it lies within
/// the take).
Result<SwitchedOff> withStretch(const Project& project, std::int64_t take, const SampleRange& stretch, bool off);
/// As it will be where nothing counts that was recorded behind a moment, in the setup in use: for milling on from there
/// (punch-in). Empty: nothing was. Errors: those of Project.
Result<SwitchedOff> offAfter(const Project& project, const TakeMoment& moment);
/// All or nothing of each take. Errors: those of Project::setSwitchedOff.
Result<void> setSwitchedOff(Project& project, const SwitchedOff& off);

} // namespace burin
