// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/geometry/mesh_distance.h"
#include "core/path/evaluate.h"

#include <optional>
#include <vector>

namespace burin {

/// The whole tool, upright, against the part. Any number of threads may ask.
class PartGuard {
public:
    /// Keeps a reference to the part.
    PartGuard(const MeshDistance& part, const Tool& tool);
    /// The same of some pieces alone.
    PartGuard(const MeshDistance& part, std::vector<RevolvedPiece> pieces);

    /// Errors: argumentInvalid, when the context has no part.
    static Result<PartGuard> of(const PathContext& context);

    ToolClearance clearance(const glm::dvec3& tip, double within) const;

    /// Where a straight move comes nearest to the part, among those of its places that are nearer than allowed.
    struct Dip {
        double part = 0.0;      ///< of the move, 0 … 1
        double clearance = 0.0; ///< mm
    };
    /// Looks at both ends and every `sampling` mm or less between them. Places that can't be nearer than `required`
    /// because the tool was far enough away a little before are skipped: clearance changes by no more than the way.
    /// Corners that a move may cut between two samples are looked at more closely.
    std::optional<Dip> deepestDip(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling) const;
    bool isClear(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling) const {
        return !scan(from, to, required, sampling, true);
    }

    /// The same along an arc, held against the part grown by the 0.0005 mm that chords leave it by.
    bool isClear(const Arc& arc, double required, double sampling) const;

    /// A tip this high has the whole part below it, mm.
    double top() const noexcept { return top_; }
    const std::vector<RevolvedPiece>& pieces() const noexcept { return pieces_; }

private:
    class Scan;
    std::optional<Dip> scan(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling,
                            bool firstIsEnough) const;

    const MeshDistance* part_;
    std::vector<RevolvedPiece> pieces_;
    double top_;
};

/// Sampling of the moves that Burin checks without being told another, mm.
inline constexpr double defaultSampling = 0.1;

} // namespace burin
