// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// Identifies one setup (clamping) of a job. Ids are unique within a project and never reused.
enum class SetupId : std::int64_t {};
/// The setup of every new project, and of projects of a version that knew only one.
inline constexpr SetupId firstSetup{1};
/// Refers to the setup selected in a project (Project::useSetup); objects returned by a project have the actual id.
inline constexpr SetupId setupInUse{0};

constexpr std::int64_t numberOf(SetupId id) noexcept {
    return static_cast<std::int64_t>(id);
}

} // namespace burin
