// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/surroundings_record.h"

#include "core/document/column_codec.h"
#include "core/document/json_cylinder.h"
#include "core/document/mesh_blob.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 2> obstacleKinds{"fixture", "keep-out"}; // in the order of ObstacleKind
constexpr std::array<std::string_view, 7> guideKinds{                           // in the order of GuideKind
                                                     "plane",   "levels",    "line", "curve",
                                                     "surface", "step-over", "axis"};

template <class Kind, std::size_t count>
std::string idOf(Kind kind, const std::array<std::string_view, count>& ids) {
    return std::string(ids[static_cast<std::size_t>(kind)]);
}

/// Throws nlohmann's exceptions if `name` is none of the ids.
template <class Kind, std::size_t count>
Kind kindOf(const json& name, const std::array<std::string_view, count>& ids) {
    const auto found = std::ranges::find(ids, name.get<std::string>());
    if (found == ids.end()) throw json::other_error::create(501, "kind", &name);
    return static_cast<Kind>(found - ids.begin());
}

std::string textOf(const json& record) {
    return record.dump(-1, ' ', false, json::error_handler_t::replace);
}

// A shape in the record; a mesh is written to the blob.

void add(json& record, const Box& box) {
    record["box_mm"] = json::array({jsonOf(box.low), jsonOf(box.high)});
}

void add(json& record, const CylinderShape& cylinder) {
    record["cylinder"] = jsonOf(cylinder);
}

void add(json&, const TriangleMesh&) {}

/// Versions of Burin that don't know this key, and those that don't know the kind, see a mesh like any other.
void add(json& record, const FixtureDesign& design) {
    const FixtureKindRow& row = rowOf(design.kind);
    json values = json::object();
    for (std::size_t i = 0; i < row.parameters.size(); ++i) values[row.parameters[i].key] = design.values[i];
    record["library"] = {
        {"kind", row.id}, {"values_mm", values}, {"place_mm", jsonOf(design.place)}, {"turn_rad", design.turn}};
}

/// Empty if this version can't make such a fixture.
std::optional<FixtureDesign> fixtureDesignOf(const json& record) try {
    const std::optional<FixtureKind> kind = fixtureKindFromId(record.at("kind").get<std::string>());
    if (!kind) return std::nullopt;
    FixtureDesign design = standardFixture(*kind);
    for (const FixtureParameter& parameter : rowOf(*kind).parameters)
        setValue(design, parameter.key, record.at("values_mm").at(parameter.key).get<double>());
    design.place = vectorOf(record.at("place_mm"));
    design.turn = record.at("turn_rad").get<double>();
    if (!checkFixture(design)) return std::nullopt;
    return design;
} catch (const json::exception&) {
    return std::nullopt;
}

std::optional<Obstacle> readObstacle(const json& record, std::string_view blob) {
    Obstacle obstacle;
    obstacle.name = record.at("name").get<std::string>();
    obstacle.kind = kindOf<ObstacleKind>(record.at("kind"), obstacleKinds);
    obstacle.margin = record.at("margin_mm").get<double>();
    obstacle.on = record.at("on").get<bool>();
    if (record.contains("box_mm")) {
        obstacle.shape = Box{vectorOf(record["box_mm"].at(0)), vectorOf(record["box_mm"].at(1))};
    } else if (record.contains("cylinder")) {
        obstacle.shape = cylinderOf(record["cylinder"]);
    } else {
        std::optional<TriangleMesh> mesh = decodeMesh(blob);
        if (!mesh) return std::nullopt;
        obstacle.shape = std::move(*mesh);
        if (record.contains("library")) obstacle.design = fixtureDesignOf(record["library"]);
    }
    if (!checkObstacle(obstacle)) return std::nullopt;
    return obstacle;
}

// A curve as six columns: points, then tangents.

constexpr std::size_t curveColumns = 6;

std::string encodeCurve(const GuideCurve& curve) {
    const std::size_t count = curve.points().size();
    std::vector<Column> columns(curveColumns, Column(count));
    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            columns[static_cast<std::size_t>(axis)][i] = wordOf(curve.points()[i][axis]);
            columns[static_cast<std::size_t>(axis) + 3][i] = wordOf(curve.tangents()[i][axis]);
        }
    return encodeColumns(columns);
}

std::optional<GuideCurve> decodeCurve(std::string_view blob, std::size_t count) {
    const auto columns = decodeColumns(blob, curveColumns, count);
    if (!columns) return std::nullopt;
    std::vector<glm::dvec3> points(count), tangents(count);
    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            points[i][axis] = doubleOf((*columns)[static_cast<std::size_t>(axis)][i]);
            tangents[i][axis] = doubleOf((*columns)[static_cast<std::size_t>(axis) + 3][i]);
        }
    Result<GuideCurve> curve = GuideCurve::make(std::move(points), std::move(tangents));
    if (!curve) return std::nullopt;
    return std::move(*curve);
}

