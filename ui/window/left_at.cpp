// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/left_at.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace burin {

namespace {

constexpr std::array stepIds{"part", "stock", "material", "tool", "allowance", "mill", "path", "program"};

/// The number of that name if it is within the bounds; `otherwise` if not.
double numberIn(const QJsonObject& object, const char* name, double low, double high, double otherwise) {
    const double value = object[QLatin1String(name)].toDouble(otherwise);
    return value >= low && value <= high ? value : otherwise;
}

QJsonObject toObject(const CameraView& view) {
    return {{"focus", QJsonArray{view.focus.x, view.focus.y, view.focus.z}},
            {"azimuth_rad", view.azimuth},
            {"elevation_rad", view.elevation},
            {"distance_mm", view.distance},
            {"parallel", isParallel(view)}};
}

CameraView cameraFrom(const QJsonObject& object) {
    constexpr double farthest = 1e6, quarter = std::numbers::pi / 2.0; // mm, rad
    CameraView view;
    const QJsonArray focus = object[QLatin1String("focus")].toArray();
    for (int axis = 0; axis < 3 && focus.size() == 3; ++axis) {
        const double value = focus[axis].toDouble();
        if (std::abs(value) <= farthest) view.focus[axis] = value;
    }
    view.azimuth = numberIn(object, "azimuth_rad", -1e3, 1e3, view.azimuth);
    view.elevation = numberIn(object, "elevation_rad", -quarter, quarter, view.elevation);
    view.distance = numberIn(object, "distance_mm", 1e-3, farthest, view.distance);
    if (object[QLatin1String("parallel")].toBool()) view.convergence = 0.0;
    return view;
}

MillToolSettings millFrom(const QJsonObject& object) {
    MillToolSettings mill;
    mill.rule = object[QLatin1String("rule")].toString() == QLatin1String("part") ? DepthRule::part : DepthRule::level;
    mill.depthOfCut = numberIn(object, "depth_of_cut_mm", 0.0, 1e3, mill.depthOfCut);
    mill.press = numberIn(object, "press_mm", 0.0, 1e3, mill.press);
    mill.speed = numberIn(object, "speed_mm_per_s", 1e-3, 1e5, mill.speed);
    mill.drag = object[QLatin1String("raster")].toBool() ? DragRule::raster : DragRule::stroke;
    mill.stepOver = numberIn(object, "step_over_mm", 1e-3, 1e3, mill.stepOver);
    return mill;
}

QJsonArray toArray(const PlanRegion& area) {
    QJsonArray rings;
    for (const PlanRing& ring : area.rings) {
        QJsonArray corners;
        for (const glm::dvec2& corner : ring) {
            corners.append(corner.x);
            corners.append(corner.y);
        }
        rings.append(corners);
    }
    return rings;
}

PlanRegion areaFrom(const QJsonArray& rings) {
    PlanRegion area;
    for (const QJsonValue& each : rings) {
        const QJsonArray corners = each.toArray();
        PlanRing ring;
        for (qsizetype i = 0; i + 1 < corners.size(); i += 2)
            ring.emplace_back(std::clamp(corners[i].toDouble(), -farthestInPlan, farthestInPlan),
                              std::clamp(corners[i + 1].toDouble(), -farthestInPlan, farthestInPlan));
        if (ring.size() >= 3) area.rings.push_back(std::move(ring));
    }
    return area;
}

QJsonArray toArray(const std::set<std::size_t>& bodies) {
    QJsonArray numbers;
    for (const std::size_t body : bodies) numbers.append(static_cast<double>(body));
    return numbers;
}

std::set<std::size_t> bodiesFrom(const QJsonArray& numbers) {
    constexpr double most = 1e9;
    std::set<std::size_t> bodies;
    for (const QJsonValue& each : numbers)
        if (const double number = each.toDouble(-1.0); number >= 0.0 && number <= most)
            bodies.insert(static_cast<std::size_t>(number));
    return bodies;
}

} // namespace

std::string toJson(const LeftAt& left) {
    QJsonObject shown;
    for (auto each = left.shown.begin(); each != left.shown.end(); ++each) shown[each.key()] = each.value();
    const QJsonObject mill{{"rule", left.mill.rule == DepthRule::part ? "part" : "level"},
                           {"depth_of_cut_mm", left.mill.depthOfCut},
                           {"press_mm", left.mill.press},
                           {"speed_mm_per_s", left.mill.speed},
                           {"raster", left.mill.drag == DragRule::raster},
                           {"step_over_mm", left.mill.stepOver}};
    const QJsonObject all{{"step", stepIds[static_cast<std::size_t>(left.step)]},
                          {"embedded", left.embedded},
                          {"tool", QString::fromStdString(left.tool)},
                          {"setup", static_cast<double>(left.setup)},
                          {"mill", mill},
                          {"camera", toObject(left.camera)},
                          {"area_mm", toArray(left.area)},
                          {"shown", shown},
                          {"hidden_bodies", toArray(left.hidden)}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::optional<LeftAt> leftAtFromJson(const std::string& text) {
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    if (!all.contains(QLatin1String("camera"))) return {};
    LeftAt left;
    for (std::size_t i = 0; i < stepIds.size(); ++i)
        if (all[QLatin1String("step")].toString() == QLatin1String(stepIds[i])) left.step = static_cast<JobStep>(i);
    // Older projects don't state it: there was a workpiece if the mill step or a later one was shown.
    left.embedded = all[QLatin1String("embedded")].toBool(left.step >= JobStep::mill);
    left.tool = all[QLatin1String("tool")].toString().toStdString();
    left.setup = static_cast<std::int64_t>(numberIn(all, "setup", 1.0, 1e9, 1.0));
    left.mill = millFrom(all[QLatin1String("mill")].toObject());
    left.camera = cameraFrom(all[QLatin1String("camera")].toObject());
    left.area = areaFrom(all[QLatin1String("area_mm")].toArray());
    const QJsonObject shown = all[QLatin1String("shown")].toObject();
    for (auto each = shown.begin(); each != shown.end(); ++each) left.shown[each.key()] = each.value().toBool(true);
    left.hidden = bodiesFrom(all[QLatin1String("hidden_bodies")].toArray());
    return left;
}

} // namespace burin
