// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/setup_title.h"

#include <algorithm>

namespace burin {

std::string setupTitle(const std::vector<SetupName>& setups, SetupId setup) {
    const auto found = std::ranges::find(setups, setup, &SetupName::id);
    if (found != setups.end() && !found->name.empty()) return found->name;
    return setups.size() > 1 ? std::to_string(numberOf(setup)) : std::string();
}

Result<std::string> setupTitle(const Project& project) {
    const Result<std::vector<SetupName>> setups = project.setups();
    return setups ? Result<std::string>(setupTitle(*setups, project.usedSetup())) : setups.error();
}

} // namespace burin
