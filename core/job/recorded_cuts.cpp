// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/recorded_cuts.h"

#include "core/recording/stroke_count.h"
#include "core/volume/packed/volume_file.h"
#include "core/volume/runs/alike.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

namespace burin {

namespace {

Error replayCancelled() {
    return {ErrorCode::cancelled, "replaying takes", {}, {}};
}

CutFinder::Use cutAgain(CutReplay& replay, const Progress& progress) {
    return [&](const ToolPose& from, const ToolPose& to, std::uint64_t) -> Result<void> {
        if (progress.cancelled()) return replayCancelled();
        return replay.cut(from, to);
    };
}

/// Reports the progress of a replay from time to time.
class ReplayedShare {
public:
    explicit ReplayedShare(Progress& progress) noexcept : progress_(progress) {}
    void expect(std::uint64_t count) noexcept { all_ += count; }
    void did(std::uint64_t count) {
        constexpr std::uint64_t step = 16384;
        done_ += count;
        if (done_ < told_ + step) return;
        told_ = done_;
        progress_.report(static_cast<double>(done_) / static_cast<double>(std::max(all_, done_)));
    }

private:
    Progress& progress_;
    std::uint64_t all_ = 0, done_ = 0, told_ = 0;
};

/// Returns the newest valid kept workpiece that is not later than a moment.
Result<std::optional<KeptWorkpiece>> newestKept(const Project& project, const TakeOrder& order,
                                                const TakeMoment& until) {
    const Result<std::vector<TakeMoment>> moments = project.keptMoments();
    if (!moments) return moments.error();
    const auto behind = std::ranges::upper_bound(
        *moments, until, [&](const TakeMoment& one, const TakeMoment& other) { return order.isBefore(one, other); });
    if (behind == moments->begin()) return std::optional<KeptWorkpiece>();
    Result<KeptWorkpiece> kept = project.keptWorkpiece(*std::prev(behind));
    if (!kept) return std::move(kept).error();
    return std::optional(std::move(*kept));
}

} // namespace

Result<RecordedCuts> cutsOfTake(const Project& project, const TakeInfo& info, const SampleVisitor& also) {
    const Result<TakeOutline> take = project.takeOutline(info.id);
    if (!take) return take.error();
    Result<Tool> tool = toolFor(project, info.toolId);
    if (!tool) return std::move(tool).error();
    RecordedCuts cuts{info.id, std::move(*tool), {}, 0, info.sampleCount};
    CutFinder finder(take->undone);
    StrokeCounter counter(take->undone);
    const auto keep = [&cuts](const ToolPose& from, const ToolPose& to, std::uint64_t sample) -> Result<void> {
        cuts.motions.add(from, to, sample);
        return {};
    };
    Result<void> read = project.visitSamples(info.id, [&](std::span<const Sample> samples) -> Result<void> {
        counter.add(samples);
        if (Result<void> done = also ? also(samples) : Result<void>(); !done) return done;
        return finder.find(samples, keep);
    });
    if (!read) return std::move(read).error();
    cuts.strokes = counter.strokes();
    return cuts;
}

Result<RecordedWork> recordedWork(const Project& project, bool fromKept) {
    return recordedWork(project, {std::numeric_limits<std::int64_t>::max(), 0}, fromKept);
}

Result<RecordedWork> recordedWork(const Project& project, const TakeMoment& until, bool fromKept,
                                  const SampleVisitor& also) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const Result<TakeOrder> order = project.takeOrder();
    if (!order) return order.error();
    const std::size_t last = order->placeOf(until.take);
    RecordedWork work;
    if (fromKept) {
        Result<std::optional<KeptWorkpiece>> kept = newestKept(project, *order, until);
        if (!kept) return std::move(kept).error();
        work.kept = std::move(*kept);
    }
    if (work.kept) work.strokes = work.kept->strokes;
    for (const TakeInfo& info : *takes) {
        if (order->placeOf(info.id) > last) break;
        work.end = {info.id, info.id == until.take ? std::min(until.samples, info.sampleCount) : info.sampleCount};
        if (work.kept && !order->isBefore(work.kept->at, work.end)) continue;
        Result<RecordedCuts> cuts = cutsOfTake(project, info, also);
        if (!cuts) return std::move(cuts).error();
        if (work.kept && info.id == work.kept->at.take) cuts->done = cuts->motions.countWithin(work.kept->at.samples);
        cuts->end = cuts->motions.countWithin(work.end.samples);
        work.strokes[info.id] = cuts->strokes;
        work.cuts.push_back(std::move(*cuts));
    }
    return work;
}

