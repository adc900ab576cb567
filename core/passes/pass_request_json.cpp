// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/json_object.h"
#include "core/passes/pass_request.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace burin {

namespace {

using nlohmann::ordered_json;

struct NumberKey {
    const char* key;
    double PassRequest::*member;
};
constexpr NumberKey numberKeys[] = {
    {"allowance_mm", &PassRequest::allowance},
    {"step_over_mm", &PassRequest::stepOver},
    {"scallop_mm", &PassRequest::scallop},
    {"level_depth_mm", &PassRequest::levelDepth},
    {"stairs_mm", &PassRequest::stairs},
    {"direction_rad", &PassRequest::direction},
    {"flattest_rad", &PassRequest::flattest},
    {"steepest_rad", &PassRequest::steepest},
    {"depth_mm", &PassRequest::depth},
    {"tab_width_mm", &PassRequest::tabWidth},
    {"tab_height_mm", &PassRequest::tabHeight},
    {"pitch_mm", &PassRequest::pitch},
    {"major_diameter_mm", &PassRequest::majorDiameter},
    {"overlap_mm", &PassRequest::overlap},
    {"finished_within_mm", &PassRequest::finishedWithin},
};
struct SwitchKey {
    const char* key;
    bool PassRequest::*member;
};
constexpr SwitchKey switchKeys[] = {
    {"one_way", &PassRequest::oneWay},        {"inside", &PassRequest::inside},
    {"rest_only", &PassRequest::restOnly},    {"area_on_part", &PassRequest::areaOnPart},
    {"dogbones", &PassRequest::dogbones},     {"external", &PassRequest::external},
    {"left_hand", &PassRequest::leftHand},    {"conventional", &PassRequest::conventional},
    {"spring_pass", &PassRequest::springPass}};
struct HeightKey {
    const char* key;
    std::optional<double> PassRequest::*member;
};
constexpr HeightKey heightKeys[] = {{"top_mm", &PassRequest::top}, {"bottom_mm", &PassRequest::bottom}};

constexpr NumberRange coordinates{-farthestInPlan, farthestInPlan};

} // namespace

std::string toJson(const PassRequest& request) {
    const PassRequest plain;
    ordered_json text{{"pass", rowOf(request.kind).id}};
    for (const NumberKey& row : numberKeys)
        if (request.*row.member != plain.*row.member) text[row.key] = request.*row.member;
    for (const HeightKey& row : heightKeys)
        if (request.*row.member) text[row.key] = *(request.*row.member);
    for (const SwitchKey& row : switchKeys)
        if (request.*row.member) text[row.key] = true;
    for (const PlanRing& ring : request.area.rings) {
        ordered_json corners = ordered_json::array();
        for (const glm::dvec2& place : ring) corners.insert(corners.end(), {place.x, place.y});
        text["area"].push_back({{"corners_mm", std::move(corners)}});
    }
    for (const PassLine& line : request.lines) {
        ordered_json places = ordered_json::array();
        for (const glm::dvec3& place : line) places.insert(places.end(), {place.x, place.y, place.z});
        text["lines"].push_back({{"places_mm", std::move(places)}});
    }
    for (const glm::dvec2& place : request.places) {
        text["places_mm"].push_back(place.x);
        text["places_mm"].push_back(place.y);
    }
    for (const PassLead& lead : request.leads) text["leads"].push_back({{"take", lead.take}, {"lines", lead.lines}});
    if (request.hand != HandStrokes::ignore) text["hand"] = handStrokesIds[static_cast<std::size_t>(request.hand)];
    if (!request.strokesDigest.empty()) text["strokes_digest"] = request.strokesDigest;
    if (request.tabs != 0) text["tabs"] = request.tabs;
    if (request.radialPasses != 1) text["radial_passes"] = request.radialPasses;
    return text.dump();
}

Result<PassRequest> passRequestFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return std::move(file).error();
    const Result<PassKind> kind = passKindWithId(file->text("pass"));
    PassRequest request;
    for (const NumberKey& row : numberKeys) request.*row.member = file->numberOr(row.key, request.*row.member);
    for (const HeightKey& row : heightKeys)
        if (file->has(row.key)) request.*row.member = file->number(row.key, coordinates);
    for (const SwitchKey& row : switchKeys) request.*row.member = file->booleanOr(row.key, false);
    if (file->has("area"))
        file->objects("area", [&](JsonObject& ring) {
            const std::vector<double> flat = ring.numbers("corners_mm", coordinates, 2);
            PlanRing& corners = request.area.rings.emplace_back();
            for (std::size_t i = 0; i + 1 < flat.size(); i += 2) corners.emplace_back(flat[i], flat[i + 1]);
        });
    if (file->has("lines"))
        file->objects("lines", [&](JsonObject& line) {
            const std::vector<double> flat = line.numbers("places_mm", coordinates, 3);
            PassLine& places = request.lines.emplace_back();
            for (std::size_t i = 0; i + 2 < flat.size(); i += 3) places.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
        });
    if (file->has("leads"))
        file->objects("leads", [&](JsonObject& lead) {
            request.leads.push_back(
                {static_cast<std::int64_t>(lead.number("take", {1.0, 1e15})), lead.integer("lines", 1, 1'000'000)});
        });
    if (file->has("hand"))
        request.hand = static_cast<HandStrokes>(
            file->choice("hand", std::vector<std::string_view>(handStrokesIds.begin(), handStrokesIds.end())));
    if (file->has("strokes_digest")) request.strokesDigest = file->text("strokes_digest");
    if (file->has("places_mm")) {
        const std::vector<double> flat = file->numbers("places_mm", coordinates, 2);
        for (std::size_t i = 0; i + 1 < flat.size(); i += 2) request.places.emplace_back(flat[i], flat[i + 1]);
    }
    if (file->has("tabs")) request.tabs = file->integer("tabs", 0, mostTabs);
    if (file->has("radial_passes")) request.radialPasses = file->integer("radial_passes", 1, mostRadialPasses);
    if (Result<void> read = file->finish(); !read) return std::move(read).error();
    if (!kind) return kind.error();
    request.kind = *kind;
    if (Result<void> valid = validate(request); !valid) return std::move(valid).error();
    return request;
}

} // namespace burin
