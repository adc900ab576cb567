// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/flute_form.h"

#include "core/base/numbers.h"
#include "core/base/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace burin {

namespace {

constexpr double slack = 1e-6; // mm, between values that a file states twice

Error invalid(std::string key, double value, std::string allowed) {
    return {ErrorCode::argumentInvalid, std::move(key), formatShortest(value), std::move(allowed)};
}

bool tapers(CutterType type) noexcept {
    return type == CutterType::taper || type == CutterType::taperBall || type == CutterType::drill ||
           type == CutterType::chamfer;
}

bool hasFlatTip(CutterType type) noexcept {
    return type == CutterType::taper || type == CutterType::chamfer;
}

/// Checks that values which the type does not use are 0; others are probably an author's mistake.
Result<void> validateUnused(const Cutter& cutter) {
    if (!hasFlatTip(cutter.type) && cutter.tipDiameter != 0.0)
        return invalid("cutter.tip_diameter_mm", cutter.tipDiameter, "left out: this type has none");
    if (!tapers(cutter.type) && cutter.taperAngle != 0.0)
        return invalid("cutter.taper_angle_deg", cutter.taperAngle * 180.0 / pi, "left out: this type has none");
    if (cutter.type != CutterType::profile && !cutter.profile.empty())
        return invalid("cutter.profile", static_cast<double>(cutter.profile.size()), "left out: this type has none");
    return {};
}

Result<void> validateCorner(const Cutter& cutter) {
    const double corner = cutter.cornerRadius;
    const auto wrong = [&](const char* allowed) { return invalid("cutter.corner_radius_mm", corner, allowed); };
    if (!(corner >= 0.0)) return wrong("at least 0");
    switch (cutter.type) {
    case CutterType::ball:
    case CutterType::lollipop:
        if (corner != cutter.radius()) return wrong("half the diameter for a ball end or lollipop");
        break;
    case CutterType::bullNose:
        if (!(corner > 0.0 && corner < cutter.radius())) return wrong("above 0 and below half the diameter");
        break;
    case CutterType::taperBall:
        if (!(corner > 0.0 && corner < cutter.radius())) return wrong("above 0 and below half the diameter");
        break;
    case CutterType::taper:
        break;
    case CutterType::flat:
    case CutterType::drill:
    case CutterType::chamfer:
    case CutterType::profile:
        if (corner != 0.0) return wrong("0 for a sharp end");
        break;
    }
    return {};
}

Result<void> validateTaper(const Cutter& cutter) {
    const double degrees = cutter.taperAngle * 180.0 / pi;
    if (!(cutter.taperAngle > 0.0 && degrees <= 89.0))
        return invalid("cutter.taper_angle_deg", degrees, "above 0, at most 89");
    if (!(cutter.tipDiameter >= 0.0 && cutter.tipDiameter < cutter.diameter))
        return invalid("cutter.tip_diameter_mm", cutter.tipDiameter, "at least 0 and below the diameter");
    const TaperForm form = taperForm(cutter);
    if (form.ringRadius < 0.0)
        return invalid("cutter.corner_radius_mm", cutter.cornerRadius, "small enough to round the edge of the tip");
    if (form.arcEndRadius > cutter.radius())
        return invalid("cutter.corner_radius_mm", cutter.cornerRadius, "small enough to leave a cone");
    if (form.coneEnd > cutter.fluteLength + slack)
        return invalid("cutter.diameter_mm", cutter.diameter,
                       "at most what the cone reaches at the end of the flutes (" +
                           formatShortest(cutter.diameter -
                                          2.0 * std::tan(cutter.taperAngle) * (form.coneEnd - cutter.fluteLength)) +
                           ")");
    return {};
}

Result<void> validateLollipop(const Cutter& cutter) {
    if (cutter.fluteLength > cutter.radius() && cutter.fluteLength < cutter.diameter) return {};
    return invalid("cutter.flute_length_mm", cutter.fluteLength,
                   "above half the diameter and below the diameter: where the ball ends and the shank begins");
}

Result<void> validateArc(const ProfileElement& arc, const glm::dvec2& from, const std::string& key) {
    const glm::dvec2 to(arc.radius, arc.height);
    if (!(arc.arcRadius > 0.0) || 2.0 * arc.arcRadius < glm::length(to - from) - slack)
        return invalid(key + ".arc_radius_mm", arc.arcRadius, "at least half the distance of the arc's ends");
    const glm::dvec2 centre = arcCentre(arc, from);
    const double side = arc.hollow ? -1.0 : 1.0;
    const bool rises = side * (from.x - centre.x) >= -slack && side * (to.x - centre.x) >= -slack;
    const bool clear = !arc.hollow || centre.y <= from.y || centre.y >= to.y || centre.x > arc.arcRadius;
    if (rises && clear) return {};
    return invalid(key + ".arc_radius_mm", arc.arcRadius,
                   "an arc that rises all the way from its beginning to its end and stays off the axis");
}

Result<void> validateProfile(const Cutter& cutter) {
    if (cutter.profile.empty()) return invalid("cutter.profile", 0.0, "at least one line or arc");
    glm::dvec2 from(0.0);
    double widest = 0.0;
    for (std::size_t i = 0; i < cutter.profile.size(); ++i) {
        const ProfileElement& element = cutter.profile[i];
        const std::string key = "cutter.profile[" + std::to_string(i) + "]";
        const glm::dvec2 to(element.radius, element.height);
        if (!(element.radius >= 0.0) || !std::isfinite(element.radius))
            return invalid(key + ".radius_mm", element.radius, "at least 0");
        if (!(element.height >= from.y) || !std::isfinite(element.height))
            return invalid(
                key + ".height_mm", element.height,
                "at least the height at which the element begins: profiles never fall, so a cupped tip can't be drawn");
        if (to == from)
            return invalid(key + ".radius_mm", element.radius, "a point other than the element's beginning");
        if (element.arcRadius != 0.0)
            if (Result<void> arc = validateArc(element, from, key); !arc) return arc;
        from = to;
    }
    for (const RevolvedPiece& piece : flutePieces(cutter)) widest = std::max(widest, piece.widestRadius());
    if (std::abs(from.y - cutter.fluteLength) > slack)
        return invalid("cutter.flute_length_mm", cutter.fluteLength, "the height at which the profile ends");
    if (std::abs(2.0 * widest - cutter.diameter) > slack)
        return invalid("cutter.diameter_mm", cutter.diameter, "twice the profile's largest radius");
    return {};
}

void addTaper(const Cutter& cutter, std::vector<RevolvedPiece>& pieces) {
    const TaperForm form = taperForm(cutter);
    if (form.arcEnd > 0.0)
        pieces.push_back(bulgingPiece(0.0, form.arcEnd, form.ringRadius, cutter.cornerRadius, cutter.cornerRadius));
    // A cone that just reaches the end of the flutes may miss it because of rounding: it is treated as reaching it.
    const bool hasCylinder = form.coneEnd < cutter.fluteLength - slack;
    const double end = hasCylinder ? form.coneEnd : cutter.fluteLength;
    if (form.arcEnd < end) pieces.push_back({form.arcEnd, end, form.arcEndRadius, cutter.radius(), 0.0});
    if (hasCylinder) pieces.push_back({form.coneEnd, cutter.fluteLength, cutter.radius(), cutter.radius(), 0.0});
}

void addHollowArc(const ProfileElement& arc, const glm::dvec2& from, std::vector<RevolvedPiece>& pieces) {
    const glm::dvec2 centre = arcCentre(arc, from);
    const double first = std::asin(std::clamp((from.y - centre.y) / arc.arcRadius, -1.0, 1.0));
    const double last = std::asin(std::clamp((arc.height - centre.y) / arc.arcRadius, -1.0, 1.0));
    // A chord over the angle a deviates from its arc by radius (1 - cos(a / 2)).
    const double widest = 2.0 * std::acos(std::max(1.0 - profileChord / arc.arcRadius, 0.0));
    const int steps = std::max(1, static_cast<int>(std::ceil((last - first) / widest)));
    glm::dvec2 low = from;
    for (int i = 1; i <= steps; ++i) {
        const double angle = first + (last - first) * i / steps;
        const glm::dvec2 on = centre + arc.arcRadius * glm::dvec2(-std::cos(angle), std::sin(angle));
        const glm::dvec2 high = i == steps ? glm::dvec2(arc.radius, arc.height) : on;
        if (high.y > low.y) pieces.push_back({low.y, high.y, low.x, high.x, 0.0});
        low = high;
    }
}

void addProfile(const Cutter& cutter, std::vector<RevolvedPiece>& pieces) {
    glm::dvec2 from(0.0);
    for (const ProfileElement& element : cutter.profile) {
        const glm::dvec2 to(element.radius, element.height);
        if (element.arcRadius > 0.0 && element.hollow) {
            addHollowArc(element, from, pieces);
        } else if (element.arcRadius > 0.0) {
            const glm::dvec2 centre = arcCentre(element, from);
            pieces.push_back({from.y, to.y, from.x, to.x, 0.0, element.arcRadius, centre.x, centre.y});
        } else if (to.y > from.y + slack) { // otherwise a shoulder: the next element begins wider
            pieces.push_back({from.y, to.y, from.x, to.x, 0.0});
        }
        from = to;
    }
}

} // namespace

