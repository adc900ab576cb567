// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/brick_sampler.h"

#include "core/field/brick_excess.h"
#include "core/field/spread.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

// In voxels; README.md explains what these permit.
constexpr float mostBendOfCorners = 0.06F, mostBendOfFours = 0.1F, mostResidual = 0.03F;
constexpr float mostDifference = 0.01F, mostDifferenceInDepth = 0.25F; // between a brick's middle and lines through it
constexpr double mostBend = 0.1, mostResidualOfTwos = 0.06, mostSpread = 0.03;
constexpr double tolerance = 0.004, toleranceInDepth = 0.1; // of samples

/// Calls `visit` for each index of a grid, back and forth, so that consecutive ones are neighbours.
template <class Visit>
void toAndFro(int along, const Visit& visit) {
    for (int k = 0; k < along; ++k)
        for (int row = 0; row < along; ++row)
            for (int column = 0; column < along; ++column)
                visit(glm::ivec3((row + k * along) % 2 == 0 ? column : along - 1 - column,
                                 k % 2 == 0 ? row : along - 1 - row, k));
}

/// Error of lines along three axes, mm, if each has a kink, or two opposite ones.
double errorOf(const LineCheck& check) noexcept {
    return static_cast<double>(check.bends + 1.5F * check.residual);
}

std::size_t placeIn(const glm::ivec3& i, int along) noexcept {
    return static_cast<std::size_t>(i.x + along * (i.y + along * i.z));
}

} // namespace

BrickSampler::BrickSampler(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                           BrickField& field, const std::vector<std::uint32_t>& fine,
                           const std::vector<TipSample>& corners)
    : part_(part)
    , request_(request)
    , resolution_(resolution)
    , field_(field)
    , fine_(fine)
    , corners_(corners)
    , deep_(-1.25 * request.voxel - field.spacing) {}

void BrickSampler::Level::lay(const std::vector<std::uint8_t>& wanted) {
    std::int32_t count = 0;
    for (const std::uint8_t one : wanted) place.push_back(one != 0 ? count++ : none);
    samples.resize(static_cast<std::size_t>(count) * owned());
}

void BrickSampler::fill(Progress& progress, double from, double to) {
    const auto at = [&](double share) { return from + share * (to - from); };
    std::vector<std::uint8_t> left(fine_.size(), 1); // not filled yet
    const auto bricks = [&](double begin, double end, const auto& work) {
        spreadIntervals(fine_.size(), at(begin), at(end), progress, [&](std::size_t first, std::size_t last) {
            TipAsker ask = asker();
            Grids grids;
            for (std::size_t order = first; order < last && !progress.cancelled(); ++order)
                if (left[order] != 0) work(order, ask, grids);
        });
    };
    // Features of a tool's clearance are as wide as the tool: samples farther apart could miss one.
    const double width = 2.0 * request_.tool.front().bottomRadius;
    if (width >= field_.brickEdge())
        bricks(0.0, 0.1, [&](std::size_t order, TipAsker& ask, Grids& grids) {
            left[order] = fillFromCorners(order, ask, grids) ? 0 : 1;
        });
    const bool wideEnough = width >= fours_.step * field_.spacing;
    if (wideEnough) {
        fours_.lay(left);
        bricks(0.1, 0.3, [&](std::size_t order, TipAsker& ask, Grids&) { own(order, fours_, nullptr, ask); });
        bricks(0.3, 0.4, [&](std::size_t order, TipAsker& ask, Grids& grids) {
            left[order] = fillFromFours(order, ask, grids) ? 0 : 1;
        });
    }
    twos_.lay(left);
    bricks(0.4, 0.7,
           [&](std::size_t order, TipAsker& ask, Grids&) { own(order, twos_, wideEnough ? &fours_ : nullptr, ask); });
    bricks(0.7, 1.0, [&](std::size_t order, TipAsker& ask, Grids& grids) { fillFromTwos(order, ask, grids); });
}

/// The bound that is subtracted from samples covers the tolerance; the tolerance in depth applies only to samples that
/// no line from outside meets.
TipAsker BrickSampler::asker() const {
    const double deepBelow = deep_ - BrickField::cells / 2 * field_.spacing;
    return {part_, request_, {tolerance * request_.voxel, deepBelow, toleranceInDepth * request_.voxel}};
}

glm::dvec3 BrickSampler::place(std::size_t order, const glm::ivec3& sample) const noexcept {
    return field_.brickLow(field_.brickOf(fine_[order])) + glm::dvec3(sample) * field_.spacing;
}

bool BrickSampler::isSmooth(const LineCheck& check, float most) const noexcept {
    const auto voxel = static_cast<float>(request_.voxel);
    return check.bend <= most * voxel && check.residual <= mostResidual * voxel;
}

