// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <string>
#include <vector>

namespace burin {

/// Returns the title of a setup in a program's header and a setup sheet: its name, or its number if it has none. Empty
/// if it is the only setup and has no name.
std::string setupTitle(const std::vector<SetupName>& setups, SetupId setup);
/// Returns the title of the setup in use. Errors: as Project::setups.
Result<std::string> setupTitle(const Project& project);

} // namespace burin
