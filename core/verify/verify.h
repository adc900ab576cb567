// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/import.h"
#include "core/geometry/mesh_distance.h"
#include "core/machine/machine_profile.h"
#include "core/nc/parser.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"

namespace burin {

struct VerifyRequest {
    const ParsedProgram* program = nullptr;
    const Model* model = nullptr;
    const MeshDistance* part = nullptr;  ///< of the model's meshes, chord <= 0.005 mm
    Setup setup;
    Tool tool;
    MachineProfile machine;
    double gougeTolerance = 0.02;   ///< mm
    double sampling = 0.1;          ///< mm along moves
    std::size_t exactSamples = 500; ///< of the worst samples are judged on the exact B-rep; 0: mesh only
    ImportOptions import;           ///< worker and limits for the exact distances
};

enum class FindingKind : std::uint8_t {
    gouge, rapidInStock, shankCollision, holderCollision, spindleOff, travelLimit, feedLimit, unknownStart
};

struct Finding {
    FindingKind kind = FindingKind::gouge;
    std::uint32_t line = 0;    ///< of the program
    glm::dvec3 place{0.0};     ///< mm, setup frame
    double amount = 0.0;       ///< mm of depth, or the value that breaks the limit in its own unit
};

/// What re-simulating a program on its setup found.
struct VerifyReport {
    double gougeMax = 0.0;        ///< mm, >= 0: the larger of the mesh's and the exact judgement where both exist
    double gougeMaxMesh = 0.0;    ///< mm
    std::size_t samples = 0;      ///< along the moves
    std::size_t exactSamples = 0;
    double excessMax = 0.0;       ///< mm of material left above the part where the tool could have reached, see README
    double excessMean = 0.0;      ///< mm
    double removed = 0.0;         ///< mm³
    double onPartShare = 0.0;     ///< of cutting samples over the part's outline shrunk by the radius: share within 0.1 mm of the part
    double machiningSeconds = 0.0;///< at the programmed feeds, without acceleration
    std::vector<Finding> findings;///< worst of each kind and block, in program order
    bool passed(double gougeTolerance) const;
};

/// Re-simulates a program on a fresh workpiece and judges it: flutes, shank and holder against stock and part, rapids,
/// limits, gouges on the fine mesh and, at the worst samples, on exact geometry. The workpiece as the program leaves it
/// goes to `machined` when that is not null.
/// Errors: those of embed and exactSignedDistances, cancelled.
Result<VerifyReport> verify(const VerifyRequest& request, Progress& progress, VolumeSnapshot* machined = nullptr);

} // namespace burin