Guide readGuide(const json& record) {
    Guide guide;
    guide.kind = kindOf<GuideKind>(record.at("kind"), guideKinds);
    guide.on = record.at("on").get<bool>();
    guide.point = vectorOf(record.at("point_mm"));
    guide.direction = vectorOf(record.at("direction"));
    guide.distance = record.at("distance_mm").get<double>();
    guide.lead = record.at("lead_rad").get<double>();
    guide.tilt = record.at("tilt_rad").get<double>();
    guide.onSurface = record.at("on_surface").get<bool>();
    return guide;
}

bool isUnit(const glm::dvec3& direction) {
    return std::abs(glm::length(direction) - 1.0) < 1e-6;
}

} // namespace

RecordWithBlob recordOf(const Obstacle& obstacle) {
    json record = {{"name", obstacle.name},
                   {"kind", idOf(obstacle.kind, obstacleKinds)},
                   {"margin_mm", obstacle.margin},
                   {"on", obstacle.on}};
    std::visit([&](const auto& shape) { add(record, shape); }, obstacle.shape);
    if (obstacle.design) add(record, *obstacle.design);
    const auto* mesh = std::get_if<TriangleMesh>(&obstacle.shape);
    return {textOf(record), mesh != nullptr ? encodeMesh(*mesh) : std::string()};
}

std::optional<Obstacle> obstacleFrom(std::string_view text, std::string_view blob) try {
    return readObstacle(json::parse(text), blob);
} catch (const json::exception&) {
    return std::nullopt;
}

RecordWithBlob recordOf(const Guide& guide) {
    json record = {{"kind", idOf(guide.kind, guideKinds)},
                   {"on", guide.on},
                   {"point_mm", jsonOf(guide.point)},
                   {"direction", jsonOf(guide.direction)},
                   {"distance_mm", guide.distance},
                   {"lead_rad", guide.lead},
                   {"tilt_rad", guide.tilt},
                   {"on_surface", guide.onSurface}};
    if (guide.curve == nullptr) return {textOf(record), {}};
    record["curve_points"] = guide.curve->points().size();
    return {textOf(record), encodeCurve(*guide.curve)};
}

std::optional<Guide> guideFrom(std::string_view text, std::string_view blob, std::optional<GuideCurve>& curve) try {
    const json record = json::parse(text);
    Guide guide = readGuide(record);
    curve.reset();
    if (record.contains("curve_points")) {
        curve = decodeCurve(blob, record["curve_points"].get<std::size_t>());
        if (!curve) return std::nullopt;
        guide.curve = &*curve;
    }
    const bool usable = checkGuide(guide).hasValue();
    guide.curve = nullptr;
    if (!usable) return std::nullopt;
    return guide;
} catch (const json::exception&) {
    return std::nullopt;
}

std::string toJson(const AxisMode& axis) {
    return textOf({{"free", axis.free}, {"direction", jsonOf(axis.direction)}});
}

std::optional<AxisMode> axisModeFromJson(std::string_view text) try {
    const json record = json::parse(text);
    const AxisMode axis{record.at("free").get<bool>(), vectorOf(record.at("direction"))};
    if (!isUnit(axis.direction)) return std::nullopt;
    return axis;
} catch (const json::exception&) {
    return std::nullopt;
}

std::string toJson(const TravelPlacement& placement) {
    return textOf({{"on", placement.on}, {"zero_mm", placement.zero ? jsonOf(*placement.zero) : json()}});
}

std::optional<TravelPlacement> travelPlacementFromJson(std::string_view text) try {
    const json record = json::parse(text);
    TravelPlacement placement;
    placement.on = record.at("on").get<bool>();
    if (const json& zero = record.at("zero_mm"); !zero.is_null()) placement.zero = vectorOf(zero);
    return placement;
} catch (const json::exception&) {
    return std::nullopt;
}

std::string programDraftToJson(const std::string& text) {
    return textOf(text);
}

std::optional<std::string> programDraftFromJson(std::string_view text) try {
    return json::parse(text).get<std::string>();
} catch (const json::exception&) {
    return std::nullopt;
}

std::string toJson(const ProgramTarget& target) {
    return textOf({{"machine", target.machine}, {"dialect", target.dialect}, {"units", idOf(target.units)}});
}

std::optional<ProgramTarget> programTargetFromJson(std::string_view text) try {
    const json record = json::parse(text);
    ProgramTarget target{record.at("machine").get<std::string>(), record.at("dialect").get<std::string>(), {}};
    // Projects from before units could be chosen have none.
    const auto units = ncUnitsFromId(record.value("units", std::string(idOf(NcUnits::millimetre))));
    if (!units) return std::nullopt;
    target.units = *units;
    return target;
} catch (const json::exception&) {
    return std::nullopt;
}

} // namespace burin
