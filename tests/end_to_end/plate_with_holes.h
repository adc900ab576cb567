// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <gp_Ax2.hxx>

#include <initializer_list>
#include <string>

namespace burin::test {

/// A round hole or stud, mm: down from `top` to `bottom`.
struct PlateRound {
    double x = 0.0, y = 0.0, diameter = 0.0, bottom = 0.0, top = 0.0;
};

inline TopoDS_Shape cylinderOf(const PlateRound& round) {
    const gp_Ax2 axis(gp_Pnt(round.x, round.y, round.bottom), gp_Dir(0.0, 0.0, 1.0));
    return BRepPrimAPI_MakeCylinder(axis, 0.5 * round.diameter, round.top - round.bottom).Shape();
}

/// Writes a plate of 80 x 50 x 12 mm, one corner at the origin, with holes and studs, as a BREP file.
inline bool writePlate(const std::string& file, std::initializer_list<PlateRound> holes,
                       std::initializer_list<PlateRound> studs) {
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(80.0, 50.0, 12.0).Shape();
    for (const PlateRound& stud : studs) plate = BRepAlgoAPI_Fuse(plate, cylinderOf(stud)).Shape();
    for (const PlateRound& hole : holes) plate = BRepAlgoAPI_Cut(plate, cylinderOf(hole)).Shape();
    return BRepTools::Write(plate, file.c_str());
}

} // namespace burin::test
