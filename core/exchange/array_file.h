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

/// A voxel array as a file has it.
struct VoxelArray {
    using Values =
        std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                     std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                     std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;
    glm::ivec3 count{0};   ///< voxels along x, y, z
    double edge = 1.0;     ///< mm
    glm::dvec3 low{0.0};   ///< mm: low corner of the first voxel
    bool unitKnown = true; ///< false: the file states no unit of length, and mm were taken
    Values values;         ///< x counts fastest, then y, then z
    std::string file;

    double at(std::size_t place) const; ///< as a double; 64-bit integers beyond 2^53 lose their last digits
};

/// Reads a voxel array of three dimensions: NRRD (all of its number types; raw or gzip; header attached, or apart and
/// naming the file of its data), or raw data with a header in JSON (README.md has its keys). Voxels are cubes: other
/// spacings and axes that are turned are refused. Nothing is allocated before the sizes are known to fit the data.
/// Errors: fileNotFound, fileNotReadable, fileEmpty, fileFormatUnknown, notSupported (subject: what; place: what can be
/// done), fileDamaged (place: the line or the length), volumeTooLarge, outOfMemory.
Result<VoxelArray> readArrayFile(const std::filesystem::path& file);
/// The same of a content that was read. @param file that it comes from: data that stand apart are looked for beside it
Result<VoxelArray> readArray(std::string content, const std::filesystem::path& file);

/// A header and the data behind it, as one file. @param values one a voxel
std::string nrrdOf(const glm::ivec3& count, double edge, const glm::dvec3& low,
                   const std::vector<std::uint8_t>& values);

} // namespace burin
