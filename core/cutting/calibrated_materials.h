// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/calibration.h"

#include <filesystem>
#include <string>
#include <vector>

namespace burin {

struct CalibrationRequest {
    std::filesystem::path forces; ///< force records, CSV
    std::string material;         ///< only this one of those in the file; empty: all
    std::string like;             ///< whose other values a new material takes over; empty: none may be new
    CalibrationOptions options;
    bool wanted = true; ///< false: nobody will read the other values of a material, so none have to be known
};

/// A calibration with the material that it makes.
struct CalibratedMaterial {
    MaterialCalibration calibration;
    Property material;
};

/// Fits each material of a file, in the file's order; what a material has beside K and Kr stays.
/// Errors: those of readFile, parseForceRecords and calibrate, nameUnknown (no such material in the file),
/// argumentInvalid (subject "material": one that is not known, and none that it is like).
Result<std::vector<CalibratedMaterial>> calibrateMaterials(const CalibrationRequest& request);

} // namespace burin
