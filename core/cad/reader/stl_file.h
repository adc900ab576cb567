// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// One `solid` of an STL file; a binary file has one. Vertices are merged where they are bit-identical.
struct StlSolid {
    std::string name;  ///< may be empty
    TriangleMesh mesh; ///< in the file's own unit
};

/// Whether the content is exactly as long as its count of triangles says.
bool hasLengthOfBinaryStl(std::string_view content);
/// Whether the content begins as a text file of facets.
bool isTextStl(std::string_view content);
/// Whether the content begins as a binary file and holds more than its count of triangles says.
bool isLongerBinaryStl(std::string_view content);
/// Returns where a binary STL file was cut off ("triangle 17 of 684"); empty if the content does not look like one.
std::string whereBinaryStlEnds(std::string_view content);

/// Errors of both: fileDamaged (place: the line or triangle), with an empty subject.
/// @param ended set to false if "endsolid" is missing after complete facets
Result<std::vector<StlSolid>> readTextStl(std::string_view content, bool& ended);
Result<std::vector<StlSolid>> readBinaryStl(std::string_view content);

} // namespace burin
