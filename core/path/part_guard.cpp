// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/part_guard.h"

#include <algorithm>
#include <cmath>

namespace burin {

PartGuard::PartGuard(const MeshDistance& part, const Tool& tool)
    : part_(&part), pieces_(burin::pieces(tool.cutter)), top_(part.bounds().high.z) {}

Result<PartGuard> PartGuard::of(const PathContext& context) {
    if (context.part == nullptr)
        return Error{ErrorCode::argumentInvalid, "part", "", "this edit needs the part's mesh"};
    return PartGuard(*context.part, context.tool);
}

ToolClearance PartGuard::clearance(const glm::dvec3& tip, double within) const {
    return part_->clearance(pieces_, ToolPose{tip, {0.0, 0.0, 1.0}}, within);
}

std::optional<PartGuard::Dip> PartGuard::deepestDip(const glm::dvec3& from, const glm::dvec3& to, double required,
                                                    double sampling) const {
    return scan(from, to, required, sampling, false);
}

std::optional<PartGuard::Dip> PartGuard::scan(const glm::dvec3& from, const glm::dvec3& to, double required,
                                              double sampling, bool firstIsEnough) const {
    const double length = glm::distance(from, to);
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length / sampling)));
    const double step = length / static_cast<double>(steps);
    std::optional<Dip> dip;
    for (std::size_t i = 0; i <= steps;) {
        const double part = static_cast<double>(i) / static_cast<double>(steps);
        const double left = length - part * length;
        const double clearance = this->clearance(from + part * (to - from), required + left + step).clearance;
        if (clearance < required) {
            if (!dip || clearance < dip->clearance) dip = Dip{part, clearance};
            if (firstIsEnough) return dip;
        }
        const double spare = clearance - required;
        if (spare >= left && spare > 0.0) break;
        i += spare > step && step > 0.0 ? static_cast<std::size_t>(spare / step) : 1;
    }
    return dip;
}

} // namespace burin
