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
                            {"distance_mm", pass.distance}});
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

} // namespace burin
