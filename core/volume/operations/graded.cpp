// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/graded.h"

#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace burin {

namespace {

std::string gradeOf(int band, int entries, const char* separator) {
    return std::to_string(band + 1) + separator + std::to_string(entries);
}

/// Lower grades darker, higher ones lighter.
std::array<std::uint8_t, 3> shaded(std::array<std::uint8_t, 3> colour, int band, int entries) {
    const double share = 0.7 + 0.5 * (band + 0.5) / entries;
    for (std::uint8_t& channel : colour)
        channel = static_cast<std::uint8_t>(std::min(255.0, std::round(channel * share)));
    return colour;
}

/// Finds the bands along a scanline. The line is cut into intervals on which the grading is monotonic; in each, the
/// borders are found by bisection. The compared value is not the band itself, which may recur, but the cell between two
/// of the distances at which the band changes.
class BandFinder {
public:
    BandFinder(const GradedMaterial& material, const Grid& grid) : material_(material), grid_(grid) {
        const std::vector<Grading::Control>& controls = material.grading.controls();
        for (std::size_t i = 1; i < controls.size(); ++i) findChanges(controls[i - 1], controls[i]);
        for (std::size_t cell = 0; cell <= changes_.size() && !controls.empty(); ++cell)
            bandOfCell_.push_back(bandBetween(cell));
    }

    /// Calls visit(end, band) for the intervals that make up `from` … `to`.
    template <class Visit>
    void split(LineIndex line, RunPosition from, RunPosition to, Visit visit) const {
        const glm::dvec2 across = grid_.lineCentre(line);
        glm::dvec3 place(0.0);
        place[grid_.axisOfU()] = across.x;
        place[grid_.axisOfV()] = across.y;
        const auto cellOf = [&](RunPosition unit) {
            place[grid_.axisOfRuns()] = 0.5 * (grid_.toMillimetres(unit) + grid_.toMillimetres(unit + 1));
            return cellAt(place);
        };
        RunPosition present = from;
        int cell = cellOf(present);
        while (present + 1 < to) {
            const RunPosition last = intervalEnd(place, present, to - 1);
            for (const int lastCell = cellOf(last); cell != lastCell;) {
                RunPosition same = present, other = last;
                while (other - same > 1) {
                    const RunPosition middle = same + (other - same) / 2;
                    (cellOf(middle) == cell ? same : other) = middle;
                }
                visit(other, bandOf(cell));
                present = other;
                cell = cellOf(other);
            }
            present = last;
        }
        visit(to, bandOf(cell));
    }

private:
    void findChanges(const Grading::Control& before, const Grading::Control& behind) {
        const double low = std::min(before.value, behind.value), high = std::max(before.value, behind.value);
        std::vector<double> places;
        for (int border = 1; border < material_.entries; ++border) {
            const double value = material_.grading.low() + border * material_.bandHeight();
            if (value <= low || value >= high) continue;
            places.push_back(before.distance + (value - before.value) / (behind.value - before.value) *
                                                   (behind.distance - before.distance));
        }
        // A control that lies on a border may also be a point where the band changes.
        places.push_back(behind.distance);
        std::ranges::sort(places);
        changes_.insert(changes_.end(), places.begin(), places.end());
    }
    int bandBetween(std::size_t cell) const {
        const std::vector<Grading::Control>& controls = material_.grading.controls();
        if (cell == changes_.size()) return material_.bandOf(controls.back().value);
        const double end = changes_[cell], begin = cell == 0 ? controls.front().distance : changes_[cell - 1];
        const double middle = 0.5 * (begin + end);
        const auto behind = std::ranges::upper_bound(controls, middle, {}, &Grading::Control::distance);
        if (behind == controls.end() || behind == controls.begin()) return material_.bandOf(controls.front().value);
        const Grading::Control& before = *std::prev(behind);
        return material_.bandOf(before.value + (middle - before.distance) / (behind->distance - before.distance) *
                                                   (behind->value - before.value));
    }
    int cellAt(const glm::dvec3& place) const {
        const std::optional<double> distance = material_.grading.distance(place);
        if (!distance) return material_.bandOf(material_.grading.value(place));
        return static_cast<int>(std::ranges::upper_bound(changes_, *distance) - changes_.begin());
    }
    int bandOf(int cell) const { return bandOfCell_.empty() ? cell : bandOfCell_[static_cast<std::size_t>(cell)]; }

