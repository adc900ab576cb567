// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/fixture_placement.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/fixture_solid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double studClearance = 2.0;   // mm between the stud and the stock
constexpr double barBehindNut = 10.0;   // mm of the bar between washer and step block
constexpr double plateBeyond = 50.0;    // mm of the plate on each side of the stock
constexpr double grippedAtMost = 8.0;   // mm of the stock's height between the jaws of a vise
constexpr double grippedShare = 0.5;    // of the stock's height, at most
constexpr double noseAboveStock = 12.0; // mm: the top of a toe clamp's nose above the stock's bottom
constexpr double firstInset = 10.0;     // mm from the end of the stock
constexpr double onSpot = 1e-3;         // mm around a point on the stock

/// A side of the stock's box.
struct StockSide {
    int axis = 0; ///< 0: X, 1: Y
    bool high = false;
    double inside = 0.0; ///< mm from the point inwards; negative: the point is beyond the side

    double turn() const noexcept { return axis == 0 ? (high ? 0.0 : pi) : (high ? 0.5 * pi : -0.5 * pi); }
    double position(const Box& stock) const noexcept { return high ? stock.high[axis] : stock.low[axis]; }
};

StockSide nearestSide(const Box& stock, const glm::dvec3& point) {
    const std::array sides{StockSide{0, false, point.x - stock.low.x}, StockSide{0, true, stock.high.x - point.x},
                           StockSide{1, false, point.y - stock.low.y}, StockSide{1, true, stock.high.y - point.y}};
    return std::ranges::min(sides, {}, &StockSide::inside);
}

glm::dvec3 onStock(const Box& stock, const glm::dvec3& point) noexcept {
    return {std::clamp(point.x, stock.low.x, stock.high.x), std::clamp(point.y, stock.low.y, stock.high.y), point.z};
}

/// Sets values that follow the stock, unless they were given.
class Follower {
public:
    Follower(FixtureDesign& design, const std::set<std::string>& given) : design_(design), given_(given) {}
    void set(const char* key, double value) const {
        const NumberRange range = rowOf(design_.kind).parameters[*indexOf(design_.kind, key)].range;
        if (!given_.contains(key)) setValue(design_, key, std::clamp(value, range.low, range.high));
    }
    /// The default, or more.
    void setAtLeast(const char* key, double least) const {
        set(key, std::max(rowOf(design_.kind).parameters[*indexOf(design_.kind, key)].standard, least));
    }

private:
    FixtureDesign& design_;
    const std::set<std::string>& given_;
};

/// Closes on the stock between the jaws.
void placeVise(FixtureDesign& design, const Follower& follow, const FixtureSite& site, const glm::dvec3& point) {
    const Box& box = site.stock.box();
    const StockSide side = nearestSide(box, point);
    const glm::dvec3 centre = box.centre(), size = box.size();
    design.turn = side.turn();
    design.place = {centre.x, centre.y, box.low.z};
    follow.set("grip", std::min(grippedAtMost, grippedShare * size.z));
    const auto gripped = site.stock.extentIn(placementOf(design), gripOf(design), 0);
    if (gripped) design.place = placementOf(design).point({0.5 * (gripped->low + gripped->high), 0.0, 0.0});
    follow.set("opening", gripped ? gripped->high - gripped->low : size[side.axis]);
}

void placeStepClamp(FixtureDesign& design, const Follower& follow, const FixtureSite& site, const glm::dvec3& point) {
    const Box& box = site.stock.box();
    const glm::dvec3 pressed = onStock(box, point);
    const StockSide side = nearestSide(box, point);
    design.turn = side.turn();
    design.place = {pressed.x, pressed.y, box.high.z};
    const auto below = site.stock.extentIn(placementOf(design), gripOf(design), 2);
    if (below) design.place.z += below->high;
    // The stud stands beside what the stock has along the bar.
    const double beside = 0.5 * valueOf(design, "stud") + studClearance;
    const auto along =
        site.stock.extentIn(placementOf(design), {{0.0, -beside, site.table - design.place.z}, {0.0, beside, 0.0}}, 0);
    const double toSide = along ? std::max(along->high, 0.0) : std::abs(side.position(box) - pressed[side.axis]);
    follow.set("height", design.place.z - site.table);
    follow.setAtLeast("stud-distance", toSide + 0.5 * valueOf(design, "stud") + studClearance);
    follow.setAtLeast("length", 0.5 * valueOf(design, "contact") + valueOf(design, "stud-distance") +
                                    0.5 * std::max(valueOf(design, "slot"), valueOf(design, "washer")) + barBehindNut +
                                    valueOf(design, "block-length") / blockSteps);
}

