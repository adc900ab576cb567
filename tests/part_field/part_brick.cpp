// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/part_brick.h"

#include "core/field/cube.h"
#include "core/geometry/four_floats.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace burin {

namespace {

// All in voxels; README.md describes their effect.
constexpr float mostBend = 0.06F;       // of a line that is interpolated
constexpr float mostMiddleBend = 0.16F; // of a line whose brick was sampled at its centre, too
constexpr float mostResidual = 0.04F;   // of the slopes at its ends
constexpr float mostMiddleResidual = 0.08F;
constexpr float mostMiddleError = 0.01F; // difference from the expected value there
constexpr float mostMiddleTurn = 0.03F;  // difference of its gradient
constexpr float mostSpread = 0.02F;      // between the lines through a sample
constexpr float mostStep = 0.02F;        // difference between a value predicted by slopes and the next sample, one of
                                         // the two sampled from the mesh
constexpr float mostCellError = 0.05F;   // of a trilinear cell; worse ones are exact
constexpr float mostImbalance = 0.08F;   // between the bends at the ends of an edge, in a smooth cell
constexpr float narrowQuantum = 0.008F;  // coarsest unit of residuals of 8 bits
constexpr float estimate = 0.005F;       // error of a sample that was not taken from the mesh, at least
constexpr float rounding = 1e-5F;        // of single precision

/// The greatest chord error along one axis of a whole brick, or an upper bound of it: for four edges at a time.
class ChordErrors {
public:
    void meet(const float* value, const float* slope, std::size_t step) noexcept {
        const FourFloats rise = fourAt(value + step) - fourAt(value);
        const FourFloats low = rise - fourAt(slope), high = fourAt(slope + step) - rise;
        const FourFloats quarter = 0.25F * absolute(low + high);
        const FourFloats half = 0.5F * greater(absolute(low), absolute(high));
        const FourFloats imbalance = absolute(low - high);
        imbalance_ = greater(imbalance_, imbalance);
        worst_ = greater(worst_, (low * high > 0.0F ? quarter : half) + 0.25F * imbalance);
    }
    float worst() const noexcept { return greatest(worst_); }
    float imbalance() const noexcept { return greatest(imbalance_); }

private:
    FourFloats worst_{}, imbalance_{};
};

/// Runs of edges along an axis: begin, length, and the offset from one run to the next.
ChordErrors chordErrors(const SampleGrid& grid, std::size_t axis) noexcept {
    constexpr std::array<std::size_t, 3> step{1, 9, 81}, length{8, 72, 648}, next{9, 81, 729};
    ChordErrors errors;
    for (std::size_t run = 0; run < CellGrid::samples; run += next[axis])
        for (std::size_t i = 0; i < length[axis]; i += 4)
            errors.meet(grid.values[0].data() + run + i, grid.values[axis + 1].data() + run + i, step[axis]);
    return errors;
}

/// The largest distance of a chord from a function with these ends and slopes, if the function is convex or concave:
/// the tangents bound it. With an inflection either end may be the worse one.
float chordError(float rise, float fromSlope, float toSlope) noexcept {
    const float low = rise - fromSlope, high = toSlope - rise;
    if (low * high > 0.0F) return std::abs(low * high / (low + high));
    return 0.5F * std::max(std::abs(low), std::abs(high));
}

} // namespace

bool isSmooth(const LineCheck& check) noexcept {
    return check.bend <= mostBend && check.residual <= mostResidual;
}

bool mayBeSmooth(const LineCheck& check) noexcept {
    return check.bend <= mostMiddleBend && check.residual <= mostMiddleResidual;
}

bool agrees(const DistanceSample& expected, const DistanceSample& asked) noexcept {
    const glm::vec3 turn = expected.gradient - asked.gradient;
    return std::abs(expected.distance - asked.distance) <= mostMiddleError &&
           glm::dot(turn, turn) <= mostMiddleTurn * mostMiddleTurn;
}

