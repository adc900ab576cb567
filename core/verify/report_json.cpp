// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/report_json.h"

#include <nlohmann/json.hpp>

namespace burin {

using nlohmann::json;

std::string toJson(const VerifyReport& report) {
    json findings = json::array();
    for (const Finding& finding : report.findings)
        findings.push_back({{"kind", idOf(finding.kind)},
                            {"line", finding.line},
                            {"place_mm", json::array({finding.place.x, finding.place.y, finding.place.z})},
                            {"amount", finding.amount}});
    return json{{"passed", report.passed()},
                {"gouge_max_mm", report.gougeMax},
                {"gouge_max_mesh_mm", report.gougeMaxMesh},
                {"excess_max_mm", report.excessMax},
                {"excess_mean_mm", report.excessMean},
                {"reachable_share", report.reachableShare},
                {"removed_mm3", report.removed},
                {"on_part_share", report.onPartShare},
                {"on_part_samples", report.onPartSamples},
                {"samples_checked", report.samples},
                {"samples_exact", report.exactSamples},
                {"machining_s", report.machiningSeconds},
                {"findings", findings}}
        .dump();
}

} // namespace burin
