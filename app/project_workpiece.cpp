// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/project_workpiece.h"

#include "app/command.h"
#include "app/take_moment_argument.h"
#include "core/job/milling_context.h"
#include "core/job/recorded_cuts.h"

namespace burin {

Result<RunVolume> workpieceOf(const Project& project, const WorkpieceChoice& choice, CommandContext& context) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const Result<Tool> tool = toolFor(project, takes->empty() ? "ball-6" : takes->front().toolId);
    if (!tool) return tool.error();
    context.stage(BURIN_TEXT("Command", "Embedding"));
    Result<MillingContext> milling = makeMillingContext(project, *tool, {}, context.progress());
    if (!milling) return std::move(milling).error();
    if (choice.stock) return std::move(milling->embedded.workpiece);
    context.stage(BURIN_TEXT("Command", "Replaying the takes"));
    if (!choice.moment.empty()) {
        const Result<TakeMoment> moment = momentOf(project, choice.moment);
        if (!moment) return moment.error();
        const Result<RecordedWork> work = recordedWork(project, *moment);
        if (!work) return work.error();
        if (Result<void> replayed = replayTakes(*work, *milling, context.progress()); !replayed)
            return std::move(replayed).error();
    } else if (Result<void> replayed = replayTakes(project, *milling, context.progress()); !replayed) {
        return std::move(replayed).error();
    }
    return std::move(milling->embedded.workpiece);
}

} // namespace burin