glm::dvec2 arcCentre(const ProfileElement& arc, const glm::dvec2& from) noexcept {
    const glm::dvec2 to(arc.radius, arc.height), chord = to - from;
    const double length = glm::length(chord), half = 0.5 * length;
    const glm::dvec2 outward = glm::dvec2(chord.y, -chord.x) / length;
    const double away = std::sqrt(std::max((arc.arcRadius - half) * (arc.arcRadius + half), 0.0));
    glm::dvec2 centre = 0.5 * (from + to) + (arc.hollow ? away : -away) * outward;
    // A centre that should lie on the axis makes a sphere, which has closed forms.
    if (std::abs(centre.x) < 1e-9 * arc.arcRadius) centre.x = 0.0;
    return centre;
}

TaperForm taperForm(const Cutter& cutter) noexcept {
    const double corner = cutter.cornerRadius, sine = std::sin(cutter.taperAngle), cosine = std::cos(cutter.taperAngle);
    TaperForm form;
    // The rounding is tangent to the plane of the tip and to the cone.
    if (cutter.type != CutterType::taperBall)
        form.ringRadius = 0.5 * cutter.tipDiameter - corner * (1.0 - sine) / cosine;
    form.arcEnd = corner * (1.0 - sine);
    form.arcEndRadius = form.ringRadius + corner * cosine;
    form.coneEnd = form.arcEnd + (cutter.radius() - form.arcEndRadius) * cosine / sine;
    return form;
}

