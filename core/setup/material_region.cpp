// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/material_region.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/setup/formula.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace burin {

namespace {

Error wrong(const MaterialRegion& region, std::string what, std::string allowed) {
    return {ErrorCode::argumentInvalid, region.name.empty() ? "layer" : region.name, std::move(what),
            std::move(allowed)};
}

std::string placeText(const glm::dvec3& place) {
    return "X" + formatShortest(place.x) + " Y" + formatShortest(place.y) + " Z" + formatShortest(place.z);
}

Result<void> checkTable(const MaterialRegion& region, const RegionGrade& grade) {
    if (grade.axis < 0 || grade.axis > 2) return wrong(region, "axis", "x, y or z");
    if (grade.table.size() < 2) return wrong(region, "table", "two lines or more, each a position in mm and a value");
    for (std::size_t i = 0; i < grade.table.size(); ++i) {
        const auto [position, value] = grade.table[i];
        if (!std::isfinite(position) || !std::isfinite(value)) return wrong(region, "table", "finite numbers");
        if (i > 0 && position <= grade.table[i - 1].distance)
            return wrong(region, "table at " + formatShortest(position) + " mm", "positions that rise");
    }
    return {};
}

Result<void> checkGrade(const MaterialRegion& region, const RegionGrade& grade) {
    if (grade.value.empty()) return wrong(region, "value", "the name of one of the material's values");
    if (grade.entries < 1 || grade.entries > maximumGrades)
        return wrong(region, std::to_string(grade.entries) + " bands",
                     "a number from 1 to " + std::to_string(maximumGrades));
    if (grade.formula.empty()) return checkTable(region, grade);
    if (const Result<Formula> formula = Formula::parse(grade.formula); !formula)
        return wrong(region, grade.formula, formula.error().detail);
    return {};
}

Result<void> check(const MaterialRegion& region) {
    if (region.name.empty()) return wrong(region, "name", "a name that is not empty");
    if (region.material.empty()) return wrong(region, "material", "the id of a material");
    if (region.axis < 0 || region.axis > 2) return wrong(region, "axis", "x, y or z");
    if (!(region.from < region.to))
        return wrong(region, formatShortest(region.from) + " to " + formatShortest(region.to) + " mm",
                     "a first plane below the second");
    return region.grade ? checkGrade(region, *region.grade) : Result<void>();
}

/// The range of a formula's values at the corners of the cells of a box, and a point where it is undefined. If the
/// formula is monotonic along each axis within every cell, no value between the corners lies outside this range.
class Range {
public:
    Range(const Formula& formula, const Box& within, double step) : formula_(formula), within_(within), step_(step) {
        for (int axis = 0; axis < 3; ++axis)
            cells_[axis] = std::max(1, static_cast<int>(std::ceil(within.size()[axis] / step - 1e-6)));
    }

    void measure() {
        parallelIntervals(0, cells_.z + 1, 1, [&](int from, int to) {
            for (int layer = from; layer < to; ++layer) add(layerOf(layer));
        });
    }
    double low() const noexcept { return all_.low; }
    double high() const noexcept { return all_.high; }
    const std::optional<glm::dvec3>& undefined() const noexcept { return all_.undefined; }

private:
    struct Found {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
        std::optional<glm::dvec3> undefined;
    };
    Found layerOf(int layer) const {
        Found found;
        for (int row = 0; row <= cells_.y; ++row)
            for (int column = 0; column <= cells_.x; ++column) {
                // Rounded to the micrometre: a formula usually divides by zero at a round coordinate, and a box seldom
                // starts at one.
                const glm::dvec3 place =
                    glm::round(1e3 * glm::min(within_.low + step_ * glm::dvec3(column, row, layer), within_.high)) /
                    1e3;
                const double value = formula_.at(place);
                if (!std::isfinite(value)) {
                    if (!found.undefined) found.undefined = place;
                    continue;
                }
                found.low = std::min(found.low, value);
                found.high = std::max(found.high, value);
            }
        return found;
    }
    void add(const Found& found) {
        const std::scoped_lock lock(mutex_);
        all_.low = std::min(all_.low, found.low);
        all_.high = std::max(all_.high, found.high);
        // The lowest point, so that the result does not depend on how the work was divided among the threads.
        if (found.undefined && (!all_.undefined || found.undefined->z < all_.undefined->z))
            all_.undefined = found.undefined;
    }

    const Formula& formula_;
    Box within_;
    double step_;
    glm::ivec3 cells_{1};
    std::mutex mutex_;
    Found all_;
};

/// Returns the part of a box that a region can fill.
Box clipped(const MaterialRegion& region, Box box) {
    box.low[region.axis] = std::max(box.low[region.axis], region.from);
    box.high[region.axis] = std::min(box.high[region.axis], region.to);
    return box;
}

/// Checks the range of a value. The cutting force, the feed and the weight depend on some values, which have to be
/// above 0.
Result<void> checkRange(const MaterialRegion& region, double low, double high) {
    const std::string& name = region.grade->value;
    const bool positive = name == specificCuttingEnergy || name == density || name == kienzleForce ||
                          name == surfaceSpeed || name == chipLoadPerDiameter;
    if (positive && !(low > 0.0))
        return wrong(region, formatShortest(low), "a formula or table whose values are above 0 all over the layer");
    if (!(low < high))
        return wrong(region, formatShortest(low), "values that differ; for one value no grading is needed");
    return {};
}

} // namespace

bool operator==(const RegionGrade& one, const RegionGrade& other) {
    return one.value == other.value && one.formula == other.formula && one.axis == other.axis &&
           one.entries == other.entries &&
           std::ranges::equal(one.table, other.table, [](const Grading::Control& a, const Grading::Control& b) {
               return a.distance == b.distance && a.value == b.value;
           });
}

Result<void> checkRegions(const std::vector<MaterialRegion>& regions) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (Result<void> sound = check(regions[i]); !sound) return sound;
        for (std::size_t earlier = 0; earlier < i; ++earlier)
            if (regions[earlier].name == regions[i].name)
                return wrong(regions[i], "name", "a name that no other layer has");
    }
    return {};
}

Result<Grading> gradingOf(const MaterialRegion& region, const Box& within, double step) {
    const RegionGrade& grade = *region.grade;
    if (Result<void> sound = check(region); !sound) return std::move(sound).error();
    if (grade.formula.empty()) {
        glm::dvec3 direction(0.0);
        direction[grade.axis] = 1.0;
        Result<Grading> grading = Grading::fromPlane(glm::dvec3(0.0), direction, grade.table);
        const auto [low, high] = std::ranges::minmax(grade.table, {}, &Grading::Control::value);
        if (Result<void> sound = checkRange(region, low.value, high.value); !sound) return std::move(sound).error();
        return grading;
    }
    const Result<Formula> formula = Formula::parse(grade.formula);
    if (!formula) return formula.error();
    const Box place = clipped(region, within);
    if (place.empty()) return wrong(region, "place", "planes between which there is stock");
    Range range(*formula, place, step);
    range.measure();
    if (range.undefined())
        return wrong(region, grade.formula,
                     "a formula that has a finite value everywhere; at " + placeText(*range.undefined()) +
                         " mm it has none");
    if (Result<void> sound = checkRange(region, range.low(), range.high()); !sound) return std::move(sound).error();
    return Grading::of([formula = *formula](const glm::dvec3& at) { return formula.at(at); }, range.low(),
                       range.high());
}

} // namespace burin