LineError lineError(const LineCheck& check) noexcept {
    const float even = std::max(0.5F * check.residual, 0.25F * check.bend);
    return {even, std::max(check.bends - even, 0.0F)};
}

void BrickMaker::make(const glm::ivec3& corner, const SampleGrid& third, const LineError& thirdError, MadeBrick& made) {
    corner_ = glm::dvec3(corner);
    const LineError rest = sample(third);
    sampleError_ += thirdError.even;
    finish(made, false);
    // Interpolated lines no longer show their kinks.
    const bool asked = thirdError.kinked == 0.0F;
    made.kinkError = static_cast<float>(static_cast<double>(asked ? rest.kinked : thirdError.kinked) * voxel_);
    made.wideFacet = asked ? 2 : 4;
}

void BrickMaker::makeClosely(const glm::ivec3& corner, MadeBrick& made) {
    corner_ = glm::dvec3(corner);
    sampleError_ = made.kinkError = 0.0F;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) nine_.set(nine_.at(x, y, z), asker_.ask(corner_ + glm::dvec3(x, y, z)));
    finish(made, true);
}

void BrickMaker::finish(MadeBrick& made, bool closely) {
    float cells = boundCells();
    pack(made);
    const ExactCellFinder::Found found =
        closely ? exact_.listClosely(corner_, mask_, made) : exact_.list(corner_, mask_, made);
    cells = std::max({cells, errorOf(found.tooMany), found.error});
    const float quantisation = 0.5F * made.header.quantum;
    made.bound = static_cast<float>(static_cast<double>(cells + sampleError_ + rounding) * voxel_) + quantisation;
    made.sampleBound = static_cast<float>(static_cast<double>(sampleError_ + rounding) * voxel_) + quantisation;
}

/// @return the error of the samples that were not taken from the mesh
LineError BrickMaker::sample(const SampleGrid& third) {
    LineCheck four, two;
    refine(third, five_, 4.0F, four);
    refine(five_, nine_, 2.0F, two);
    if (isSmooth(four) && isSmooth(two)) {
        const LineError fours = lineError(four), twos = lineError(two);
        sampleError_ = estimate + std::max(fours.even, twos.even);
        return fours;
    }
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x)
                if (x % 2 != 0 || y % 2 != 0 || z % 2 != 0)
                    five_.set(five_.at(x, y, z), asker_.ask(corner_ + 2.0 * glm::dvec3(x, y, z)));
    two = {};
    refine(five_, nine_, 2.0F, two);
    sampleError_ = estimate + 0.5F * std::min(std::max(two.residual, 0.5F * two.bend), mostResidual);
    if (isSmooth(two)) return lineError(two);
    sampleFailing();
    return {};
}

/// Keeps samples on which smooth lines agree, provided that the adjacent mesh samples continue smoothly to them.
void BrickMaker::sampleFailing() {
    std::bitset<CellGrid::samples> onLines;
    std::vector<std::size_t> asked;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) {
                if (x % 2 == 0 && y % 2 == 0 && z % 2 == 0) continue;
                const std::size_t at = nine_.at(x, y, z);
                const std::optional<DistanceSample> known = between({x, y, z});
                onLines[at] = known.has_value();
                if (!known) asked.push_back(at);
                nine_.set(at, known ? *known : asker_.ask(corner_ + glm::dvec3(x, y, z)));
            }
    askBeside(std::move(asked), onLines);
}

