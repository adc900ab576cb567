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
    std::string material;         ///< calibrate only this material of the file; empty: all
    std::string like;             ///< existing material whose other values a new material copies; empty: the file may
                                  ///< name no new material
    CalibrationOptions options;
    bool wanted = true; ///< false: the other values of a material will not be read, so they need not be known
};

/// A calibration and the resulting material.
struct CalibratedMaterial {
    MaterialCalibration calibration;
    Property material;
};

/// Fits each material of a file, in the file's order; the values of a material other than K and Kr stay.
/// Errors: those of readFile, parseForceRecords and calibrate, nameUnknown (no such material in the file),
/// argumentInvalid (subject "material": an unknown material, and no existing one to copy from).
Result<std::vector<CalibratedMaterial>> calibrateMaterials(const CalibrationRequest& request);

} // namespace burin
