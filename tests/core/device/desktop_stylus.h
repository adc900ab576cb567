// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

namespace burin::test {

/// A desktop device with round values: the default of tests.
inline StylusDescription desktopStylus() {
    StylusDescription stylus;
    stylus.name = "desktop";
    stylus.actuated = {3, 0};
    stylus.maximumForce = {4.0, "made up"};
    stylus.maximumStiffness = {400.0, "made up"};
    stylus.maximumDamping = {4.0, "made up"};
    stylus.workspaceRadius = {80.0, "made up"};
    return stylus;
}

} // namespace burin::test
