// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

#include <cstdint>
#include <optional>

namespace burin {

/// A face of a part, measured at a place. Model's frame.
struct MeasuredFace {
    enum class Kind : std::uint8_t { plane, cylinder, cone, sphere, torus, other };
    Kind kind = Kind::other;
    glm::dvec3 place{0.0};     ///< mm, on the face, nearest to what was asked
    glm::dvec3 corner{0.0};    ///< mm, as PartFace::corner
    glm::dvec3 normal{0.0};    ///< unit, outward there; zero where the surface has none
    glm::dvec3 axis{0.0};      ///< unit: of a cylinder, cone or torus; else zero
    glm::dvec3 axisPlace{0.0}; ///< mm: on the axis; the centre of a sphere or torus
    double radius = 0.0;       ///< mm: of a cylinder or sphere, of a cone there, of the tube of a torus; else 0
    double taper = 0.0;        ///< rad: of a cone between its axis and its side; else 0
    double area = 0.0;         ///< mm², of the whole face; 0: not known, as of a mesh, which has no faces
    /// mm: from the place straight into the material to where that ends; nothing: it does not end.
    std::optional<double> thickness{};
};

/// Two of them.
struct MeasuredPair {
    double places = 0.0;  ///< mm, between both places
    double corners = 0.0; ///< mm, between both corners
    /// mm, between both faces where they are nearest to each other; nothing: of one face, and of a mesh, which has
    /// none.
    std::optional<double> faces{};
    glm::dvec3 nearestFrom{0.0}, nearestTo{0.0}; ///< mm: where that is, else both places
    /// rad, 0 … π / 2, between two directions: normals of planes, axes of round faces; a plane's own direction is its
    /// surface. Nothing: one of them has none.
    std::optional<double> angle{};
    /// mm: between parallel planes, parallel axes, or a plane and an axis along it. Nothing: they are no such pair.
    std::optional<double> apart{};
};

struct PartMeasure {
    MeasuredFace from;
    std::optional<MeasuredFace> to{};
    std::optional<MeasuredPair> pair{}; ///< where there is `to`
};

/// Measures the face of a part at a place, and how it lies to that at another one. A B-rep as it is there, asked in the
/// import program: exact to 1e-6 mm; of a mesh file, which has no faces, triangles, which are planes.
/// Errors: as importModel, argumentInvalid (a model without a body, a place that is not finite).
Result<PartMeasure> measurePart(const Model& model, const glm::dvec3& from, const std::optional<glm::dvec3>& to,
                                const ImportOptions& options, Progress& progress);

/// What follows from two faces by themselves: all but `faces` and where that is.
MeasuredPair pairOf(const MeasuredFace& from, const MeasuredFace& to);

} // namespace burin
