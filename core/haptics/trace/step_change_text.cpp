// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/step_change_text.h"

#include "core/base/json_object.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using nlohmann::json;

const std::vector<std::string_view> guideKinds{"plane", "levels", "line", "curve", "surface", "step_over", "axis"};
const std::vector<std::string_view> controls{"position", "rate"};
const std::vector<std::string_view> strokeChanges{"undone", "redone"};
constexpr int mostCurves = 4096, mostLevels = 1'000'000, mostLayers = 1024;
constexpr int mostTiles = 1 << 24;
constexpr double largestWord = 4294967295.0; // 32 bits of buttons, counts

double finite(double value) {
    return std::isfinite(value) ? value : 0.0;
}

json listOf(const glm::dvec3& v) {
    return {finite(v.x), finite(v.y), finite(v.z)};
}

json flat(std::span<const glm::dvec3> vectors) {
    json numbers = json::array();
    for (const glm::dvec3& v : vectors)
        for (int axis = 0; axis < 3; ++axis) numbers.push_back(v[axis]);
    return numbers;
}

glm::dvec3 vectorOf(const std::vector<double>& numbers, std::size_t at = 0) {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

std::vector<glm::dvec3> vectorsOf(const std::vector<double>& numbers) {
    std::vector<glm::dvec3> vectors;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) vectors.push_back(vectorOf(numbers, i));
    return vectors;
}

std::uint32_t word(JsonObject& object, std::string_view key) {
    const double number = object.number(key, {0.0, largestWord});
    if (std::floor(number) != number) object.fail(key, "has to be a whole number");
    return static_cast<std::uint32_t>(number);
}

json toJson(const Guide& guide, int curve) {
    return {{"kind", guideKinds[static_cast<std::size_t>(guide.kind)]},
            {"on", guide.on},
            {"point_mm", listOf(guide.point)},
            {"direction", listOf(guide.direction)},
            {"distance_mm", finite(guide.distance)},
            {"lead_rad", finite(guide.lead)},
            {"tilt_rad", finite(guide.tilt)},
            {"on_surface", guide.onSurface},
            {"curve", curve}};
}

Guide readGuide(JsonObject& object, const std::vector<std::unique_ptr<const GuideCurve>>& curves) {
    Guide guide;
    guide.kind = static_cast<GuideKind>(object.choice("kind", guideKinds));
    guide.on = object.boolean("on");
    guide.point = vectorOf(object.numbers("point_mm", 3));
    guide.direction = vectorOf(object.numbers("direction", 3));
    guide.distance = object.number("distance_mm");
    guide.lead = object.number("lead_rad");
    guide.tilt = object.number("tilt_rad");
    guide.onSurface = object.boolean("on_surface");
    const int curve = object.integer("curve", -1, mostCurves);
    if (curve >= static_cast<int>(curves.size()))
        object.fail("curve", "was not given before");
    else if (curve >= 0)
        guide.curve = curves[static_cast<std::size_t>(curve)].get();
    return guide;
}

json toJson(const WorkspaceSettings& workspace) {
    json object{{"clutched", workspace.clutched},
                {"clutch_button", workspace.clutchButton},
                {"recentrings", workspace.recentrings},
                {"control", controls[static_cast<std::size_t>(workspace.control)]}};
    if (workspace.scale && std::isfinite(*workspace.scale)) object["scale"] = *workspace.scale;
    if (const auto& q = workspace.rotation; q && std::isfinite(q->w + q->x + q->y + q->z))
        object["rotation"] = {q->w, q->x, q->y, q->z};
    const Box& region = workspace.region;
    if (!region.empty() && isFinite(region.low) && isFinite(region.high))
        object.update({{"region_low_mm", listOf(region.low)}, {"region_high_mm", listOf(region.high)}});
    return object;
}

WorkspaceSettings readWorkspace(JsonObject& object) {
    WorkspaceSettings workspace;
    workspace.clutched = object.boolean("clutched");
    workspace.clutchButton = word(object, "clutch_button");
    workspace.recentrings = word(object, "recentrings");
    workspace.control = static_cast<WorkspaceControl>(object.choice("control", controls));
    if (object.has("scale")) workspace.scale = object.number("scale");
    if (object.has("rotation")) {
        const std::vector<double> q = object.numbers("rotation", 4);
        workspace.rotation = glm::dquat(q[0], q[1], q[2], q[3]);
    }
    if (object.has("region_low_mm")) {
        workspace.region.low = vectorOf(object.numbers("region_low_mm", 3));
        workspace.region.high = vectorOf(object.numbers("region_high_mm", 3));
    }
    return workspace;
}

struct ToJson {
    json operator()(const AllowanceChange& change) const { return {{"allowance_mm", finite(change.allowance)}}; }
    json operator()(const GuideSettings&) const { return {}; } // handled separately: it needs the curves' numbers
    json operator()(const LevelStep& change) const { return {{"levels", change.levels}}; }
    json operator()(const WorkspaceSettings& change) const { return {{"workspace", toJson(change)}}; }
    json operator()(const LayerSwitch& change) const { return {{"layer", change.layer}, {"on", change.on}}; }
    json operator()(const SpindleRelease& change) const { return {{"spindle_released", change.released}}; }
    json operator()(const TakeBegin&) const { return {{"take_begins", true}}; }
    json operator()(const ForceWithheld&) const { return {{"force_withheld", true}}; }
    json operator()(const CutResumption&) const { return {{"cutting_resumes", true}}; }
    json operator()(const WorkpieceChange& change) const { return {{"stroke", strokeChanges[change.undone ? 0 : 1]}}; }
    json operator()(const TileChange& change) const { return {{"tile", change.tile}, {"there", change.there}}; }
};

