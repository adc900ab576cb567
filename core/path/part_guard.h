// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/geometry/mesh_distance.h"
#include "core/path/evaluate.h"

#include <optional>
#include <vector>

namespace burin {

/// Distance queries for the whole tool against the part; where only tips are given, it is upright. Thread-safe.
class PartGuard {
public:
    /// Keeps a reference to the part.
    PartGuard(const MeshDistance& part, const Tool& tool);
    /// The same for some pieces alone.
    PartGuard(const MeshDistance& part, std::vector<RevolvedPiece> pieces);

    /// Errors: argumentInvalid, if the context has no part.
    static Result<PartGuard> of(const PathContext& context);

    ToolClearance clearance(const glm::dvec3& tip, double within) const;
    ToolClearance clearance(const ToolPose& pose, double within) const;

    /// The point at which a straight move comes nearest to the part, among its points that are nearer than allowed.
    struct Dip {
        double part = 0.0;      ///< fraction of the move, 0 … 1
        double clearance = 0.0; ///< mm
    };
    /// Samples both ends and points between them at most `sampling` mm apart. Points that can't be nearer than
    /// `required`, because the tool was far enough away just before, are skipped: clearance changes by no more than the
    /// tool moves. Corners that a move may cut between two samples are sampled more finely.
    std::optional<Dip> deepestDip(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling) const;
    /// The same with any axis, which turns evenly on the move. Between two samples no point of the tool moves farther
    /// than `sampling`, and than 0.01 mm where it may come nearer than required in between: 0.005 mm may be missed.
    std::optional<Dip> deepestDip(const ToolPose& from, const ToolPose& to, double required, double sampling) const;
    bool isClear(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling) const {
        return !scan(from, to, required, sampling, true);
    }

    /// The same along an arc; the required distance is increased by the 0.0005 mm by which chords leave it.
    bool isClear(const Arc& arc, double required, double sampling) const;

    /// A tip at this height has the whole part below it, mm.
    double top() const noexcept { return top_; }
    const std::vector<RevolvedPiece>& pieces() const noexcept { return pieces_; }

private:
    class Scan;
    class TurningScan;
    std::optional<Dip> scan(const glm::dvec3& from, const glm::dvec3& to, double required, double sampling,
                            bool firstIsEnough) const;

    const MeshDistance* part_;
    std::vector<RevolvedPiece> pieces_;
    double top_;
    double reach_ = 0.0; ///< mm: largest distance of the tool from its tip
};

/// Sampling distance of the checks that Burin makes unless another one is given, mm.
inline constexpr double defaultSampling = 0.1;

} // namespace burin
