// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <TopoDS_Shape.hxx>

#include <glm/glm.hpp>

#include <memory>

namespace burin {

/// Exact signed distance from points to the surface of solids. Prepares each face and edge once; a query looks only at
/// those whose boxes are nearer than the best found. Same answers as OpenCASCADE's BRepExtrema_DistShapeShape, which
/// prepares everything anew for each point.
class ExactDistance {
public:
    explicit ExactDistance(const TopoDS_Shape& solids);
    ~ExactDistance();
    ExactDistance(const ExactDistance&) = delete;
    ExactDistance& operator=(const ExactDistance&) = delete;

    /// mm; negative inside.
    double signedDistance(const glm::dvec3& point);

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace burin
