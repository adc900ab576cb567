// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

#include <glm/glm.hpp>

namespace burin::test {

/// A tray to be milled from a block with two tools: faced, cleared inside and outside with 0.3 mm of allowance by T1,
/// finished by T2. What is part and what is stock is known by formula.
struct TrayJob {
    TrayJob();

    MillingContext milling;
    ProgramPaths paths;      ///< of T1, then of T2
    std::vector<Tool> tools; ///< T1 … T3; nothing is milled with T3
    ProgramRequest request(const std::string& dialect) const;
    /// The posted text; what it is of on a control that changes no tools: the first tool's path alone.
    std::string post(const std::string& dialect) const;

    /// mm by which a flat cutter at a tip (setup frame) is in the part; <= 0: it is not.
    static double depthInPart(const glm::dvec3& tip, double radius);
};

} // namespace burin::test
