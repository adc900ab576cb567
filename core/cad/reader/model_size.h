// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"

namespace burin {

/// Checks whether a part has a plausible size. Adds a warning if it is smaller than 1 mm or larger than 10 m overall,
/// as its unit is doubtful then. Error, with an empty subject: modelTooLarge (farther than 1 km from its origin, where
/// numbers lose their precision).
Result<void> judgeSize(Model& model);

} // namespace burin