void placeToeClamp(FixtureDesign& design, const Follower& follow, const FixtureSite& site, const glm::dvec3& point) {
    const Box& box = site.stock.box();
    const StockSide side = nearestSide(box, point);
    glm::dvec3 pressed = onStock(box, point);
    pressed[side.axis] = side.position(box);
    design.turn = side.turn();
    design.place = {pressed.x, pressed.y, site.table};
    const double lowest = box.low.z - site.table;
    follow.set("grip-height", lowest + std::min(noseAboveStock, box.size().z));
    follow.setAtLeast("height", valueOf(design, "grip-height"));
    const auto before = site.stock.extentIn(placementOf(design), gripOf(design), 0);
    if (before) design.place = placementOf(design).point({before->high, 0.0, 0.0});
}

/// On top of the stock, or on the table beside it.
void placeScrew(FixtureDesign& design, const FixtureSite& site, const glm::dvec3& point) {
    const glm::dvec2 spot(onSpot);
    const auto below = site.stock.extentIn(movedBy({point.x, point.y, 0.0}), {{-spot, 0.0}, {spot, 0.0}}, 2);
    design.turn = 0.0;
    design.place = {point.x, point.y, below ? below->high : site.table};
}

void placeParallels(FixtureDesign& design, const Follower& follow, const FixtureSite& site) {
    const glm::dvec3 centre = site.stock.box().centre(), size = site.stock.box().size();
    const double thickness = valueOf(design, "thickness");
    design.turn = size.x >= size.y ? 0.0 : 0.5 * pi;
    design.place = {centre.x, centre.y, site.stock.box().low.z};
    // Each lies as far inside the stock's side as it is thick, if there is room for both.
    follow.set("distance", std::max(std::min(size.x, size.y) - 3.0 * thickness, thickness + 1.0));
}

void placePlate(FixtureDesign& design, const Follower& follow, const FixtureSite& site) {
    const glm::dvec3 centre = site.stock.box().centre(), size = site.stock.box().size();
    design.turn = 0.0;
    design.place = {centre.x, centre.y, site.table};
    follow.setAtLeast("length", size.x + 2.0 * plateBeyond);
    follow.setAtLeast("width", size.y + 2.0 * plateBeyond);
}

} // namespace

FixtureSite siteOf(const StockSolid& stock, std::span<const Obstacle> fixtures) {
    std::optional<double> plate;
    double lowest = stock.box().low.z;
    for (const Obstacle& fixture : fixtures) {
        if (!fixture.design) continue;
        const FixtureDesign& design = *fixture.design;
        if (design.kind == FixtureKind::plate) plate = design.place.z;
        if (design.kind == FixtureKind::parallels)
            lowest = std::min(lowest, design.place.z - valueOf(design, "height"));
    }
    return {stock, plate.value_or(lowest)};
}

FixtureDesign placedAt(FixtureDesign design, const std::set<std::string>& given, const FixtureSite& site,
                       const glm::dvec3& point) {
    const Follower follow(design, given);
    switch (design.kind) {
    case FixtureKind::vise:
        placeVise(design, follow, site, point);
        break;
    case FixtureKind::stepClamp:
        placeStepClamp(design, follow, site, point);
        break;
    case FixtureKind::toeClamp:
        placeToeClamp(design, follow, site, point);
        break;
    case FixtureKind::hexScrew:
    case FixtureKind::socketScrew:
        placeScrew(design, site, point);
        break;
    case FixtureKind::parallels:
        placeParallels(design, follow, site);
        break;
    case FixtureKind::plate:
        placePlate(design, follow, site);
        break;
    }
    return design;
}

glm::dvec3 firstPoint(FixtureKind kind, const Box& stock) noexcept {
    const glm::dvec3 size = stock.size(), centre = stock.centre();
    if (kind == FixtureKind::vise && size.x >= size.y) return {centre.x, stock.high.y, stock.high.z};
    const double inset = kind == FixtureKind::vise ? 0.0 : std::min(firstInset, 0.25 * size.x);
    return {stock.low.x + inset, centre.y, stock.high.z};
}

Error inStock(const std::string& name, double depth) {
    return {ErrorCode::fixtureInStock, name, formatLimit(depth, 3) + " mm", {}};
}

Result<Obstacle> fixtureOf(const FixtureDesign& design, const StockSolid& stock, const std::string& name,
                           double margin) {
    if (Result<void> usable = checkFixture(design); !usable) return std::move(usable).error();
    if (const double depth = depthIn(design, stock); depth > 0.0) return inStock(name, depth);
    Obstacle fixture;
    fixture.name = name;
    fixture.shape = meshOf(design);
    fixture.margin = margin;
    fixture.design = design;
    return fixture;
}

} // namespace burin
