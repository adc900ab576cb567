// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/inserted_points.h"

namespace burin {

std::vector<InsertedPoint> insertedPoints(const EvaluatedPath& path, const std::vector<Edit>& edits) {
    std::vector<InsertedPoint> points;
    auto report = path.reports.begin();
    for (std::size_t i = 0; i < edits.size() && report != path.reports.end(); ++i) {
        if (!edits[i].enabled) continue;
        for (const glm::dvec3& place : report->inserted) points.push_back({place, i});
        ++report;
    }
    return points;
}

} // namespace burin
