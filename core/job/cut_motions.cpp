// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/cut_motions.h"

#include <algorithm>
#include <string>

namespace burin {

namespace {

/// Whether the hand's tick removed material. If it did not, replaying must not either: braking, forces off, memory
/// full.
bool didCut(const Sample& sample) noexcept {
    return std::ranges::any_of(sample.removed, [](const RemovedMaterial& removed) { return removed.units > 0; });
}

Error noRoomIn(const RunVolume& workpiece) {
    return {ErrorCode::volumeOutOfMemory, std::to_string(workpiece.reservedBytes()), {}, {}};
}

} // namespace

Result<void> CutFinder::find(std::span<const Sample> next, const Use& use) {
    for (const Sample& sample : next) {
        const std::uint64_t index = index_++;
        if (before_ && didCut(sample) && !undone_.holds(index))
            if (Result<void> used = use(*before_, sample.proxy, index); !used) return used;
        before_ = sample.proxy;
    }
    return {};
}

void CutMotions::add(const ToolPose& from, const ToolPose& to, std::uint64_t sample) {
    constexpr std::size_t longest = 65536; // so that growing a run copies little
    const bool goesOn = !runs_.empty() && runs_.back().tips.size() <= longest && runs_.back().tips.back() == from.tip &&
                        runs_.back().axis == from.axis && runs_.back().axis == to.axis;
    if (!goesOn) runs_.push_back({from.axis, to.axis, count(), {from.tip}});
    runs_.back().tips.push_back(to.tip);
    samples_.push_back(static_cast<std::uint32_t>(sample));
}

Result<void> CutMotions::visit(std::uint64_t first, std::uint64_t end, const CutFinder::Use& use) const {
    if (first >= std::min(end, count())) return {};
    auto run = std::ranges::upper_bound(runs_, first, {}, &Run::before) - 1;
    for (; run != runs_.end() && run->before < end; ++run) {
        const std::size_t from = first > run->before ? first - run->before : 0;
        const std::size_t to = std::min<std::uint64_t>(run->tips.size() - 1, end - run->before);
        for (std::size_t i = from; i < to; ++i) {
            const ToolPose begin{run->tips[i], i == 0 ? run->firstAxis : run->axis};
            if (Result<void> used = use(begin, {run->tips[i + 1], run->axis}, samples_[run->before + i]); !used)
                return used;
        }
    }
    return {};
}

std::uint64_t CutMotions::countWithin(std::uint64_t samples) const noexcept {
    return static_cast<std::uint64_t>(std::ranges::lower_bound(samples_, samples) - samples_.begin());
}

CutReplay::CutReplay(const Tool& tool, RunVolume& workpiece)
    : workpiece_(workpiece), removal_(tool.cutter, workpiece.grid(), Writing::deferred) {}

Result<void> CutReplay::cut(const ToolPose& from, const ToolPose& to) {
    if (removal_.cut(workpiece_, from, to).outOfMemory) return noRoomIn(workpiece_);
    return {};
}

Result<void> CutReplay::finish() {
    if (removal_.settle(workpiece_).outOfMemory) return noRoomIn(workpiece_);
    return {};
}

} // namespace burin
