// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/fixture_measures.h"

#include "core/setup/fixture_solid.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

/// Fills in the measures of one design, by key.
class MeasureList {
public:
    explicit MeasureList(const FixtureDesign& of) : of_(of), measures_(of.values.size()) {}

    /// Along X, at a height in the side view.
    void across(const char* key, double from, double z) {
        set(key, FixtureView::side, {from, 0.0, z}, {from + value(key), 0.0, z});
    }
    /// Along Z, in the side view.
    void upright(const char* key, double x, double from) {
        set(key, FixtureView::side, {x, 0.0, from}, {x, 0.0, from + value(key)});
    }
    /// Along X, in the top view.
    void along(const char* key, double from, double y) {
        set(key, FixtureView::top, {from, y, 0.0}, {from + value(key), y, 0.0});
    }
    /// Along Y, in the top view.
    void wide(const char* key, double x, double from) {
        set(key, FixtureView::top, {x, from, 0.0}, {x, from + value(key), 0.0});
    }
    double value(const char* key) const { return valueOf(of_, key); }
    std::vector<FixtureMeasure> take() { return std::move(measures_); }

private:
    void set(const char* key, FixtureView view, const glm::dvec3& from, const glm::dvec3& to) {
        measures_[*indexOf(of_.kind, key)] = {view, from, to};
    }

    const FixtureDesign& of_;
    std::vector<FixtureMeasure> measures_;
};

void measureVise(MeasureList& list) {
    const double half = 0.5 * list.value("opening"), top = list.value("grip"), bed = top - list.value("jaw-height"),
                 outside = half + list.value("jaw-depth"), rear = -outside - list.value("tail"),
                 bottom = bed - list.value("body-height");
    list.across("opening", -half, top);
    list.upright("grip", -half, 0.0);
    list.wide("jaw-width", outside, -0.5 * list.value("jaw-width"));
    list.upright("jaw-height", outside, bed);
    list.across("jaw-depth", half, top);
    list.wide("body-width", rear, -0.5 * list.value("body-width"));
    list.upright("body-height", rear, bottom);
    list.across("tail", rear, bottom);
}

void measureStepClamp(MeasureList& list) {
    const double height = list.value("height"), thickness = list.value("thickness"),
                 nose = -0.5 * list.value("contact"), end = nose + list.value("length"),
                 stud = list.value("stud-distance"), washer = thickness + solidGap,
                 nut = washer + list.value("washer-thickness"), top = nut + list.value("nut-height");
    list.upright("height", nose, -height);
    list.across("length", nose, thickness);
    list.wide("width", nose, -0.5 * list.value("width"));
    list.upright("thickness", end, 0.0);
    list.across("contact", nose, 0.0);
    list.across("stud-distance", 0.0, -0.5 * height);
    list.across("stud", stud - 0.5 * list.value("stud"), -height);
    list.along("slot", stud - 0.5 * list.value("slot"), 0.5 * list.value("slot"));
    list.wide("washer", stud, -0.5 * list.value("washer"));
    list.upright("washer-thickness", stud + 0.5 * list.value("washer"), washer);
    list.along("nut", stud - 0.5 * list.value("nut"), 0.0);
    list.upright("nut-height", stud + list.value("nut") / std::sqrt(3.0), nut);
    list.upright("stud-end", stud, top);
    list.across("block-length", end - list.value("block-length") / blockSteps, -height);
}

void measureToeClamp(MeasureList& list) {
    const double nose = list.value("nose-length"), top = list.value("grip-height"), end = nose + list.value("length");
    list.upright("grip-height", 0.0, 0.0);
    list.upright("nose-thickness", 0.5 * nose, top - list.value("nose-thickness"));
    list.across("nose-length", 0.0, top);
    list.wide("nose-width", 0.0, -0.5 * list.value("nose-width"));
    list.across("length", nose, 0.0);
    list.wide("width", end, -0.5 * list.value("width"));
    list.upright("height", end, 0.0);
}

void measureScrew(MeasureList& list, double headRadius) {
    const double depth = list.value("depth"), washer = list.value("washer-thickness");
    list.across("diameter", -0.5 * list.value("diameter"), -depth);
    list.upright("depth", 0.0, -depth);
    list.along("head", -0.5 * list.value("head"), 0.0);
    list.upright("head-height", headRadius, washer);
    list.across("washer", -0.5 * list.value("washer"), 0.0);
    list.upright("washer-thickness", 0.5 * list.value("washer"), 0.0);
}

void measureParallels(MeasureList& list) {
    const double half = 0.5 * list.value("length"), distance = list.value("distance");
    list.along("length", -half, 0.5 * distance);
    list.wide("thickness", half, 0.5 * (distance - list.value("thickness")));
    list.upright("height", -half, -list.value("height"));
    list.wide("distance", 0.0, -0.5 * distance);
}

void measurePlate(MeasureList& list) {
    const double length = 0.5 * list.value("length"), width = 0.5 * list.value("width");
    list.along("length", -length, -width);
    list.wide("width", length, -width);
    list.upright("thickness", -length, -list.value("thickness"));
}

} // namespace

std::vector<FixtureMeasure> measuresOf(const FixtureDesign& design) {
    MeasureList list(design);
    switch (design.kind) {
    case FixtureKind::vise:
        measureVise(list);
        break;
    case FixtureKind::stepClamp:
        measureStepClamp(list);
        break;
    case FixtureKind::toeClamp:
        measureToeClamp(list);
        break;
    case FixtureKind::hexScrew:
        measureScrew(list, valueOf(design, "head") / std::sqrt(3.0));
        break;
    case FixtureKind::socketScrew:
        measureScrew(list, 0.5 * valueOf(design, "head"));
        break;
    case FixtureKind::parallels:
        measureParallels(list);
        break;
    case FixtureKind::plate:
        measurePlate(list);
        break;
    }
    return list.take();
}

} // namespace burin
