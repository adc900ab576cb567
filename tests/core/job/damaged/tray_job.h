// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

#include <glm/glm.hpp>

namespace burin::test {

/// A tray milled from a block with two tools: faced, cleared inside and outside with 0.3 mm of allowance by T1,
/// finished by T2. Part and stock are known by formula.
struct TrayJob {
    TrayJob();

    MillingContext milling;
    ProgramPaths paths;      ///< of T1 and T2, in that order
    std::vector<Tool> tools; ///< T1 … T3; nothing is milled with T3
    ProgramRequest request(const std::string& dialect) const;
    /// The posted text; for a control without tool changes only the first tool's path.
    std::string post(const std::string& dialect) const;

    /// mm, depth of a flat cutter in the part at a tip (setup frame); <= 0: no contact.
    static double depthInPart(const glm::dvec3& tip, double radius);
};

} // namespace burin::test
