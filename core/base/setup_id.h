// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// Names one setup (clamping) of a job. Ids are a project's own and never used twice.
enum class SetupId : std::int64_t {};
/// Of every new project, and what a project of a version that knew one alone has.
inline constexpr SetupId firstSetup{1};
/// Stands for the setup that a project is used in (Project::useSetup); what a project gives names its own.
inline constexpr SetupId setupInUse{0};

constexpr std::int64_t numberOf(SetupId id) noexcept {
    return static_cast<std::int64_t>(id);
}

} // namespace burin
