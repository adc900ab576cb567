// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/body_role.h"

#include <algorithm>

namespace burin {

std::string_view idOf(BodyRole role) noexcept {
    switch (role) {
    case BodyRole::part:
        return "part";
    case BodyRole::stock:
        return "stock";
    case BodyRole::insert:
        return "insert";
    case BodyRole::protectedInsert:
        return "protected-insert";
    case BodyRole::fixture:
        return "fixture";
    case BodyRole::ignored:
        return "ignored";
    }
    return "";
}

std::optional<BodyRole> bodyRoleFromId(std::string_view id) noexcept {
    const auto found = std::ranges::find(bodyRoles, id, idOf);
    return found == bodyRoles.end() ? std::nullopt : std::optional(*found);
}

} // namespace burin