float BrickSampler::Grid::gainAt(const glm::vec3& share) const noexcept {
    const int cells = samples.side - 1;
    const glm::vec3 place = share * static_cast<float>(cells);
    const glm::ivec3 low = glm::min(glm::ivec3(place), cells - 1);
    const glm::vec3 part = place - glm::vec3(low);
    const auto alongX = [&](int y, int z) {
        const std::size_t from = samples.at(low.x, low.y + y, low.z + z);
        return glm::mix(gains[from], gains[from + 1], part.x);
    };
    return glm::mix(glm::mix(alongX(0, 0), alongX(1, 0), part.y), glm::mix(alongX(0, 1), alongX(1, 1), part.y), part.z);
}

bool BrickSampler::fillFromCorners(std::size_t order, TipAsker& ask, Grids& grids) {
    const glm::ivec3 brick = field_.brickOf(fine_[order]);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 at{i & 1, (i >> 1) & 1, i >> 2};
        grids.two.set(at, corners_[field_.cornerAt(brick + at)]);
    }
    const auto spacing = static_cast<float>(field_.spacing);
    LineCheck check;
    check.floor = static_cast<float>(deep_);
    refine(grids.two.samples, grids.middle, 8.0F * spacing, check);
    const double lineError = errorOf(check);
    refine(grids.middle, grids.fine, 4.0F * spacing, check);
    refine(grids.fine, grids.nine, 2.0F * spacing, check);
    if (!isSmooth(check, mostBendOfCorners)) return false;
    const float middle = grids.nine.values[0][BrickField::sampleAt(glm::ivec3(4))];
    const float asked = ask.ask(place(order, glm::ivec3(4))).straightened().distance;
    const float most = asked < check.floor ? mostDifferenceInDepth : mostDifference;
    if (!(std::abs(asked - middle) <= most * static_cast<float>(request_.voxel))) return false;
    pack(order, grids.two, grids.nine, lineError);
    return true;
}

/// Samples of the corners and of a coarser level are known already.
void BrickSampler::own(std::size_t order, Level& level, const Level* coarser, TipAsker& ask) const {
    TipSample* const first = level.samples.data() + static_cast<std::size_t>(level.place[order]) * level.owned();
    const int along = level.along();
    toAndFro(along, [&](const glm::ivec3& at) {
        TipSample& sample = first[placeIn(at, along)];
        if (at == glm::ivec3(0))
            sample = corners_[field_.cornerAt(field_.brickOf(fine_[order]))];
        else if (coarser != nullptr && at % 2 == glm::ivec3(0))
            sample = coarser->samples[static_cast<std::size_t>(coarser->place[order]) * coarser->owned() +
                                      placeIn(at / 2, coarser->along())];
        else
            sample = ask.ask(place(order, level.step * at));
    });
}

/// Collects the brick's own samples and those of the next bricks, and evaluates the part where these have none.
void BrickSampler::gather(std::size_t order, const Level& level, TipAsker& ask, Grid& all) const {
    const glm::ivec3 brick = field_.brickOf(fine_[order]);
    const int along = level.along();
    toAndFro(along + 1, [&](const glm::ivec3& at) {
        const glm::ivec3 step = at / along, owner = brick + step, in = at - step * along;
        const bool outside = glm::any(glm::greaterThanEqual(owner, field_.bricks));
        const std::int32_t number = outside ? BrickField::coarse : field_.place[field_.brickAt(owner)];
        const std::int32_t known = number == BrickField::coarse ? none : level.place[static_cast<std::size_t>(number)];
        if (in == glm::ivec3(0))
            all.set(at, corners_[field_.cornerAt(owner)]);
        else if (known != none)
            all.set(at, level.samples[static_cast<std::size_t>(known) * level.owned() + placeIn(in, along)]);
        else
            all.set(at, ask.ask(place(order, level.step * at)));
    });
}

bool BrickSampler::fillFromFours(std::size_t order, TipAsker& ask, Grids& grids) {
    gather(order, fours_, ask, grids.three);
    const auto spacing = static_cast<float>(field_.spacing);
    LineCheck check;
    check.floor = static_cast<float>(deep_);
    refine(grids.three.samples, grids.fine, 4.0F * spacing, check);
    const double lineError = errorOf(check);
    refine(grids.fine, grids.nine, 2.0F * spacing, check);
    if (!isSmooth(check, mostBendOfFours)) return false;
    pack(order, grids.three, grids.nine, lineError);
    return true;
}

void BrickSampler::fillFromTwos(std::size_t order, TipAsker& ask, Grids& grids) {
    gather(order, twos_, ask, grids.five);
    std::int16_t* const first = field_.samples.data() + order * BrickField::samplesPerBrick;
    double error = 0.0;
    toAndFro(BrickField::samplesAlong, [&](const glm::ivec3& at) {
        const std::optional<Between> known = between(grids.five, at);
        const double value = known ? known->value : static_cast<double>(ask.ask(place(order, at)).clearance.distance);
        if (known) error = std::max(error, known->error);
        first[BrickField::sampleAt(at)] = packed(value);
    });
    bound(order, error);
}

