// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/lead_lines.h"

#include "core/job/program_job.h"
#include "core/path/evaluate.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace burin {

namespace {

/// Whether both have the same strokes: samples never change, only which of them count.
bool haveSameStrokes(const TakeOutline& one, const TakeOutline& other) {
    const auto recording = [](const TakeInfo& info) {
        return std::tie(info.id, info.toolId, info.tickPeriod, info.startedUnixTime, info.sampleCount, info.complete,
                        info.copyOf);
    };
    return recording(one.info) == recording(other.info) && one.undone == other.undone;
}

} // namespace

LeadLines KeptLeads::find(const TakeOutline& take) const {
    const std::lock_guard lock(mutex_);
    const auto kept = kept_.find(take.info.id);
    return kept != kept_.end() && haveSameStrokes(kept->second.take, take) ? kept->second.lines : nullptr;
}

void KeptLeads::keep(const TakeOutline& take, LeadLines lines) {
    const std::lock_guard lock(mutex_);
    kept_.insert_or_assign(take.info.id, Kept{take, std::move(lines)});
}

void KeptLeads::forget() {
    const std::lock_guard lock(mutex_);
    kept_.clear();
}

Result<LeadTake> readLead(const Project& project, std::int64_t take, const KeptLeads& kept, const Progress& progress) {
    Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return std::move(outline).error();
    Result<Tool> tool = toolFor(project, outline->info.toolId);
    if (!tool) return std::move(tool).error();
    LeadTake lead{std::move(*outline), std::move(*tool)};
    lead.lines = kept.find(lead.take);
    if (lead.lines) return lead;
    StrokeReader reader(lead.take);
    Result<void> read = project.visitSamples(take, [&](std::span<const Sample> part) -> Result<void> {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, lead.take.info.name, {}, {}};
        return reader.add(part);
    });
    if (!read) return std::move(read).error();
    lead.strokes = reader.finish();
    return lead;
}

Result<LeadLines> linesOf(LeadTake lead, KeptLeads& kept, Progress& progress) {
    if (lead.lines) return std::move(lead.lines);
    constexpr double tremor = 6.0, follows = 0.2, apart = 0.2; // mm
    const std::vector<Edit> edits{{DropDwells{}}, {SmoothShape{tremor, follows}}};
    PathContext context;
    context.tool = lead.tool;
    const std::string& name = lead.take.info.name;
    std::vector<SourceStrokes> sources;
    sources.push_back(std::move(lead.strokes));
    const Result<EvaluatedPath> path = evaluate(name, std::move(sources), edits, context, progress);
    if (!path) return path.error();
    std::vector<PassLine> lines;
    for (const PathPoint& point : path->path.points) {
        if (point.kind == MoveKind::rapid || lines.empty()) lines.emplace_back();
        if (lines.back().empty() || glm::distance(lines.back().back(), point.pose.tip) >= apart)
            lines.back().push_back(point.pose.tip);
    }
    std::erase_if(lines, [](const PassLine& line) { return line.size() < 2; });
    if (lines.empty()) return Error{ErrorCode::pathEmpty, name, "", "it has no stroke"};
    auto made = std::make_shared<const std::vector<PassLine>>(std::move(lines));
    kept.keep(lead.take, made);
    return LeadLines(std::move(made));
}

} // namespace burin