Result<void> validateFlutes(const Cutter& cutter) {
    if (Result<void> unused = validateUnused(cutter); !unused) return unused;
    if (Result<void> corner = validateCorner(cutter); !corner) return corner;
    if (tapers(cutter.type)) return validateTaper(cutter);
    if (cutter.type == CutterType::lollipop) return validateLollipop(cutter);
    if (cutter.type == CutterType::profile) return validateProfile(cutter);
    return {};
}

std::vector<RevolvedPiece> flutePieces(const Cutter& cutter) {
    std::vector<RevolvedPiece> pieces;
    if (tapers(cutter.type)) {
        addTaper(cutter, pieces);
    } else if (cutter.type == CutterType::profile) {
        addProfile(cutter, pieces);
    } else if (cutter.type == CutterType::lollipop) {
        pieces.push_back(bulgingPiece(0.0, cutter.fluteLength, 0.0, cutter.radius(), cutter.radius()));
    } else {
        pieces.push_back({0.0, cutter.fluteLength, cutter.radius(), cutter.radius(), cutter.cornerRadius});
    }
    return pieces;
}

RevolvedPiece flutes(const Cutter& cutter) {
    const std::vector<RevolvedPiece> pieces = flutePieces(cutter);
    assert(pieces.size() == 1);
    return pieces.front();
}

} // namespace burin
