// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/cad/reader/reader.h"
#include "core/cad/reader/reader_progress.h"

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

namespace burin {

/// The part of a file that a shape is an instance of, and where that was placed.
struct PlacedPart {
    TopoDS_Shape part; ///< as it lies in the part's own frame; null: not known
    gp_Trsf place;     ///< from that frame to the model's, mm
};

/// A shape of a file with its attributes in the file; placed in the model's frame, mm.
struct NamedShape {
    TopoDS_Shape shape;     ///< one solid, or everything of one part that is not a solid
    std::string name;       ///< as in body_path.h; may be empty
    BodyColour colour;      ///< sRGB
    std::string assembly{}; ///< path of the assemblies around it, as in body_path.h
    PlacedPart from{};
    /// Of each face, in the order of TopExp_Explorer; empty: no face has a colour of its own.
    std::vector<BodyColour> faceColours{};
};

/// A B-rep file as it was read, before any healing.
struct CadFile {
    std::string format;
    std::string lengthUnit;
    double unitScale = 1.0; ///< mm per unit
    bool statesUnit = true; ///< whether `lengthUnit` is that of the file, not only what its format usually means
    std::vector<NamedShape> shapes;
    std::vector<ImportNote> notes;
    std::string missingFiles; ///< names of files that hold parts of this one but are not in its folder; empty: none
};

/// @param content of the file. Parts that are stored in other files are read if these lie in the same folder. Errors,
/// with an empty subject: fileDamaged, modelHasNoSolid (detail: files of an assembly that can't be read).
Result<CadFile> readStepFile(const std::string& file, std::string_view content, const ReaderReports& report);
Result<CadFile> readIgesFile(const std::string& file, std::size_t bytes, const ReaderReports& report);
Result<CadFile> readBrepFile(const std::string& content, bool binary, const ReaderReports& report);

/// The parts of an import's progress at which its steps end, 0 … 1: the rest is meshing.
inline constexpr double textRead = 0.06, fileRead = 0.1, shapesConverted = 0.4, solidsChecked = 0.5;

/// Scales a file that was read in its own unit to another one. @param scale mm per unit
void replaceUnit(CadFile& file, double scale);

} // namespace burin