    /// The last unit, at most `limit`, up to which the grading is monotonic.
    RunPosition intervalEnd(const glm::dvec3& place, RunPosition from, RunPosition limit) const {
        if (material_.grading.controls().empty()) return std::min(limit, from + unitsPerVoxel);
        const std::optional<double> turn = material_.grading.nearest(place, grid_.axisOfRuns());
        if (!turn) return limit;
        const double unit = std::floor((*turn - grid_.toMillimetres(0)) / grid_.edge() * unitsPerVoxel);
        return unit > from && unit < limit ? static_cast<RunPosition>(unit) : limit;
    }

    const GradedMaterial& material_;
    const Grid& grid_;
    std::vector<double> changes_; ///< distances, mm, rising
    std::vector<int> bandOfCell_; ///< cell i lies before change i; the last cell is behind all changes
};

/// Rewrites rows of bricks that contain the base material.
class RowGrader {
public:
    RowGrader(const RunVolume& volume, const GradedMaterial& material)
        : volume_(volume), material_(material), bands_(material, volume.grid()) {}

    void run(std::int32_t row, BrickSink& sink) const {
        const Grid& grid = volume_.grid();
        BrickLines lines(grid.lineEnd());
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            bool found = false;
            eachLine(low, [&](LineIndex line) { found = found || holdsBase(line); });
            if (!found) continue;
            lines.clear();
            eachLine(low, [&](LineIndex line) {
                if (grid.contains(line)) write(line, lines);
                lines.endLine();
            });
            sink.put(low, lines);
        }
    }

private:
    template <class Visit>
    static void eachLine(LineIndex low, Visit visit) {
        for (std::int32_t v = low.v; v < low.v + brickSide; ++v)
            for (std::int32_t u = low.u; u < low.u + brickSide; ++u) visit(LineIndex{u, v});
    }
    bool holdsBase(LineIndex line) const {
        return volume_.grid().contains(line) && std::ranges::any_of(volume_.line(line), [&](Segment segment) {
                   return segment.property() == material_.base;
               });
    }
    void write(LineIndex line, BrickLines& lines) const {
        RunPosition start = 0;
        for (const Segment segment : volume_.line(line)) {
            if (segment.property() == material_.base)
                bands_.split(line, start, segment.end(), [&](RunPosition end, int band) {
                    lines.append(end, static_cast<PropertyIndex>(material_.first + band));
                });
            else
                lines.append(segment.end(), segment.property());
            start = segment.end();
        }
    }

    const RunVolume& volume_;
    const GradedMaterial& material_;
    BandFinder bands_;
};

} // namespace

int GradedMaterial::bandOf(double value) const noexcept {
    const double share = (value - grading.low()) / (grading.high() - grading.low());
    return std::clamp(static_cast<int>(std::floor(share * entries)), 0, entries - 1);
}

Result<GradedMaterial> addGrades(PropertyList& list, PropertyIndex base, const std::string& valueName, Grading grading,
                                 int entries) {
    if (base == airProperty || base >= list.size())
        return Error{ErrorCode::argumentInvalid, "property", std::to_string(base), "a material of the list"};
    if (entries < 1) return Error{ErrorCode::argumentInvalid, "entries", std::to_string(entries), "one at least"};
    const Property material = list[base];
    const auto graded = material.values.find(valueName);
    if (graded == material.values.end())
        return Error{ErrorCode::argumentInvalid, "value", valueName, "a value of the material"};
    GradedMaterial result{base, static_cast<PropertyIndex>(list.size()), entries, std::move(grading)};
    for (int band = 0; band < entries; ++band) {
        Property grade = material;
        grade.id = material.id + "-graded-" + gradeOf(band, entries, "-of-");
        grade.name = material.name + " (graded " + gradeOf(band, entries, "/") + ")";
        grade.base = material.id;
        grade.colour = shaded(material.colour, band, entries);
        grade.values[valueName].value = result.valueOf(band);
        if (Result<PropertyIndex> added = list.add(std::move(grade)); !added) return added.error();
    }
    return result;
}

Result<void> gradeRuns(RunVolume& volume, const GradedMaterial& material) {
    const PropertyList& list = volume.properties();
    for (int band = 0; band < material.entries; ++band) {
        const int entry = material.first + band;
        if (entry >= list.size() || list.baseOf(static_cast<PropertyIndex>(entry)) != material.base ||
            entry == material.base)
            return Error{ErrorCode::argumentInvalid, "property", std::to_string(entry), "a grade of the material"};
    }
    try {
        const RowGrader grader(volume, material);
        if (volume.rewriteBricks([&](std::int32_t row, BrickSink& sink) { grader.run(row, sink); })) return {};
        return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "volume", {}, {}};
    }
}

} // namespace burin
