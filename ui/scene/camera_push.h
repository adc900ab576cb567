// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// How a hand pushes and turns what it sees, as a 3D mouse tells it: the object goes where the cap goes.
struct CameraPush {
    glm::dvec3 push{0.0}; ///< share of full deflection: right, away from the user, up
    glm::dvec3 turn{0.0}; ///< share of full deflection about the same axes, right-handed
};

} // namespace burin
