// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/setup_record.h"

#include "core/document/json_vector.h"
#include "core/geometry/pose.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

/// Key of the first number that JSON can't write; empty when there is none.
const char* notFinite(const Setup& setup) {
    if (!std::isfinite(setup.voxel)) return "voxel_mm";
    if (!isFinite(setup.marginLow)) return "margin_low_mm";
    if (!isFinite(setup.marginHigh)) return "margin_high_mm";
    if (!isFinite(setup.workOffset)) return "work_offset_mm";
    if (!setup.stock.empty() && !(isFinite(setup.stock.low) && isFinite(setup.stock.high))) return "stock_mm";
    return "";
}

constexpr std::string_view axisNames = "xyz"; // in the order of RunAxis

Setup read(const json& record) {
    Setup setup;
    setup.voxel = record.at("voxel_mm").get<double>();
    setup.marginLow = vectorOf(record.at("margin_low_mm"));
    setup.marginHigh = vectorOf(record.at("margin_high_mm"));
    setup.stockMaterial = record.at("stock_material").get<std::string>();
    setup.bodyMaterials = record.at("body_materials").get<std::vector<std::string>>();
    if (const json& stock = record.at("stock_mm"); !stock.is_null())
        setup.stock = {vectorOf(stock.at(0)), vectorOf(stock.at(1))};
    setup.workOffset = vectorOf(record.at("work_offset_mm"));
    // Left out by the versions that knew no other.
    const std::string runs = record.value("run_axis", "z");
    const std::size_t axis = runs.size() == 1 ? axisNames.find(runs) : std::string_view::npos;
    if (axis == std::string_view::npos) throw json::other_error::create(501, "run_axis", &record);
    setup.runs = static_cast<RunAxis>(axis);
    return setup;
}

} // namespace

Result<std::string> toJson(const Setup& setup) {
    if (const std::string key = notFinite(setup); !key.empty())
        return Error{ErrorCode::argumentInvalid, key, "not a number", "a finite number"};
    const json record = {
        {"voxel_mm", setup.voxel},
        {"margin_low_mm", jsonOf(setup.marginLow)},
        {"margin_high_mm", jsonOf(setup.marginHigh)},
        {"stock_material", setup.stockMaterial},
        {"body_materials", setup.bodyMaterials},
        {"stock_mm", setup.stock.empty() ? json() : json::array({jsonOf(setup.stock.low), jsonOf(setup.stock.high)})},
        {"work_offset_mm", jsonOf(setup.workOffset)},
        {"run_axis", std::string(1, axisNames[static_cast<std::size_t>(setup.runs)])},
    };
    return record.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<Setup> setupFromJson(std::string_view text) try {
    return read(json::parse(text));
} catch (const json::exception&) {
    return std::nullopt;
}

} // namespace burin
