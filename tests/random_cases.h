// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/long_run.h"

#include <rapidcheck.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

namespace burin::testing {

/// Checks a property that is expensive, with a percentage of the requested number of cases.
template <class Testable>
bool holds(const std::string& description, int percent, Testable&& testable) {
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    params.maxSuccess = std::max(1, params.maxSuccess * percent / 100);
    rc::detail::TestMetadata metadata;
    metadata.id = metadata.description = description;
    const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
    rc::detail::printResultMessage(result, std::cerr);
    std::cerr << std::endl;
    return result.template is<rc::detail::SuccessResult>();
}

/// Checks a property that is expensive: the usual run tries 30 % of the requested number of cases.
template <class Testable>
bool holdsInShare(const std::string& description, Testable&& testable) {
    return holds(description, inLongRun(100, 30), std::forward<Testable>(testable));
}

} // namespace burin::testing
