// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibrated_materials.h"

#include "core/base/file.h"

#include <algorithm>
#include <array>
#include <ctime>

namespace burin {

namespace {

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc);
    return text.data();
}

/// Returns the materials in the order of the file, each once; only the requested one if there is one.
Result<std::vector<std::string>> materialsOf(const std::vector<ForceRecord>& records, const std::string& wanted) {
    std::vector<std::string> materials;
    std::string known;
    for (const ForceRecord& record : records) {
        if (std::ranges::find(materials, record.material) != materials.end()) continue;
        materials.push_back(record.material);
        known += (known.empty() ? "" : ", ") + record.material;
    }
    if (wanted.empty()) return materials;
    if (std::ranges::find(materials, wanted) == materials.end())
        return Error{ErrorCode::nameUnknown, "material", wanted, known};
    return std::vector<std::string>{wanted};
}

/// Returns the material that provides the values other than K and Kr: the one of that id, or the one to copy from.
Result<Property> basisOf(const std::string& id, const CalibrationRequest& request) {
    const std::string& like = request.like;
    if (like.empty()) {
        Result<Property> known = loadMaterial(id);
        if (known || known.error().code != ErrorCode::nameUnknown) return known;
        if (!request.wanted) return Property{};
        return Error{ErrorCode::argumentInvalid, "material", id,
                     "a known material, or one that a new material is like"};
    }
    Result<Property> model = loadMaterial(like);
    if (!model || like == id) return model;
    for (auto& [name, value] : model->values) {
        value.source = "taken over from " + like + ": " + value.source;
        value.estimate = true;
    }
    model->name = id;
    return model;
}

Result<CalibratedMaterial> calibrated(const std::vector<ForceRecord>& records, const std::string& id,
                                      const CalibrationRequest& request) {
    Result<MaterialCalibration> calibration = calibrate(records, id, request.options, request.forces.string());
    if (!calibration) return std::move(calibration).error();
    const Result<Property> basis = basisOf(id, request);
    if (!basis) return basis.error();
    const std::string evidence = request.forces.filename().string() + ", " + today();
    Property material = calibratedMaterial(*basis, *calibration, evidence);
    return CalibratedMaterial{std::move(*calibration), std::move(material)};
}

} // namespace

Result<std::vector<CalibratedMaterial>> calibrateMaterials(const CalibrationRequest& request) {
    const Result<std::string> text = readFile(request.forces);
    if (!text) return text.error();
    const Result<std::vector<ForceRecord>> records = parseForceRecords(*text, request.forces.string());
    if (!records) return records.error();
    const Result<std::vector<std::string>> ids = materialsOf(*records, request.material);
    if (!ids) return ids.error();
    std::vector<CalibratedMaterial> materials;
    for (const std::string& id : *ids) {
        Result<CalibratedMaterial> one = calibrated(*records, id, request);
        if (!one) return std::move(one).error();
        materials.push_back(std::move(*one));
    }
    return materials;
}

} // namespace burin
