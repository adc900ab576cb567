// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/place_chains.h"

#include <QString>

namespace burin {

/// What was measured, as it is drawn.
struct MeasureMark {
    PlaceChains lines;     ///< mm, setup frame; one place: a dot
    glm::dvec3 place{0.0}; ///< mm: where the text stands
    QString text;          ///< the main figure with its unit
};

} // namespace burin
