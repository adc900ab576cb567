// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_scale.h"
#include "ui/scene/colour_scale.h"
#include "ui/theme/length_unit.h"

namespace burin {

/// The colour scale with its marks for stock left on the part.
ColourScaleContent excessScale(const DeviationScale& scale, LengthUnit unit);

} // namespace burin
