// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/measure.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>

namespace burin {

namespace {

constexpr double integralTolerance = 1e-6; // relative

} // namespace

double exactVolume(const TopoDS_Shape& solid) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, integralTolerance);
    return properties.Mass();
}

double exactArea(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties, integralTolerance);
    return properties.Mass();
}

Box exactBox(const TopoDS_Shape& shape) {
    Bnd_Box bounds;
    BRepBndLib::AddOptimal(shape, bounds, Standard_False, Standard_False);
    Box box;
    if (bounds.IsVoid()) return box;
    bounds.SetGap(0.0);
    bounds.Get(box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z);
    return box;
}

} // namespace burin
