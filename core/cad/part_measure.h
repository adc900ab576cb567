// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

#include <cstdint>
#include <optional>

namespace burin {

/// A face of a part, measured at a point. Frame of the model.
struct MeasuredFace {
    enum class Kind : std::uint8_t { plane, cylinder, cone, sphere, torus, other };
    Kind kind = Kind::other;
    glm::dvec3 place{0.0};     ///< mm, the point on the face that is nearest to the requested one
    glm::dvec3 corner{0.0};    ///< mm, as PartFace::corner
    glm::dvec3 normal{0.0};    ///< unit, outward at `place`; zero if the surface has no normal there
    glm::dvec3 axis{0.0};      ///< unit: of a cylinder, cone or torus; else zero
    glm::dvec3 axisPlace{0.0}; ///< mm: a point on the axis; the centre of a sphere or torus
    double radius = 0.0;       ///< mm: of a cylinder or sphere, of a cone at `place`, of the tube of a torus; else 0
    double taper = 0.0;        ///< rad: of a cone, between its axis and its side; else 0
    double area = 0.0;         ///< mm², of the whole face; 0: unknown, as for a mesh, which has no faces
    /// mm: from `place` straight into the material to where it ends; empty if it does not end.
    std::optional<double> thickness{};
};

/// Returns the stable id of a kind, for JSON: "plane", "cylinder", …
const char* idOf(MeasuredFace::Kind kind);

/// The relation of two measured faces.
struct MeasuredPair {
    double places = 0.0;  ///< mm, between both points
    double corners = 0.0; ///< mm, between both corners
    /// mm, the shortest distance between both faces; empty if both are the same face, and for a mesh, which has no
    /// faces.
    std::optional<double> faces{};
    glm::dvec3 nearestFrom{0.0}, nearestTo{0.0}; ///< mm: where the faces are nearest to each other, else both points
    /// rad, 0 … π / 2, between two directions: normals of planes and axes of round faces; between a plane and an axis
    /// it is the angle of the axis to the surface. Empty if one of the faces has no direction.
    std::optional<double> angle{};
    /// mm: between parallel planes, between parallel axes, or between a plane and an axis parallel to it; else empty.
    std::optional<double> apart{};
};

struct PartMeasure {
    MeasuredFace from;
    std::optional<MeasuredFace> to{};
    std::optional<MeasuredPair> pair{}; ///< present if there is `to`
};

/// Measures the face of a part at a point, and its relation to the face at another point. A B-rep is measured in the
/// import program, exactly to 1e-6 mm; a mesh file has no faces, so its triangles are measured as planes.
/// Errors: as importModel, argumentInvalid (a model without a body, a point that is not finite).
Result<PartMeasure> measurePart(const Model& model, const glm::dvec3& from, const std::optional<glm::dvec3>& to,
                                const ImportOptions& options, Progress& progress);

/// rad: directions count as parallel within this angle, the error of the faces of an STL file due to single precision.
inline constexpr double parallelWithin = 1e-5;

/// Returns what follows from the two measurements alone: everything except `faces` and the two nearest points.
/// @param parallel rad: directions count as parallel within this angle
MeasuredPair pairOf(const MeasuredFace& from, const MeasuredFace& to, double parallel = parallelWithin);

} // namespace burin
