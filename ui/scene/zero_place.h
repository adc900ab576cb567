// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

namespace burin {

/// The program zero of a setup.
struct ZeroPlace {
    glm::dvec3 place{0.0}; ///< mm, setup frame
    QString name;          ///< of the work offset

    friend bool operator==(const ZeroPlace&, const ZeroPlace&) = default;
};

} // namespace burin