/// Lines miss a feature that is narrower than their length, such as a slot that they cross: samples taken nearer to it
/// show it, and their slopes show that it continues. Starting from these, samples are taken from the mesh as far as
/// that holds.
void BrickMaker::askBeside(std::vector<std::size_t> asked, std::bitset<CellGrid::samples>& onLines) {
    constexpr std::array<std::size_t, 3> step{1, CellGrid::along, CellGrid::along * CellGrid::along};
    while (!asked.empty()) {
        const std::size_t from = asked.back();
        asked.pop_back();
        const glm::ivec3 place = CellGrid::cellOf(static_cast<int>(from));
        for (int side = 0; side < 6; ++side) {
            const int axis = side / 2, way = side % 2 == 0 ? 1 : -1;
            if (place[axis] + way < 0 || place[axis] + way > CellGrid::cells) continue;
            const std::size_t a = static_cast<std::size_t>(axis), to = way > 0 ? from + step[a] : from - step[a];
            if (!onLines[to]) continue;
            const std::vector<float>& slope = nine_.values[a + 1];
            const float rise = static_cast<float>(way) * (nine_.values[0][to] - nine_.values[0][from]);
            if (std::abs(rise - 0.5F * (slope[from] + slope[to])) <= mostStep) continue;
            nine_.set(to, asker_.ask(corner_ + glm::dvec3(CellGrid::cellOf(static_cast<int>(to)))));
            onLines[to] = false;
            asked.push_back(to);
        }
    }
}

/// A sample with odd coordinates lies in the middle of one, two or four lines between even ones.
std::optional<DistanceSample> BrickMaker::between(const glm::ivec3& sample) const noexcept {
    const glm::ivec3 odd = sample % 2, low = (sample - odd) / 2;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    DistanceSample sum;
    int lines = 0;
    for (int signs = 0; signs < 8; ++signs) {
        const glm::ivec3 up{signs & 1, (signs >> 1) & 1, signs >> 2};
        if (up.x > odd.x || up.y > odd.y || up.z > odd.z) continue;
        if (signs > 7 - signs && odd == glm::ivec3(1)) continue;
        const glm::ivec3 a = low + up, b = low + odd - up;
        const DistanceSample from = five_.get(five_.at(a.x, a.y, a.z)), to = five_.get(five_.at(b.x, b.y, b.z));
        const glm::vec3 way = 2.0F * glm::vec3(odd - 2 * up);
        const float bend = glm::dot(from.gradient - to.gradient, way) * 0.125F;
        const float residual = to.distance - from.distance - 0.5F * glm::dot(from.gradient + to.gradient, way);
        if (!(std::abs(bend) <= mostBend) || !(std::abs(residual) <= mostResidual)) return std::nullopt;
        const float estimate = 0.5F * (from.distance + to.distance) + bend;
        least = std::min(least, estimate);
        most = std::max(most, estimate);
        sum.distance += estimate;
        sum.gradient += 0.5F * (from.gradient + to.gradient);
        ++lines;
    }
    if (most - least > mostSpread) return std::nullopt;
    const float share = 1.0F / static_cast<float>(lines);
    return DistanceSample{sum.distance * share, sum.gradient * share};
}

/// Where the curvature at the ends of each edge is similar, the chords' errors; where a ridge passes through, a quarter
/// of the range of slopes, because it may cross the edges near their ends and still pass through the centre of the
/// cell.
float BrickMaker::cellError(int x, int y, int z) const noexcept {
    const std::array<std::size_t, 3> step{1, 9, 81};
    const std::size_t first = nine_.at(x, y, z);
    float smooth = 0.0F, ridge = 0.0F, imbalance = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<float>& slope = nine_.values[axis + 1];
        const std::size_t u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
        float worst = 0.0F, least = slope[first], most = least;
        for (const std::size_t from : {first, first + u, first + v, first + u + v}) {
            const std::size_t to = from + step[axis];
            const float rise = nine_.values[0][to] - nine_.values[0][from];
            const float uneven = std::abs(2.0F * rise - slope[from] - slope[to]);
            worst = std::max(worst, chordError(rise, slope[from], slope[to]) + 0.25F * uneven);
            imbalance = std::max(imbalance, uneven);
            least = std::min({least, slope[from], slope[to]});
            most = std::max({most, slope[from], slope[to]});
        }
        smooth += worst;
        ridge += 0.25F * (most - least);
    }
    return imbalance <= mostImbalance ? smooth : std::max(smooth, ridge);
}

