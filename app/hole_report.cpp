// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/hole_report.h"

#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/cad/part_holes.h"

namespace burin {

nlohmann::json jsonOf(const std::vector<UprightHole>& holes) {
    nlohmann::json list = nlohmann::json::array();
    for (const UprightHole& hole : holes)
        list.push_back({{"centre_mm", {hole.centre.x, hole.centre.y}},
                        {"number", list.size() + 1},
                        {"diameter_mm", 2.0 * hole.radius},
                        {"top_mm", hole.top},
                        {"bottom_mm", hole.bottom}});
    return list;
}

namespace {

std::string sizesTextOf(const std::vector<UprightHole>& holes) {
    std::string sizes;
    for (const HoleSize& size : sizesOf(holes))
        sizes +=
            (sizes.empty() ? "" : ", ") + std::to_string(size.count) + " × " + formatFixed(size.diameter, 2) + " mm";
    return sizes;
}

} // namespace

std::string textOf(const std::vector<UprightHole>& holes) {
    const std::string sizes = sizesTextOf(holes);
    return sizes.empty() ? sizes : worded(BURIN_TEXT("Command", "holes    %1"), {sizes});
}

std::string textOfStuds(const std::vector<UprightHole>& studs) {
    const std::string sizes = sizesTextOf(studs);
    return sizes.empty() ? sizes : worded(BURIN_TEXT("Command", "studs    %1"), {sizes});
}

} // namespace burin
