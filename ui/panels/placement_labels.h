// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// Describes a placement: "As in the file.", "Turned by 90° about X, moved by 0, 0, 12 mm."
QString placementText(const Placement& placement, LengthUnit unit);

} // namespace burin