/// The largest error of the cells that stay trilinear, voxels; marks the others.
float BrickMaker::boundCells() {
    mask_ = {};
    float whole = 0.0F, imbalance = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const ChordErrors errors = chordErrors(nine_, axis);
        whole += errors.worst();
        imbalance = std::max(imbalance, errors.imbalance());
    }
    if (whole <= mostCellError && imbalance <= mostImbalance) return whole;
    float largest = 0.0F;
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const float error = cellError(x, y, z);
                if (error > mostCellError)
                    mask_[static_cast<std::size_t>(z)] |= std::uint64_t{1} << (x + 8 * y);
                else
                    largest = std::max(largest, error);
            }
    return largest;
}

float BrickMaker::errorOf(const CellMask& cells) const noexcept {
    float largest = 0.0F;
    for (int z = 0; z < 8; ++z)
        for (std::uint64_t layer = cells[static_cast<std::size_t>(z)]; layer != 0; layer &= layer - 1) {
            const int place = std::countr_zero(layer);
            largest = std::max(largest, cellError(place % 8, place / 8, z));
        }
    return largest;
}

void BrickMaker::pack(MadeBrick& made) const {
    const std::vector<float>& f = nine_.values[0];
    std::array<double, 4> sums{}; // of the values, and of the values times the position relative to the middle
    float nearest = std::numeric_limits<float>::infinity();
    bool below = false, above = false;
    made.bandVoxels = 0;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) {
                const float value = f[nine_.at(x, y, z)], size = std::abs(value);
                const auto precise = static_cast<double>(value);
                sums[0] += precise;
                sums[1] += precise * (x - 4);
                sums[2] += precise * (y - 4);
                sums[3] += precise * (z - 4);
                nearest = std::min(nearest, size);
                (value < 0.0F ? below : above) = true;
                if (x < 8 && y < 8 && z < 8 && size <= bandVoxels) ++made.bandVoxels;
            }
    made.least =
        below && above ? 0.0F : static_cast<float>(voxel_) * std::max(nearest - halfDiagonalAbove - sampleError_, 0.0F);

    constexpr double weight = 81.0 * 60.0; // sum of the squared positions
    const glm::vec3 slope(glm::dvec3(sums[1], sums[2], sums[3]) / weight);
    const float base = static_cast<float>(sums[0] / CellGrid::samples) - 4.0F * (slope.x + slope.y + slope.z);
    std::array<float, CellGrid::samples> residuals;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) {
                const std::size_t at = nine_.at(x, y, z);
                const float plane = base + glm::dot(slope, glm::vec3(x, y, z));
                residuals[at] = f[at] - plane;
                least = std::min(least, residuals[at]);
                most = std::max(most, residuals[at]);
            }
    const float middle = 0.5F * (least + most), half = 0.5F * (most - least);
    for (float& residual : residuals) residual -= middle;
    const auto voxel = static_cast<float>(voxel_);
    made.header.base = (base + middle) * voxel;
    for (int axis = 0; axis < 3; ++axis) made.header.slope[static_cast<std::size_t>(axis)] = slope[axis] * voxel;
    packResiduals(made, residuals, half);
}

void BrickMaker::packResiduals(MadeBrick& made, const std::array<float, CellGrid::samples>& residuals,
                               float half) const {
    const bool narrow = half <= 127.0F * narrowQuantum;
    const float quantum = std::max(half / (narrow ? 127.0F : 32767.0F), 1e-9F);
    made.header.quantum = quantum * static_cast<float>(voxel_);
    made.header.wide = narrow ? 0 : 1;
    made.wide.clear();
    const float perQuantum = 1.0F / quantum;
    const auto units = [&](std::size_t i) noexcept { // the nearest
        const float unit = residuals[i] * perQuantum;
        return static_cast<std::int32_t>(unit + (unit < 0.0F ? -0.5F : 0.5F));
    };
    if (narrow) {
        for (std::size_t i = 0; i < residuals.size(); ++i) made.narrow[i] = static_cast<std::int8_t>(units(i));
    } else {
        made.wide.resize(residuals.size());
        for (std::size_t i = 0; i < residuals.size(); ++i) made.wide[i] = static_cast<std::int16_t>(units(i));
    }
}

} // namespace burin
