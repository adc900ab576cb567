// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/report_json.h"

#include "core/verify/excess.h"
#include "core/verify/load_chart.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace burin {

using nlohmann::json;

namespace {

const char* idOf(RapidMode mode) {
    switch (mode) {
    case RapidMode::synchronised:
        return "synchronised";
    case RapidMode::independent:
        return "independent";
    case RapidMode::tip:
        return "tip";
    }
    return "unknown";
}

const char* idOf(PathMode mode) {
    switch (mode) {
    case PathMode::machine:
        return "machine";
    case PathMode::exactPath:
        return "exact_path";
    case PathMode::exactStop:
        return "exact_stop";
    case PathMode::blend:
        return "blend";
    }
    return "unknown";
}

/// A tolerance of null means no limit.
json modesOf(const std::vector<StatedPathMode>& modes) {
    json list = json::array();
    for (const StatedPathMode& mode : modes) {
        json entry{{"line", mode.line}, {"mode", idOf(mode.mode)}};
        if (mode.mode == PathMode::blend) entry["tolerance_mm"] = mode.tolerance > 0.0 ? json(mode.tolerance) : json();
        list.push_back(std::move(entry));
    }
    return list;
}

json jsonOf(const glm::dvec3& v) {
    return json::array({v.x, v.y, v.z});
}

json jsonOf(const CutLoad& load) {
    return {{"at_s", load.at},
            {"place_mm", jsonOf(load.place)},
            {"removal_rate_mm3_s", load.removalRate},
            {"force_n", load.force},
            {"radial_force_n", load.radial},
            {"axial_force_n", load.axial},
            {"force_on_tool_n", jsonOf(load.vector)},
            {"power_w", load.power},
            {"torque_nm", load.torque},
            {"feed_per_tooth_mm", load.feedPerTooth},
            {"mean_chip_mm", load.chip},
            {"depth_mm", load.depth},
            {"width_mm", load.width}};
}

/// Null if nothing is removed.
json peakOf(const VerifyReport& report) {
    const MotionLoad* const peak = peakLoad(report.loads);
    if (peak == nullptr) return nullptr;
    json entry = jsonOf(peak->peak);
    entry["line"] = peak->line;
    return entry;
}

json jsonOf(const Finding& finding) {
    json entry{{"kind", idOf(finding.kind)},
               {"line", finding.line},
               {"place_mm", jsonOf(finding.place)},
               {"amount", finding.amount}};
    if (const std::string_view unit = unitOf(finding.kind); !unit.empty()) entry["unit"] = unit;
    if (finding.limit > 0.0) entry["limit"] = finding.limit;
    if (finding.limit > 0.0 || finding.count > 1) entry["count"] = finding.count;
    return entry;
}

glm::dvec3 placeFrom(const json& place) {
    return {place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>()};
}

/// Throws nlohmann's exceptions if the id is unknown.
FindingKind findingKindFrom(const json& id) {
    for (int kind = 0; kind <= static_cast<int>(lastFindingKind); ++kind)
        if (id.get<std::string>() == idOf(static_cast<FindingKind>(kind))) return static_cast<FindingKind>(kind);
    throw json::other_error::create(501, "finding", &id);
}

Finding findingFrom(const json& entry) {
    return {findingKindFrom(entry.at("kind")), entry.at("line").get<std::uint32_t>(),
            placeFrom(entry.at("place_mm")),   entry.at("amount").get<double>(),
            entry.value("limit", 0.0),         entry.value("count", 1U)};
}

NearPass nearPassFrom(const json& entry) {
    NearPass pass;
    pass.line = entry.at("line").get<std::uint32_t>();
    pass.place = placeFrom(entry.at("place_mm"));
    pass.distance = entry.at("distance_mm").get<double>();
    pass.lines = entry.value("lines", 1U); // not in verdicts of earlier versions
    for (const ToolSection section : {ToolSection::shank, ToolSection::holder})
        for (const NearTo to : {NearTo::stock, NearTo::part, NearTo::obstacle}) {
            pass.section = section;
            pass.to = to;
            if (entry.at("kind").get<std::string>() == idOf(pass)) return pass;
        }
    throw json::other_error::create(501, "near pass", &entry);
}

json recordOf(const TouchedVoxels& area) {
    json centres = json::array();
    for (const glm::dvec3& centre : area.centres) centres.push_back({centre.x, centre.y, centre.z});
    const glm::dvec3 &tip = area.pose.tip, &axis = area.pose.axis;
    return {{"line", area.line},
            {"tip_mm", {tip.x, tip.y, tip.z}},
            {"axis", {axis.x, axis.y, axis.z}},
            {"voxel_mm", area.edge},
            {"centres_mm", std::move(centres)}};
}

TouchedVoxels touchedFrom(const json& entry) {
    TouchedVoxels area;
    area.line = entry.at("line").get<std::uint32_t>();
    area.pose = {placeFrom(entry.at("tip_mm")), placeFrom(entry.at("axis"))};
    area.edge = entry.at("voxel_mm").get<double>();
    for (const json& centre : entry.at("centres_mm")) area.centres.push_back(placeFrom(centre));
    return area;
}

} // namespace

