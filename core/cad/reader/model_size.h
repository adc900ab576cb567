// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"

namespace burin {

/// Whether a part is as large as parts are. Adds a warning where it is smaller than 1 mm or larger than 10 m in all:
/// its unit is doubtful then. Error, with an empty subject: modelTooLarge (farther than 1 km from its origin, where
/// figures lose their meaning).
Result<void> judgeSize(Model& model);

} // namespace burin
