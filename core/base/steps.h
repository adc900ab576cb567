// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <utility>

namespace burin {

/// Runs `steps`, callables that give Result<void>, one after the other up to the first that fails, and returns its
/// error. A list of calls would run them all before the first is looked at.
template <class... Steps>
Result<void> inOrder(Steps&&... steps) {
    Result<void> outcome;
    static_cast<void>(((outcome = std::forward<Steps>(steps)(), outcome.hasValue()) && ...));
    return outcome;
}

} // namespace burin