std::string toJson(const VerifyReport& report) {
    json findings = json::array();
    for (const Finding& finding : report.findings) findings.push_back(jsonOf(finding));
    json loadWarnings = json::array();
    for (const Finding& warning : report.warnings) loadWarnings.push_back(jsonOf(warning));
    json warnings = json::array();
    for (const NearPass& pass : report.nearPasses)
        warnings.push_back({{"kind", idOf(pass)},
                            {"line", pass.line},
                            {"place_mm", json::array({pass.place.x, pass.place.y, pass.place.z})},
                            {"distance_mm", pass.distance},
                            {"lines", pass.lines}});
    json touched = json::array();
    for (const TouchedVoxels& area : report.touched) touched.push_back(recordOf(area));
    return json{{"passed", report.passed()},
                {"touched", std::move(touched)},
                {"gouge_max_mm", report.gougeMax},
                {"gouge_max_mesh_mm", report.gougeMaxMesh},
                {"excess_max_mm", report.excessMax},
                {"excess_limit_mm", longestExcess},
                {"excess_mean_mm", report.excessMean},
                {"reachable_share", report.reachableShare},
                {"removed_mm3", report.removed},
                {"on_part_share", report.onPartShare},
                {"on_part_samples", report.onPartSamples},
                {"samples_checked", report.samples},
                {"samples_exact", report.exactSamples},
                {"machining_s", report.machiningSeconds},
                {"machining_without_acceleration_s", report.secondsWithoutAcceleration},
                {"moves_without_time", report.untimedMoves},
                {"machining_contains", {"accelerations", "corners", "dwells", "tool_changes"}},
                {"tool_changes", report.toolChanges},
                {"rapids", idOf(report.rapids)},
                {"path_modes", modesOf(report.pathModes)},
                {"peak_load", peakOf(report)},
                {"findings", findings},
                {"load_warnings", loadWarnings},
                {"warnings", warnings}}
        .dump();
}

std::string loadsToJson(const VerifyReport& report) {
    json blocks = json::array();
    for (const MotionLoad& load : report.loads)
        blocks.push_back({{"line", load.line},
                          {"start_s", load.start},
                          {"duration_s", load.duration},
                          {"removed_mm3", load.volume},
                          {"mean_removal_rate_mm3_s", load.removalRate},
                          {"mean_force_n", load.force},
                          {"mean_power_w", load.power},
                          {"peak", jsonOf(load.peak)}});
    constexpr std::size_t intervals = 500;
    std::vector<double> force(intervals), power(intervals);
    const auto intervalAt = [&](double time) {
        const double share = report.machiningSeconds > 0.0 ? time / report.machiningSeconds : 0.0;
        return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * (intervals - 1.0));
    };
    for (const LoadStep& step : report.loadSteps)
        for (std::size_t i = intervalAt(step.start); i <= intervalAt(step.start + step.duration); ++i) {
            force[i] = std::max(force[i], static_cast<double>(step.force));
            power[i] = std::max(power[i], static_cast<double>(step.power));
        }
    return json{{"load_by_block", blocks},
                {"load_over_time",
                 {{"interval_s", report.machiningSeconds / (intervals - 1.0)}, {"force_n", force}, {"power_w", power}}}}
        .dump();
}

std::optional<VerifyReport> reportFromJson(std::string_view text) try {
    const json record = json::parse(text);
    VerifyReport report;
    record.at("gouge_max_mm").get_to(report.gougeMax);
    record.at("gouge_max_mesh_mm").get_to(report.gougeMaxMesh);
    record.at("excess_max_mm").get_to(report.excessMax);
    record.at("excess_mean_mm").get_to(report.excessMean);
    record.at("reachable_share").get_to(report.reachableShare);
    record.at("removed_mm3").get_to(report.removed);
    record.at("on_part_share").get_to(report.onPartShare);
    record.at("on_part_samples").get_to(report.onPartSamples);
    record.at("samples_checked").get_to(report.samples);
    record.at("samples_exact").get_to(report.exactSamples);
    record.at("machining_s").get_to(report.machiningSeconds);
    record.at("machining_without_acceleration_s").get_to(report.secondsWithoutAcceleration);
    for (const json& entry : record.at("findings")) report.findings.push_back(findingFrom(entry));
    for (const json& entry : record.value("load_warnings", json::array())) // since loads are judged
        report.warnings.push_back(findingFrom(entry));
    report.toolChanges = record.value("tool_changes", 0);
    report.untimedMoves = record.value("moves_without_time", 0);
    for (const json& entry : record.at("warnings")) report.nearPasses.push_back(nearPassFrom(entry));
    if (const auto touched = record.find("touched"); touched != record.end()) // not in verdicts of earlier versions
        for (const json& entry : *touched) report.touched.push_back(touchedFrom(entry));
    if (record.at("passed").get<bool>() != report.passed()) return std::nullopt;
    return report;
} catch (const json::exception&) {
    return std::nullopt;
}

} // namespace burin
