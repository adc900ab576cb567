// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Translation and rotation of the content as reported by a 3D mouse: the object moves with the cap.
struct CameraPush {
    glm::dvec3 push{0.0}; ///< fraction of full deflection: right, away from the user, up
    glm::dvec3 turn{0.0}; ///< fraction of full deflection about the same axes, right-handed
};

} // namespace burin
