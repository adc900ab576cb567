// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <utility>

namespace burin {

/// Runs `steps`, callables that return Result<void>, in order until one fails, and returns its error. With a list of
/// calls all of them would run before the first result is checked.
template <class... Steps>
Result<void> inOrder(Steps&&... steps) {
    Result<void> outcome;
    static_cast<void>(((outcome = std::forward<Steps>(steps)(), outcome.hasValue()) && ...));
    return outcome;
}

} // namespace burin