/// A sample with odd indices lies in the middle of one, two or four lines between even ones.
std::optional<BrickSampler::Between> BrickSampler::between(const Grid& all, const glm::ivec3& sample) const noexcept {
    const SampleGrid& twos = all.samples;
    const glm::ivec3 odd = sample % 2, low = (sample - odd) / 2;
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0.0, error = 0.0;
    float leastGain = 1.0F, mostGain = 0.0F;
    bool deep = false;
    int lines = 0;
    for (int signs = 0; signs < 8; ++signs) {
        const glm::ivec3 up = glm::ivec3(signs & 1, (signs >> 1) & 1, signs >> 2);
        if (up.x > odd.x || up.y > odd.y || up.z > odd.z) continue;
        if (signs > 7 - signs && odd == glm::ivec3(1)) continue;
        const glm::ivec3 a = low + up, b = low + odd - up;
        const DistanceSample from = twos.get(twos.at(a.x, a.y, a.z)), to = twos.get(twos.at(b.x, b.y, b.z));
        const glm::dvec3 way = 2.0 * field_.spacing * glm::dvec3(odd - 2 * up);
        const auto start = static_cast<double>(from.distance), end = static_cast<double>(to.distance);
        double estimate = 0.5 * (start + end);
        if (estimate < 0.0)
            for (const glm::ivec3& place : {a, b}) {
                const float gain = all.gains[twos.at(place.x, place.y, place.z)];
                leastGain = std::min(leastGain, gain);
                mostGain = std::max(mostGain, gain);
            }
        // In depth the field only has to lead outwards: straight lines suffice.
        deep = deep || estimate < deep_;
        if (!deep) {
            const double bend = glm::dot(glm::dvec3(from.gradient - to.gradient), way) / 8.0;
            const double residual = end - start - 0.5 * glm::dot(glm::dvec3(from.gradient + to.gradient), way);
            if (!(std::abs(bend) <= mostBend * request_.voxel) ||
                !(std::abs(residual) <= mostResidualOfTwos * request_.voxel))
                return std::nullopt;
            estimate += bend;
            error = std::max(error, std::abs(bend));
        }
        least = std::min(least, estimate);
        most = std::max(most, estimate);
        sum += estimate;
        ++lines;
    }
    if (!deep && most - least > mostSpread * request_.voxel) return std::nullopt;
    const float gain = all.gainAt(glm::vec3(sample) / static_cast<float>(BrickField::cells));
    const double value = sum / lines;
    if (!deep && leastGain < mostGain) error += gainError(value, leastGain, mostGain);
    return Between{static_cast<double>(bentBack(static_cast<float>(value), gain)), error};
}

void BrickSampler::pack(std::size_t order, const Grid& gains, const SampleGrid& nine, double lineError) {
    std::int16_t* const first = field_.samples.data() + order * BrickField::samplesPerBrick;
    const std::vector<float>& values = nine.values[0];
    const bool rim = std::ranges::min(gains.gains) < 1.0F;
    for (int k = 0; k <= BrickField::cells; ++k)
        for (int j = 0; j <= BrickField::cells; ++j)
            for (int i = 0; i <= BrickField::cells; ++i) {
                const std::size_t at = BrickField::sampleAt({i, j, k});
                float value = values[at];
                if (rim && value < 0.0F)
                    value = bentBack(value, gains.gainAt(glm::vec3(i, j, k) / static_cast<float>(BrickField::cells)));
                first[at] = packed(static_cast<double>(value));
            }
    if (rim) {
        const auto [leastGain, mostGain] = std::ranges::minmax(gains.gains);
        lineError += gainError(static_cast<double>(std::ranges::min(values)), leastGain, mostGain);
    }
    bound(order, lineError);
}

/// Error, mm, of straightened values, none deeper than the given one, after conversion back to clearances: with gains
/// between the least and the most. It is bounded only for clearances of less than a voxel inside.
double BrickSampler::gainError(double straightened, float least, float most) const noexcept {
    const double bounded = (request_.voxel + field_.spacing) / static_cast<double>(least);
    return std::clamp(-straightened, 0.0, bounded) * static_cast<double>(most - least);
}

/// The error of values between samples follows from the samples' differences and the samples' own error, less what is
/// subtracted from every sample.
void BrickSampler::bound(std::size_t order, double sampleError) noexcept {
    const double perUnit = field_.quantum, subtracted = resolution_.interpolationBound;
    const float between =
        kinkExcess(field_.samples.data() + order * BrickField::samplesPerBrick,
                   static_cast<float>(field_.spacing / perUnit), static_cast<float>((deep_ - subtracted) / perUnit));
    const double excess =
        static_cast<double>(between) * perUnit + sampleError + tolerance * request_.voxel + 2.0 * perUnit - subtracted;
    field_.fineBound[order] = static_cast<float>(std::max(excess, subtracted));
}

std::int16_t BrickSampler::packed(double value) const noexcept {
    const double units = std::floor((value - resolution_.interpolationBound) / field_.quantum);
    return static_cast<std::int16_t>(std::clamp(units, -32767.0, 32767.0));
}

} // namespace burin