Result<void> replayTake(const Take& take, const Tool& tool, MillingContext& milling, const Progress& progress) {
    CutReplay replay(tool, milling.embedded.workpiece);
    CutFinder finder(take.undone);
    if (Result<void> cut = finder.find(take.samples, cutAgain(replay, progress)); !cut) return cut;
    return replay.finish();
}

Result<RunVolume> workpieceOf(const RecordedWork& work, const std::function<Result<RunVolume>()>& stock,
                              Progress& progress, const std::optional<VolumeKind>& like) {
    Result<RunVolume> workpiece = work.kept ? volumeOf(*work.kept, progress) : stock();
    if (!workpiece) return workpiece;
    if (work.kept && like &&
        !(alike(workpiece->grid(), like->grid) && alike(workpiece->properties(), like->properties)))
        return Error{ErrorCode::fileDamaged, "workpiece", "kept_workpiece", "of another stock"};
    ReplayedShare share(progress);
    for (const RecordedCuts& take : work.cuts) share.expect(std::min(take.end, take.motions.count()) - take.done);
    for (const RecordedCuts& take : work.cuts) {
        CutReplay replay(take.tool, *workpiece);
        const CutFinder::Use cut = cutAgain(replay, progress);
        Result<void> done = take.motions.visit(take.done, take.end,
                                               [&](const ToolPose& from, const ToolPose& to, std::uint64_t sample) {
                                                   share.did(1);
                                                   return cut(from, to, sample);
                                               });
        if (done) done = replay.finish();
        if (!done) return std::move(done).error();
    }
    progress.report(1.0);
    return workpiece;
}

Result<void> replayTakes(const RecordedWork& work, MillingContext& milling, Progress& progress) {
    const VolumeKind like{milling.embedded.workpiece.grid(), milling.embedded.workpiece.properties()};
    Result<RunVolume> workpiece = workpieceOf(
        work, [&] { return Result<RunVolume>(std::move(milling.embedded.workpiece)); }, progress, like);
    if (!workpiece) return std::move(workpiece).error();
    milling.embedded.workpiece = std::move(*workpiece);
    return {};
}

Result<void> replayTakes(const Project& project, MillingContext& milling, Progress& progress) {
    const Result<RecordedWork> work = recordedWork(project);
    if (!work) return work.error();
    Result<void> replayed = replayTakes(*work, milling, progress);
    if (replayed || !work->kept || replayed.error().code != ErrorCode::fileDamaged) return replayed;
    const Result<RecordedWork> all = recordedWork(project, false); // only the kept workpiece is damaged
    if (!all) return all.error();
    return replayTakes(*all, milling, progress);
}

Result<KeptWorkpiece> keptAs(const VolumeSnapshot& workpiece, const TakeMoment& at,
                             const std::map<std::int64_t, std::size_t>& strokes, Progress& progress) {
    std::ostringstream stream;
    if (Result<void> written = writeVolume(stream, "workpiece", workpiece, progress); !written)
        return std::move(written).error();
    return KeptWorkpiece{at, strokes, std::move(stream).str()};
}

Result<RunVolume> volumeOf(const KeptWorkpiece& kept, Progress& progress) {
    std::istringstream stream(kept.volume);
    Result<VolumeFileContent> content = readVolume(stream, "workpiece", progress);
    if (!content) return std::move(content).error();
    if (std::optional<Error> damage = content->damage()) return std::move(*damage);
    return std::move(content->volume);
}

} // namespace burin
