// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_loss.h"

#include "core/base/numbers.h"

#include <algorithm>

namespace burin {

BrickMap::BrickMap(const Grid& grid)
    : grid_(grid)
    , bricksU_((grid.lineCountU() + tileSide - 1) / tileSide)
    , bricksV_((grid.lineCountV() + tileSide - 1) / tileSide)
    , present_(static_cast<std::size_t>(bricksU_) * static_cast<std::size_t>(bricksV_)) {}

void BrickMap::add(LineIndex line) {
    if (!has(line)) ++count_;
    present_[placeOf(line)] = true;
}

VolumeLoss BrickMap::lossOf(std::int32_t lowU, std::int32_t lowV, std::int32_t highU, std::int32_t highV) const {
    VolumeLoss loss{{lowU * tileSide, lowV * tileSide},
                    {std::min(highU * tileSide, grid_.lineCountU()), std::min(highV * tileSide, grid_.lineCountV())},
                    grid_.box()};
    const glm::dvec3& low = grid_.low();
    const int u = grid_.axisOfU(), v = grid_.axisOfV();
    loss.box.low[u] = low[u] + loss.low.u * grid_.edge();
    loss.box.low[v] = low[v] + loss.low.v * grid_.edge();
    loss.box.high[u] = low[u] + loss.high.u * grid_.edge();
    loss.box.high[v] = low[v] + loss.high.v * grid_.edge();
    return loss;
}

std::vector<VolumeLoss> BrickMap::losses() const {
    std::vector<VolumeLoss> losses;
    std::vector<std::size_t> above; // losses of the previous row that may continue
    for (std::int32_t v = 0; v < bricksV_; ++v) {
        std::vector<std::size_t> here;
        for (std::int32_t u = 0; u < bricksU_;) {
            const auto missing = [&](std::int32_t at) { return !has({at * tileSide, v * tileSide}); };
            const std::int32_t first = u;
            while (u < bricksU_ && missing(u)) ++u;
            if (u == first) {
                ++u;
                continue;
            }
            const VolumeLoss next = lossOf(first, v, u, v + 1);
            const auto goesOn = std::ranges::find_if(above, [&](std::size_t place) {
                return losses[place].low.u == next.low.u && losses[place].high.u == next.high.u;
            });
            if (goesOn == above.end()) {
                here.push_back(losses.size());
                losses.push_back(next);
            } else {
                here.push_back(*goesOn);
                losses[*goesOn].high = next.high;
                losses[*goesOn].box.high = next.box.high;
            }
        }
        above = std::move(here);
    }
    return losses;
}

namespace {

std::string textOf(const Box& box) {
    constexpr int decimals = 3;
    std::string text;
    for (int i = 0; i < 3; ++i) {
        text += i == 0 ? "x " : i == 1 ? ", y " : ", z ";
        text += formatFixed(box.low[i], decimals) + " to " + formatFixed(box.high[i], decimals);
    }
    return text + " mm";
}

std::size_t bricksIn(const VolumeLoss& loss) {
    const auto across = [](std::int32_t low, std::int32_t high) {
        return static_cast<std::size_t>((high - low + tileSide - 1) / tileSide);
    };
    return across(loss.low.u, loss.high.u) * across(loss.low.v, loss.high.v);
}

} // namespace

std::optional<Error> VolumeFileContent::damage() const {
    if (lost.empty()) return std::nullopt;
    constexpr std::size_t named = 3; // named in the message; `lost` has all of them
    std::size_t bricks = 0;
    for (const VolumeLoss& loss : lost) bricks += bricksIn(loss);
    std::string place =
        std::to_string(bricks) + (bricks == 1 ? " brick is" : " bricks are") + " lost and read as air: ";
    for (std::size_t i = 0; i < std::min(named, lost.size()); ++i) place += (i > 0 ? "; " : "") + textOf(lost[i].box);
    if (lost.size() > named) place += "; and " + std::to_string(lost.size() - named) + " further boxes";
    return Error{ErrorCode::fileDamaged, file, place, {}};
}

} // namespace burin
