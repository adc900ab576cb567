// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_kind.h"

#include <array>

namespace burin {

/// The kinds of fixtures of the library, with their sizes, in the order of FixtureKind.
extern const std::array<FixtureKindRow, 7> fixtureKinds;

} // namespace burin
