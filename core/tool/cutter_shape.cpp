// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/cutter_shape.h"

#include "core/base/units.h"
#include "core/tool/flute_form.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double degree = pi / 180.0;
constexpr double usualTaper = 5.0 * degree, usualChamfer = 45.0 * degree, usualPoint = 59.0 * degree;
constexpr double usualCorner = 0.25; // share of the radius

bool isCone(CutterType type) noexcept {
    return type == CutterType::taper || type == CutterType::taperBall || type == CutterType::drill ||
           type == CutterType::chamfer;
}

double usualAngle(CutterType type) noexcept {
    if (type == CutterType::drill) return usualPoint;
    return type == CutterType::chamfer ? usualChamfer : usualTaper;
}

double fittedCorner(const Cutter& cutter) noexcept {
    const bool fits = cutter.cornerRadius > 0.0 && cutter.cornerRadius < cutter.radius();
    switch (cutter.type) {
    case CutterType::ball:
    case CutterType::lollipop:
        return cutter.radius();
    case CutterType::bullNose:
    case CutterType::taperBall:
        return fits ? cutter.cornerRadius : usualCorner * cutter.radius();
    case CutterType::taper:
        return fits ? cutter.cornerRadius : 0.0;
    case CutterType::flat:
    case CutterType::drill:
    case CutterType::chamfer:
    case CutterType::profile:
        break;
    }
    return 0.0;
}

/// Removes a rounding that does not fit on the tip; extends the flutes to where the cone is as wide as the cutter.
void fitCone(Cutter& cutter) {
    if (cutter.tipDiameter >= cutter.diameter) cutter.tipDiameter = 0.0;
    TaperForm form = taperForm(cutter);
    if (cutter.type == CutterType::taper && (form.ringRadius < 0.0 || form.arcEndRadius > cutter.radius())) {
        cutter.cornerRadius = 0.0;
        form = taperForm(cutter);
    }
    cutter.fluteLength = std::max(cutter.fluteLength, form.coneEnd);
}

} // namespace

bool isFree(CutterType type, CutterValue value) noexcept {
    switch (value) {
    case CutterValue::diameter:
    case CutterValue::fluteLength:
        return type != CutterType::profile;
    case CutterValue::cornerRadius:
        return type == CutterType::bullNose || type == CutterType::taper || type == CutterType::taperBall;
    case CutterValue::tipDiameter:
        return type == CutterType::taper || type == CutterType::chamfer;
    case CutterValue::taperAngle:
        return isCone(type);
    }
    return false;
}

Cutter fitted(Cutter cutter) {
    if (cutter.type != CutterType::profile) {
        cutter.profile.clear();
        cutter.solid = nullptr;
    }
    cutter.cornerRadius = fittedCorner(cutter);
    if (!isFree(cutter.type, CutterValue::tipDiameter)) cutter.tipDiameter = 0.0;
    const bool angleFits = cutter.taperAngle > 0.0 && cutter.taperAngle <= 89.0 * degree;
    if (!isCone(cutter.type))
        cutter.taperAngle = 0.0;
    else if (!angleFits)
        cutter.taperAngle = usualAngle(cutter.type);
    if (cutter.type == CutterType::lollipop) {
        constexpr double usualEnd = 0.9; // share of the diameter
        if (cutter.fluteLength <= cutter.radius() || cutter.fluteLength >= cutter.diameter)
            cutter.fluteLength = usualEnd * cutter.diameter;
    } else if (cutter.type != CutterType::profile) {
        cutter.fluteLength = std::max(cutter.fluteLength, cutter.cornerRadius);
    }
    if (isCone(cutter.type)) fitCone(cutter);
    cutter.stickOut = std::max(cutter.stickOut, cutter.fluteLength);
    return cutter;
}

} // namespace burin
