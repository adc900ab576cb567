// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/setup_record.h"

#include "core/document/json_cylinder.h"
#include "core/document/json_placement.h"
#include "core/geometry/pose.h"
#include "core/nc/work_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

/// Returns the key of the first number that JSON can't represent; empty if there is none.
const char* notFinite(const Setup& setup) {
    if (!std::isfinite(setup.voxel)) return "voxel_mm";
    if (!isFinite(setup.marginLow)) return "margin_low_mm";
    if (!isFinite(setup.marginHigh)) return "margin_high_mm";
    if (!isFinite(setup.workOffset)) return "work_offset_mm";
    if (!isFinite(setup.zero.point)) return "point_mm";
    if (!isSound(setup.placement)) return "placement";
    const CylinderShape& cylinder = setup.cylinder;
    if (!isFinite(cylinder.base) || !isFinite(cylinder.axis) || !std::isfinite(cylinder.radius) ||
        !std::isfinite(cylinder.height))
        return "stock_cylinder";
    const auto isSound = [](const MaterialRegion& region) {
        return !std::isnan(region.from) && !std::isnan(region.to);
    };
    if (!std::ranges::all_of(setup.regions, isSound)) return "regions";
    if (!setup.stock.empty() && !(isFinite(setup.stock.low) && isFinite(setup.stock.high))) return "stock_mm";
    return "";
}

constexpr std::string_view axisNames = "xyz"; // in the order of RunAxis

std::string axisName(int axis) {
    return std::string(1, axisNames[static_cast<std::size_t>(axis)]);
}

[[noreturn]] void refuse(const char* key, const json& record) {
    throw json::other_error::create(501, key, &record);
}

int axisOf(const std::string& name, const char* key, const json& record) {
    const std::size_t axis = name.size() == 1 ? axisNames.find(name) : std::string_view::npos;
    if (axis == std::string_view::npos) refuse(key, record);
    return static_cast<int>(axis);
}

/// JSON has no infinity, so a side without a plane is null.
json planeOf(double place) {
    return std::isfinite(place) ? json(place) : json();
}

json recordOf(const RegionGrade& grade) {
    json table = json::array();
    for (const Grading::Control& control : grade.table) table.push_back({control.distance, control.value});
    return {{"value", grade.value},
            {"formula", grade.formula},
            {"axis", axisName(grade.axis)},
            {"table", std::move(table)},
            {"bands", grade.entries}};
}

json recordOf(const MaterialRegion& region) {
    return {{"name", region.name},           {"material", region.material},
            {"axis", axisName(region.axis)}, {"from_mm", planeOf(region.from)},
            {"to_mm", planeOf(region.to)},   {"grade", region.grade ? recordOf(*region.grade) : json()}};
}

RegionGrade gradeOf(const json& record) {
    RegionGrade grade;
    grade.value = record.at("value").get<std::string>();
    grade.formula = record.at("formula").get<std::string>();
    grade.axis = axisOf(record.at("axis").get<std::string>(), "axis", record);
    for (const json& line : record.at("table"))
        grade.table.push_back({line.at(0).get<double>(), line.at(1).get<double>()});
    grade.entries = record.at("bands").get<int>();
    return grade;
}

MaterialRegion regionOf(const json& record) {
    MaterialRegion region;
    region.name = record.at("name").get<std::string>();
    region.material = record.at("material").get<std::string>();
    region.axis = axisOf(record.at("axis").get<std::string>(), "axis", record);
    if (const json& from = record.at("from_mm"); !from.is_null()) region.from = from.get<double>();
    if (const json& to = record.at("to_mm"); !to.is_null()) region.to = to.get<double>();
    if (const json& grade = record.at("grade"); !grade.is_null()) region.grade = gradeOf(grade);
    return region;
}

/// Data that versions before 5 did not write: every body was a part in a box of one material.
void readStock(const json& record, Setup& setup) {
    if (!record.contains("roles")) return;
    for (const json& id : record.at("roles")) {
        const std::optional<BodyRole> role = bodyRoleFromId(id.get<std::string>());
        if (!role) refuse("roles", record);
        setup.roles.push_back(*role);
    }
    const std::optional<StockForm> form = stockFormFromId(record.at("stock_form").get<std::string>());
    if (!form) refuse("stock_form", record);
    setup.form = *form;
    setup.stated = record.at("stock_stated").get<bool>();
    setup.cylinder = cylinderOf(record.at("stock_cylinder"));
    setup.freeCarving = record.at("free_carving").get<bool>();
    for (const json& region : record.at("regions")) setup.regions.push_back(regionOf(region));
}

