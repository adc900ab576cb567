// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace burin {

/// A voxel array as stored in a file.
struct VoxelArray {
    using Values =
        std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                     std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                     std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;
    glm::ivec3 count{0};   ///< voxels along x, y, z
    double edge = 1.0;     ///< mm
    glm::dvec3 low{0.0};   ///< mm: low corner of the first voxel
    bool unitKnown = true; ///< false: the file states no unit of length, and mm were assumed
    Values values;         ///< x varies fastest, then y, then z
    std::string file;

    double at(std::size_t place) const; ///< as a double; 64-bit integers beyond 2^53 lose their last digits
};

/// Reads a three-dimensional voxel array: NRRD (all of its number types; raw or gzip; header attached, or detached and
/// naming its data file), or raw data with a header in JSON (README.md lists its keys). Voxels are cubes: other
/// spacings and rotated axes are refused. Nothing is allocated before the sizes are known to fit the data. Errors:
/// fileNotFound, fileNotReadable, fileEmpty, fileFormatUnknown, notSupported (subject: what; place: what can be done),
/// fileDamaged (place: the line or the length), volumeTooLarge, outOfMemory.
Result<VoxelArray> readArrayFile(const std::filesystem::path& file);
/// The same for content in memory. @param file its origin: a detached data file is searched for next to it
Result<VoxelArray> readArray(std::string content, const std::filesystem::path& file);

/// A header followed by the data, as one file. @param values one per voxel
std::string nrrdOf(const glm::ivec3& count, double edge, const glm::dvec3& low,
                   const std::vector<std::uint8_t>& values);

} // namespace burin
