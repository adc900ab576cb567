// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/scene/place_chains.h"

#include <memory>

namespace burin {

/// What the edited path is compared with, as it is drawn over it.
struct ComparisonMark {
    std::shared_ptr<const EvaluatedPath> other; ///< where it cuts and plunges; null: nothing
    PlaceChains farther;                        ///< of the edited path: what is too far from the other one, mm
};

} // namespace burin
