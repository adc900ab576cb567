// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <string>

namespace burin {

/// A three-axis machine and its control, plain data. resources/machines/<id>.json.
struct MachineProfile {
    std::string id;
    std::string name;
    std::string source;                 ///< where the numbers come from
    glm::dvec3 travel{0.0};             ///< mm along X, Y, Z
    double maximumFeed = 0.0;           ///< mm/min, cutting
    double rapidFeed = 0.0;             ///< mm/min
    double minimumSpindleSpeed = 0.0;   ///< 1/min
    double maximumSpindleSpeed = 0.0;   ///< 1/min
    double acceleration = 0.0;          ///< mm/s², each axis
    double toolChangeHeight = 0.0;      ///< mm above the work offset's zero that is always safe to go to
    int coordinateDecimals = 3;         ///< digits behind the point in mm
    int maximumLineLength = 255;        ///< characters
};

} // namespace burin
