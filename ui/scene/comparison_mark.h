// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/scene/place_chains.h"

#include <memory>

namespace burin {

/// What is drawn over the edited path to show its comparison with another one.
struct ComparisonMark {
    std::shared_ptr<const EvaluatedPath> other; ///< its cuts and plunges are drawn; null: none
    PlaceChains farther;                        ///< parts of the edited path too far from the other one, mm
};

} // namespace burin