/// A change without parameters.
template <class Change>
Change marked(JsonObject& object, std::string_view key) {
    if (!object.boolean(key)) object.fail(key, "has to be true");
    return {};
}

/// Reads every change that consists only of its own numbers; empty for guides and curves.
std::optional<StepChange> plainChange(JsonObject& object) {
    if (object.has("allowance_mm")) return AllowanceChange{object.number("allowance_mm", {0.0, 10.0})};
    if (object.has("levels")) return LevelStep{object.integer("levels", -mostLevels, mostLevels)};
    if (object.has("workspace")) {
        WorkspaceSettings workspace;
        object.object("workspace", [&](JsonObject& inner) { workspace = readWorkspace(inner); });
        return workspace;
    }
    if (object.has("layer")) {
        const int layer = object.integer("layer", 0, mostLayers);
        return LayerSwitch{static_cast<std::size_t>(layer), object.boolean("on")};
    }
    if (object.has("spindle_released")) return SpindleRelease{object.boolean("spindle_released")};
    if (object.has("take_begins")) return marked<TakeBegin>(object, "take_begins");
    if (object.has("force_withheld")) return marked<ForceWithheld>(object, "force_withheld");
    if (object.has("cutting_resumes")) return marked<CutResumption>(object, "cutting_resumes");
    if (object.has("stroke")) return WorkpieceChange{object.choice("stroke", strokeChanges) == 0};
    if (object.has("workpiece_changed")) // of versions that could not play it
        object.fail("workpiece_changed", "the workpiece was changed there by something else than milling");
    if (object.has("tile")) {
        const int tile = object.integer("tile", 0, mostTiles);
        return TileChange{static_cast<std::uint32_t>(tile), object.boolean("there")};
    }
    return std::nullopt;
}

void appendLine(std::string& text, std::string_view before, const json& object) {
    text += before;
    text += object.dump();
    text += '\n';
}

} // namespace

int StepChangeWriter::numberOf(const GuideCurve* curve, std::string& text, std::string_view before) {
    if (curve == nullptr) return -1;
    const auto known = std::ranges::find(curves_, curve);
    const auto number = static_cast<int>(known - curves_.begin());
    if (known != curves_.end()) return number;
    curves_.push_back(curve);
    appendLine(text, before,
               {{"curve", number},
                {"points", curve->points().size()},
                {"points_mm", flat(curve->points())},
                {"tangents", flat(curve->tangents())}});
    return number;
}

void StepChangeWriter::append(std::string& text, std::string_view before, const StepChange& change) {
    json object = std::visit(ToJson{}, change);
    if (const auto* guides = std::get_if<GuideSettings>(&change)) {
        json list = json::array();
        for (const Guide& guide : guides->guides) list.push_back(toJson(guide, numberOf(guide.curve, text, before)));
        object = {{"guides", std::move(list)}, {"step_button", guides->stepButton}};
    }
    appendLine(text, before, object);
}

Result<GuideSettings> StepChangeReader::readGuides(JsonObject& object) const {
    GuideSettings settings;
    std::size_t count = 0;
    object.objects("guides", [&](JsonObject& one) {
        const Guide guide = readGuide(one, curves_);
        if (count < settings.guides.size()) settings.guides[count] = guide;
        ++count;
    });
    if (count != settings.guides.size()) object.fail("guides", "has to hold " + std::to_string(settings.guides.size()));
    settings.stepButton = word(object, "step_button");
    if (Result<void> good = checkGuides(settings); !good) return std::move(good).error();
    return settings;
}

/// @param longest text length of the object: each of a curve's numbers takes two characters or more, which limits the
/// memory that a false count can reserve
Result<void> StepChangeReader::readCurve(JsonObject& object, std::size_t longest) {
    const int most = static_cast<int>(std::min<std::size_t>(longest / 2, 1'000'000));
    const int number = object.integer("curve", 0, mostCurves), points = object.integer("points", 0, most);
    if (number != static_cast<int>(curves_.size())) object.fail("curve", "has to be the next number");
    const auto count = 3 * static_cast<std::size_t>(points);
    const std::vector<double> places = object.numbers("points_mm", count), tangents = object.numbers("tangents", count);
    if (Result<void> whole = object.finish(); !whole) return whole;
    Result<GuideCurve> curve = GuideCurve::make(vectorsOf(places), vectorsOf(tangents));
    if (!curve) return std::move(curve).error();
    curves_.push_back(std::make_unique<const GuideCurve>(std::move(*curve)));
    return {};
}

Result<std::optional<StepChange>> StepChangeReader::read(std::string_view text, const std::string& origin) {
    Result<JsonObject> parsed = JsonObject::parse(text, origin);
    if (!parsed) return std::move(parsed).error();
    JsonObject& object = *parsed;
    std::optional<StepChange> change = plainChange(object);
    if (!change && object.has("guides")) {
        Result<GuideSettings> guides = readGuides(object);
        if (!guides) return std::move(guides).error();
        change = *guides;
    }
    if (!change) {
        if (Result<void> curve = readCurve(object, text.size()); !curve) return std::move(curve).error();
        return change;
    }
    if (Result<void> whole = object.finish(); !whole) return std::move(whole).error();
    return change;
}

} // namespace burin
