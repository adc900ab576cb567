// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <string>
#include <vector>

namespace burin {

/// What a program's header and a setup sheet call a setup: its name, or its number where it has none. Empty where it
/// is the only one and has no name.
std::string setupTitle(const std::vector<SetupName>& setups, SetupId setup);
/// Of the one in use. Errors: as Project::setups.
Result<std::string> setupTitle(const Project& project);

} // namespace burin
