// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/place_chains.h"

#include <QString>

namespace burin {

/// A measurement, as it is drawn.
struct MeasureMark {
    PlaceChains lines;     ///< mm, setup frame; a chain of one point is a dot
    glm::dvec3 place{0.0}; ///< mm: position of the text
    QString text;          ///< the main value with its unit
};

} // namespace burin
