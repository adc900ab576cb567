// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"
#include "tests/core/job/session_stage.h"

#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::test {

/// Takes of adjacent rows, each take lower than the one before, so that every tick cuts. Part of it is undone.
struct Rows {
    explicit Rows(const std::vector<std::uint64_t>& counts)
        : project(*Project::create(folder.filePath("p.burin").toStdString())) {
        good = project.setModel(Model{}) && project.setSetup(blockSetup()) && project.setTool(sessionTool());
        MillingContext milling = blockMilling();
        for (std::size_t i = 0; i < counts.size(); ++i) {
            TakeInfo info;
            info.name = "rows";
            info.toolId = sessionTool().id;
            Result<Project::TakeWriter> writer = project.beginTake(info);
            const std::vector<Sample> samples = rows(counts[i], 1.0 + static_cast<double>(i), milling);
            good = good && writer && writer->append(samples) && writer->finish();
            if (i == 1) good = good && project.undoInterval(writer->id(), {counts[i] / 3, 400});
            if (good) takes.push_back(*project.take(writer->id()));
        }
    }
    static std::vector<Sample> rows(std::uint64_t count, double depth, MillingContext& milling) {
        MaterialRemoval removal(sessionTool().cutter, milling.embedded.workpiece.grid(), Writing::everyCut);
        std::vector<Sample> samples;
        double along = 0.0;
        for (std::uint64_t i = 0; i < count; ++i, along += 0.1) {
            const double row = std::floor(along / side), in = along - row * side;
            Sample sample;
            sample.tick = i;
            sample.time = 0.001 * static_cast<double>(i);
            sample.proxy.tip = {std::fmod(row, 2.0) == 0.0 ? in : side - in, 0.35 * row, top - depth};
            if (!samples.empty()) {
                const RunAmounts before = milling.embedded.workpiece.amounts();
                (void)removal.cut(milling.embedded.workpiece, samples.back().proxy, sample.proxy);
                const PropertyIndex stock = milling.embedded.stockProperty;
                sample.removed[0] = {before.units[stock] - milling.embedded.workpiece.amounts().units[stock], stock};
            }
            samples.push_back(sample);
        }
        return samples;
    }
    QTemporaryDir folder;
    Project project;
    std::vector<Take> takes;
    bool good = true;
};

/// The order of takes that are given in their order.
inline TakeOrder orderOf(const std::vector<Take>& takes) {
    std::vector<std::int64_t> ids;
    for (const Take& take : takes) ids.push_back(take.info.id);
    return TakeOrder(ids);
}

/// Returns the workpiece at moments by a direct replay of all cuts from the first tick on: nothing is cached, packed or
/// deferred. @param takes in their order @param rising moments in that order
inline std::vector<Lines> replayedTo(const std::vector<Take>& takes, const std::vector<TakeMoment>& rising) {
    MillingContext milling = blockMilling();
    RunVolume& volume = milling.embedded.workpiece;
    std::vector<Lines> workpieces;
    const TakeOrder order = orderOf(takes);
    const auto reached = [&](const TakeMoment& now) {
        while (workpieces.size() < rising.size() && !order.isBefore(now, rising[workpieces.size()]))
            workpieces.push_back(linesOf(volume));
    };
    for (const Take& take : takes) {
        MaterialRemoval removal(sessionTool().cutter, volume.grid(), Writing::everyCut);
        for (std::size_t i = 0; i < take.samples.size(); ++i) {
            reached({take.info.id, i});
            const bool undone =
                std::ranges::any_of(take.undone, [&](const SampleRange& range) { return range.contains(i); });
            const bool cut = std::ranges::any_of(take.samples[i].removed,
                                                 [](const RemovedMaterial& removed) { return removed.units > 0; });
            if (i > 0 && cut && !undone) (void)removal.cut(volume, take.samples[i - 1].proxy, take.samples[i].proxy);
        }
        reached({take.info.id, take.samples.size()});
    }
    reached({std::numeric_limits<std::int64_t>::max(), ~std::uint64_t{0}});
    return workpieces;
}

inline std::vector<SharedCuts> sharedCuts(const Project& project) {
    std::vector<SharedCuts> cuts;
    const Result<RecordedWork> work = recordedWork(project, false);
    for (const RecordedCuts& take : work->cuts) cuts.push_back(std::make_shared<const RecordedCuts>(take));
    return cuts;
}

/// The kept workpiece of the block, before the first take.
inline KeptWorkpiece stock() {
    Progress progress;
    return *keptAs(blockMilling().embedded.workpiece.snapshot(), {}, {}, progress);
}

} // namespace burin::test
