// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/brick_sampler.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr double slack = 1e-6; // mm, over what the Lipschitz bound allows: rounding

std::size_t cubeAt(const glm::ivec3& i, int along) noexcept {
    return static_cast<std::size_t>(i.x + along * (i.y + along * i.z));
}

} // namespace

ClearanceSample clearanceAt(const MeshDistance& part, const ToolFieldRequest& request, const glm::dvec3& tip,
                            double within, double tolerance) {
    const ToolClearance found = part.clearance(request.tool, {tip, {0.0, 0.0, 1.0}}, within, tolerance);
    if (found.clearance < within) return {std::min(found.clearance, farthestClearance), found.away};
    return {std::min(within, farthestClearance), glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
}

BrickSampler::BrickSampler(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                           BrickField& field, const std::vector<std::uint32_t>& fine,
                           const std::vector<PartSample>& corners)
    : part_(part)
    , request_(request)
    , resolution_(resolution)
    , field_(field)
    , fine_(fine)
    , corners_(corners)
    , smooth_(fine.size(), 0)
    , even_(fine.size() * evens * evens * evens) {}

ClearanceSample BrickSampler::ask(const glm::dvec3& tip, double within) const {
    // Deep in the part, below what the band's cells look at, a bound will do.
    if (within < resolution_.low - 2.0 * field_.spacing)
        return {within, glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
    return clearanceAt(part_, request_, tip, within, 0.2 * resolution_.interpolationBound);
}

glm::dvec3 BrickSampler::place(std::size_t order, const glm::ivec3& sample) const noexcept {
    return field_.brickLow(field_.brickOf(fine_[order])) + glm::dvec3(sample) * field_.spacing;
}

/// The samples between the corners, when lines between these are smooth all over the brick.
bool BrickSampler::cornersAgree(std::size_t order, SampleGrid& nine) const {
    const glm::ivec3 brick = field_.brickOf(fine_[order]);
    SampleGrid two(2), three(3), five(5);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 at{i & 1, (i >> 1) & 1, (i >> 2) & 1};
        const PartSample& corner = corners_[field_.cornerAt(brick + at)];
        if (!std::isfinite(corner.gradient.x)) return false;
        two.set(static_cast<std::size_t>(i), corner);
    }
    const auto spacing = static_cast<float>(field_.spacing);
    LineCheck check;
    refine(two, three, 8.0F * spacing, check);
    refine(three, five, 4.0F * spacing, check);
    refine(five, nine, 2.0F * spacing, check);
    const auto voxel = static_cast<float>(request_.voxel);
    return check.bend <= 0.06F * voxel && check.residual <= 0.03F * voxel;
}

void BrickSampler::look(std::size_t order) {
    // What a tool's clearance has of features is as wide as the tool: corners farther apart could miss one.
    if (2.0 * request_.tool.front().bottomRadius < field_.brickEdge()) return;
    SampleGrid nine(BrickField::samplesAlong);
    if (!cornersAgree(order, nine)) return;
    const auto middle = static_cast<double>(nine.values[0][BrickField::sampleAt(glm::ivec3(4))]);
    const double asked = clearanceAt(part_, request_, place(order, glm::ivec3(4)), middle + request_.voxel).value;
    if (std::abs(asked - middle) <= 0.01 * request_.voxel) smooth_[order] = 1;
}

void BrickSampler::fillSmooth(std::size_t order) {
    SampleGrid nine(BrickField::samplesAlong);
    cornersAgree(order, nine);
    std::int16_t* const first = field_.samples.data() + order * BrickField::samplesPerBrick;
    for (std::size_t i = 0; i < BrickField::samplesPerBrick; ++i)
        first[i] = packed(static_cast<double>(nine.values[0][i]));
}

void BrickSampler::sampleEven(std::size_t order) {
    if (smooth_[order] != 0) return;
    Even* const first = even_.data() + order * evens * evens * evens;
    double bound = farthestClearance; // no tip has more than another one has, and the way between
    glm::ivec3 last{0};
    for (int k = 0; k < evens; ++k)
        for (int row = 0; row < evens; ++row)
            for (int column = 0; column < evens; ++column) {
                const int j = k % 2 == 0 ? row : evens - 1 - row; // to and fro: the way is always one step
                const int i = (row + k * evens) % 2 == 0 ? column : evens - 1 - column;
                const glm::ivec3 at{i, j, k};
                const double way = 2.0 * field_.spacing * glm::length(glm::dvec3(at - last));
                const ClearanceSample found = ask(place(order, 2 * at), bound + way);
                first[cubeAt(at, evens)] = {static_cast<float>(found.value), glm::vec3(found.gradient)};
                bound = found.value + slack;
                last = at;
            }
}

/// Its own, the next bricks', and where the next brick is coarse, asked again.
BrickSampler::Evens BrickSampler::gather(std::size_t order) const {
    const glm::ivec3 brick = field_.brickOf(fine_[order]);
    Evens all;
    double bound = farthestClearance;
    glm::ivec3 last{0};
    for (int k = 0; k < evensAlong; ++k)
        for (int j = 0; j < evensAlong; ++j)
            for (int i = 0; i < evensAlong; ++i) {
                const glm::ivec3 at{i, j, k}, step = at / evens, owner = brick + step;
                ClearanceSample& sample = all[cubeAt(at, evensAlong)];
                const bool outside =
                    owner.x >= field_.bricks.x || owner.y >= field_.bricks.y || owner.z >= field_.bricks.z;
                const std::int32_t number = outside ? BrickField::coarse : field_.place[field_.brickAt(owner)];
                if (number != BrickField::coarse && smooth_[static_cast<std::size_t>(number)] == 0) {
                    const Even& known = even_[static_cast<std::size_t>(number) * evens * evens * evens +
                                              cubeAt(at - step * evens, evens)];
                    sample = {static_cast<double>(known.value), glm::dvec3(known.gradient)};
                } else {
                    const double way = 2.0 * field_.spacing * glm::length(glm::dvec3(at - last));
                    sample = ask(place(order, 2 * at), bound + way);
                }
                bound = sample.value + slack;
                last = at;
            }
    return all;
}

/// A sample with odd places lies in the middle of one, two or four lines between even ones.
std::optional<double> BrickSampler::between(const Evens& all, const glm::ivec3& sample) const noexcept {
    // What these allow is explained in README.md.
    const double mostBend = 0.1 * request_.voxel, mostResidual = 0.06 * request_.voxel;
    const double mostSpread = 0.03 * request_.voxel;
    const glm::ivec3 odd = sample % 2, low = (sample - odd) / 2;
    // More than a voxel inside nothing but the way out is asked for: straight lines will do.
    const double mean = 0.5 * (all[cubeAt(low, evensAlong)].value + all[cubeAt(low + odd, evensAlong)].value);
    const bool deep = mean < -1.25 * request_.voxel - field_.spacing;
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0.0;
    int lines = 0;
    for (int signs = 0; signs < 8; ++signs) {
        const glm::ivec3 up = glm::ivec3(signs & 1, (signs >> 1) & 1, signs >> 2);
        if (up.x > odd.x || up.y > odd.y || up.z > odd.z) continue;
        if (signs > 7 - signs && odd == glm::ivec3(1)) continue;
        const ClearanceSample& from = all[cubeAt(low + up, evensAlong)];
        const ClearanceSample& to = all[cubeAt(low + odd - up, evensAlong)];
        const glm::dvec3 way = 2.0 * field_.spacing * glm::dvec3(odd - 2 * up);
        double estimate = 0.5 * (from.value + to.value);
        if (!deep) {
            const double bend = glm::dot(from.gradient - to.gradient, way) / 8.0;
            const double residual = to.value - from.value - 0.5 * glm::dot(from.gradient + to.gradient, way);
            if (!(std::abs(bend) <= mostBend) || !(std::abs(residual) <= mostResidual)) return std::nullopt;
            estimate += bend;
        }
        least = std::min(least, estimate);
        most = std::max(most, estimate);
        sum += estimate;
        ++lines;
    }
    if (!deep && most - least > mostSpread) return std::nullopt;
    return sum / lines;
}

void BrickSampler::fill(std::size_t order) {
    if (smooth_[order] != 0) return fillSmooth(order);
    const Evens all = gather(order);
    std::int16_t* const first = field_.samples.data() + order * BrickField::samplesPerBrick;
    for (int k = 0; k <= BrickField::cells; ++k)
        for (int j = 0; j <= BrickField::cells; ++j)
            for (int i = 0; i <= BrickField::cells; ++i) {
                const glm::ivec3 at{i, j, k};
                const ClearanceSample& near = all[cubeAt(at / 2, evensAlong)];
                const glm::ivec3 odd = at % 2;
                double value = near.value;
                if (odd != glm::ivec3(0)) {
                    const std::optional<double> smooth = between(all, at);
                    const double way = field_.spacing * glm::length(glm::dvec3(odd));
                    value = smooth ? *smooth : ask(place(order, at), near.value + way + slack).value;
                }
                first[BrickField::sampleAt(at)] = packed(value);
            }
}

std::int16_t BrickSampler::packed(double value) const noexcept {
    const double units = std::floor((value - resolution_.interpolationBound) / field_.quantum);
    return static_cast<std::int16_t>(std::clamp(units, -32767.0, 32767.0));
}

} // namespace burin
