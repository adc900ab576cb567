// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <TopoDS_Shape.hxx>

#include <glm/glm.hpp>

#include <memory>

namespace burin {

/// Exact signed distance from points to the surface of solids. Each face and edge is prepared once; a query evaluates
/// only those whose boxes are nearer than the nearest point found so far. Gives the same results as OpenCASCADE's
/// BRepExtrema_DistShapeShape, which repeats all preparation for each point.
class ExactDistance {
public:
    explicit ExactDistance(const TopoDS_Shape& solids);
    ~ExactDistance();
    ExactDistance(const ExactDistance&) = delete;
    ExactDistance& operator=(const ExactDistance&) = delete;

    /// Returns the distance in mm; negative inside.
    double signedDistance(const glm::dvec3& point);

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace burin
