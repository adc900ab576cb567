// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// Where part and workpiece are cut open to be looked into; what is milled stays as it is.
struct SectionPlane {
    int axis = 1;          ///< 0, 1, 2 for x, y, z: the plane is square to it
    double position = 0.0; ///< mm along it, setup frame
    bool keepsLow = false; ///< what lies lower along the axis stays to be seen, instead of what lies higher
    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

} // namespace burin
