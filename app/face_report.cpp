// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/face_report.h"

#include "app/report.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "ui/panels/measure_labels.h"

namespace burin {

using nlohmann::json;

namespace {

/// Right-aligns a number in its column.
std::string inColumn(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string faceLine(const FaceQuality& face) {
    constexpr std::size_t numberWidth = 4, lengthWidth = 6, shareWidth = 5, areaWidth = 10;
    const auto known = [&face](const std::string& text) { return face.samples > 0 ? text : std::string("-"); };
    return worded(BURIN_TEXT("Command", "face %1  gouge %2 mm  left %3 mm  in tolerance %4 %  area %5 mm^2  %6"),
                  {inColumn(std::to_string(face.number), numberWidth),
                   inColumn(known(formatFixed(face.gouge.amount, 3)), lengthWidth),
                   inColumn(known(formatFixed(face.excess.amount, 3)), lengthWidth),
                   inColumn(known(formatFixed(100.0 * face.shares.inTolerance, 1)), shareWidth),
                   inColumn(formatFixed(face.area, 2), areaWidth),
                   kindText(face.kind, face.radius, LengthUnit::millimetre).toStdString()});
}

} // namespace

json jsonOf(const std::vector<FaceQuality>& faces) {
    json list = json::array();
    for (const FaceQuality& face : faces) {
        const auto known = [&face](double value) { return face.samples > 0 ? json(value) : json(); };
        const auto placeOf = [](const WorstPoint& worst) { return worst.amount > 0.0 ? jsonOf(worst.place) : json(); };
        list.push_back({{"face", face.number},
                        {"kind", idOf(face.kind)},
                        {"diameter_mm", face.radius > 0.0 ? json(2.0 * face.radius) : json()},
                        {"area_mm2", face.area},
                        {"samples", face.samples},
                        {"gouge_max_mm", known(face.gouge.amount)},
                        {"gouge_place_mm", placeOf(face.gouge)},
                        {"excess_max_mm", known(face.excess.amount)},
                        {"excess_place_mm", placeOf(face.excess)},
                        {"in_tolerance", known(face.shares.inTolerance)},
                        {"gouge", known(face.shares.gouge)},
                        {"excess", known(face.shares.excess)},
                        {"unreachable", known(face.shares.unreachable)}});
    }
    return list;
}

std::string textOf(const std::vector<FaceQuality>& faces) {
    std::string text;
    for (const FaceQuality& face : faces) text += "\n" + faceLine(face);
    return text;
}

} // namespace burin
