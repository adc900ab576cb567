// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/report_json.h"

#include "core/verify/excess.h"
#include "core/verify/load_chart.h"

#include <nlohmann/json.hpp>

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

/// A tolerance of null: without limit.
json modesOf(const std::vector<StatedPathMode>& modes) {
    json list = json::array();
    for (const StatedPathMode& mode : modes) {
        json entry{{"line", mode.line}, {"mode", idOf(mode.mode)}};
        if (mode.mode == PathMode::blend) entry["tolerance_mm"] = mode.tolerance > 0.0 ? json(mode.tolerance) : json();
        list.push_back(std::move(entry));
    }
    return list;
}

/// Null where nothing is removed.
json peakOf(const VerifyReport& report) {
    const MotionLoad* const peak = peakLoad(report.loads);
    if (peak == nullptr) return nullptr;
    return {{"line", peak->line},
            {"place_mm", json::array({peak->place.x, peak->place.y, peak->place.z})},
            {"removal_rate_mm3_s", peak->removalRate},
            {"force_n", peak->force},
            {"power_w", peak->power},
            {"at_s", peak->start}};
}

glm::dvec3 placeFrom(const json& place) {
    return {place.at(0).get<double>(), place.at(1).get<double>(), place.at(2).get<double>()};
}

/// Throws nlohmann's exceptions where the id is none.
FindingKind findingKindFrom(const json& id) {
    for (int kind = 0; kind <= static_cast<int>(FindingKind::obstacleCollision); ++kind)
        if (id.get<std::string>() == idOf(static_cast<FindingKind>(kind))) return static_cast<FindingKind>(kind);
    throw json::other_error::create(501, "finding", &id);
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

} // namespace

std::string toJson(const VerifyReport& report) {
    json findings = json::array();
    for (const Finding& finding : report.findings)
        findings.push_back({{"kind", idOf(finding.kind)},
                            {"line", finding.line},
                            {"place_mm", json::array({finding.place.x, finding.place.y, finding.place.z})},
                            {"amount", finding.amount}});
    json warnings = json::array();
    for (const NearPass& pass : report.nearPasses)
        warnings.push_back({{"kind", idOf(pass)},
                            {"line", pass.line},
                            {"place_mm", json::array({pass.place.x, pass.place.y, pass.place.z})},
                            {"distance_mm", pass.distance},
                            {"lines", pass.lines}});
    return json{{"passed", report.passed()},
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
                {"rapids", idOf(report.rapids)},
                {"path_modes", modesOf(report.pathModes)},
                {"peak_load", peakOf(report)},
                {"findings", findings},
                {"warnings", warnings}}
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
    for (const json& entry : record.at("findings"))
        report.findings.push_back({findingKindFrom(entry.at("kind")), entry.at("line").get<std::uint32_t>(),
                                   placeFrom(entry.at("place_mm")), entry.at("amount").get<double>()});
    for (const json& entry : record.at("warnings")) report.nearPasses.push_back(nearPassFrom(entry));
    if (record.at("passed").get<bool>() != report.passed()) return std::nullopt;
    return report;
} catch (const json::exception&) {
    return std::nullopt;
}

} // namespace burin
