// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

namespace burin::test {

/// A uniformly distributed number from `low` to `high` in a million steps, independent of RapidCheck's size: positions
/// and lengths have no small cases to try first.
inline double randomNumber(double low, double high) {
    const int step = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001));
    return low + (high - low) * static_cast<double>(step) * 1e-6;
}

} // namespace burin::test