/// Stored since version 7.
void readPlacement(const json& record, Setup& setup) {
    if (!record.contains("placement")) return;
    if (const json& placement = record.at("placement"); !placement.is_null()) setup.placement = placementOf(placement);
    if (const json& origin = record.at("left_by"); !origin.is_null())
        setup.leftBy = {SetupId{origin.at("setup").get<std::int64_t>()}, origin.at("digest").get<std::int64_t>()};
}

json recordOf(const ProgramZero& zero) {
    json sides = json::array();
    for (const BoxSide side : zero.sides) sides.push_back(idOf(side));
    return {{"work_offset", workOffsetName(zero.workOffset)},
            {"on", idOf(zero.on)},
            {"sides", std::move(sides)},
            {"point_mm", jsonOf(zero.point)}};
}

/// Stored since version 8; before, it was always the default.
void readZero(const json& record, Setup& setup) {
    if (!record.contains("zero")) return;
    const json& zero = record.at("zero");
    const std::optional<int> number = workOffsetFromName(zero.at("work_offset").get<std::string>());
    const std::optional<ZeroReference> on = zeroReferenceFromId(zero.at("on").get<std::string>());
    if (!number || !on) refuse("zero", record);
    for (std::size_t axis = 0; axis < setup.zero.sides.size(); ++axis) {
        const std::optional<BoxSide> side = boxSideFromId(zero.at("sides").at(axis).get<std::string>());
        if (!side) refuse("sides", zero);
        setup.zero.sides[axis] = *side;
    }
    setup.zero.workOffset = *number;
    setup.zero.on = *on;
    setup.zero.point = vectorOf(zero.at("point_mm"));
}

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
    // Not written by the versions that supported no other axis.
    setup.runs = static_cast<RunAxis>(axisOf(record.value("run_axis", "z"), "run_axis", record));
    readStock(record, setup);
    readPlacement(record, setup);
    readZero(record, setup);
    return setup;
}

} // namespace

Result<std::string> toJson(const Setup& setup) {
    if (const std::string key = notFinite(setup); !key.empty())
        return Error{ErrorCode::argumentInvalid, key, "not a number", "a finite number"};
    json roles = json::array(), regions = json::array();
    for (const BodyRole role : setup.roles) roles.push_back(idOf(role));
    for (const MaterialRegion& region : setup.regions) regions.push_back(recordOf(region));
    const json record = {
        {"voxel_mm", setup.voxel},
        {"margin_low_mm", jsonOf(setup.marginLow)},
        {"margin_high_mm", jsonOf(setup.marginHigh)},
        {"stock_material", setup.stockMaterial},
        {"body_materials", setup.bodyMaterials},
        {"stock_mm", setup.stock.empty() ? json() : json::array({jsonOf(setup.stock.low), jsonOf(setup.stock.high)})},
        {"work_offset_mm", jsonOf(setup.workOffset)},
        {"zero", recordOf(setup.zero)},
        {"run_axis", axisName(static_cast<int>(setup.runs))},
        {"roles", std::move(roles)},
        {"stock_form", idOf(setup.form)},
        {"stock_stated", setup.stated},
        {"stock_cylinder", jsonOf(setup.cylinder)},
        {"free_carving", setup.freeCarving},
        {"regions", std::move(regions)},
        {"stock_checksum", setup.volume ? json(setup.volume->checksum()) : json()},
        {"placement", isNone(setup.placement) ? json() : jsonOf(setup.placement)},
        {"left_by",
         setup.leftBy ? json{{"setup", numberOf(setup.leftBy->setup)}, {"digest", setup.leftBy->digest}} : json()},
    };
    return record.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<Setup> setupFromJson(std::string_view text) try {
    return read(json::parse(text));
} catch (const json::exception&) {
    return std::nullopt;
}

std::optional<std::uint64_t> stockChecksumOf(std::string_view text) try {
    const json record = json::parse(text);
    const auto found = record.find("stock_checksum"); // since version 6
    if (found == record.end() || !found->is_number_unsigned()) return std::nullopt;
    return found->get<std::uint64_t>();
} catch (const json::exception&) {
    return std::nullopt;
}

} // namespace burin
