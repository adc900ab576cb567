// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/pass_strokes.h"

#include "core/job/program_job.h"
#include "core/path/edit_step.h"
#include "core/path/evaluate.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {

namespace {

int countOf(const std::vector<PassLead>& leads) {
    int lines = 0;
    for (const PassLead& lead : leads) lines += lead.lines;
    return lines;
}

/// The edits that shape strokes: what links them and sets their feeds leaves their shape as it is.
std::vector<Edit> shapingEdits(const std::vector<Edit>& edits) {
    std::vector<Edit> shaping;
    for (const Edit& edit : edits)
        if (traitsOf(edit.parameters).step <= EditStep::surface) shaping.push_back(edit);
    return shaping;
}

} // namespace

Result<LeadLines> linesOfTake(const Project& project, std::int64_t take, KeptLeads& kept, Progress& progress) {
    Result<LeadTake> lead = readLead(project, take, kept, progress);
    if (!lead) return std::move(lead).error();
    return linesOf(std::move(*lead), kept, progress);
}

void leadBy(const std::vector<TakeLines>& takes, PassRequest& request) {
    std::vector<PassLine> lines;
    for (const TakeLines& each : takes) {
        request.leads.push_back({each.take, static_cast<int>(each.lines->size())});
        lines.insert(lines.end(), each.lines->begin(), each.lines->end());
    }
    request.lines.insert(request.lines.begin(), lines.begin(), lines.end());
}

Result<std::vector<LeadTake>> readLeads(const Project& project, const std::vector<std::int64_t>& takes,
                                        const KeptLeads& kept, const Progress& progress) {
    std::vector<LeadTake> leads;
    for (const std::int64_t take : takes) {
        Result<LeadTake> lead = readLead(project, take, kept, progress);
        if (!lead) return std::move(lead).error();
        leads.push_back(std::move(*lead));
    }
    return leads;
}

std::vector<std::int64_t> takesOf(const PassRequest& request) {
    std::vector<std::int64_t> takes;
    for (const PassLead& lead : request.leads) takes.push_back(lead.take);
    return takes;
}

Result<PassRequest> ledBy(PassRequest request, std::vector<LeadTake> leads, KeptLeads& kept, Progress& progress) {
    std::vector<TakeLines> takes;
    for (LeadTake& lead : leads) {
        const std::int64_t take = lead.take.info.id;
        Result<LeadLines> lines = linesOf(std::move(lead), kept, progress);
        if (!lines) return std::move(lines).error();
        takes.push_back({take, std::move(*lines)});
    }
    leadBy(takes, request);
    return request;
}

Result<PassRequest> ledAnew(PassRequest request, std::vector<LeadTake> leads, KeptLeads& kept, Progress& progress) {
    request.lines.erase(request.lines.begin(), request.lines.begin() + countOf(request.leads));
    request.leads.clear();
    return ledBy(std::move(request), std::move(leads), kept, progress);
}

Result<std::vector<TipLine>> handStrokes(std::vector<SourceStrokes> sources, const StoredPath& path,
                                         const MillingContext& milling, Progress& progress) {
    std::erase_if(sources, [](const SourceStrokes& each) { return !each.info.source.isTake(); });
    if (sources.empty()) return std::vector<TipLine>{};
    PathContext context;
    context.part = &milling.part;
    context.tool = milling.tool;
    context.conditions = milling.conditions;
    context.machine = milling.machine;
    context.stock = milling.setup.stock;
    context.obstacles = solidsOf(milling.surroundings());
    context.workOffset = milling.setup.workOffset;
    if (sources.front().info.tickPeriod > 0.0) context.tickPeriod = sources.front().info.tickPeriod;
    const Result<EvaluatedPath> shaped =
        evaluate(path.name, std::move(sources), shapingEdits(path.edits), context, progress);
    const bool nothingLeft = !shaped && (shaped.error().code == ErrorCode::pathEmpty ||
                                         shaped.error().code == ErrorCode::pathGouges); // all left out by an edit
    if (nothingLeft) return std::vector<TipLine>{};
    if (!shaped) return shaped.error();
    std::vector<TipLine> strokes;
    for (const PathPoint& point : shaped->path.points) {
        if (point.kind == MoveKind::rapid || strokes.empty()) strokes.emplace_back();
        strokes.back().push_back(point.pose.tip);
    }
    std::erase_if(strokes, [](const TipLine& stroke) { return stroke.size() < 2; });
    return strokes;
}

std::string digestOf(const std::vector<TipLine>& strokes) {
    constexpr double unit = 1e-6;                 // mm
    std::uint64_t digest = 14695981039346656037u; // FNV-1a
    const auto add = [&digest](std::uint64_t value) {
        for (int byte = 0; byte < 8; ++byte) {
            digest ^= (value >> (8 * byte)) & 255u;
            digest *= 1099511628211u;
        }
    };
    for (const TipLine& stroke : strokes) {
        add(stroke.size());
        for (const glm::dvec3& tip : stroke)
            for (int axis = 0; axis < 3; ++axis) add(static_cast<std::uint64_t>(std::llround(tip[axis] / unit)));
    }
    std::string text(16, '0');
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = "0123456789abcdef"[(digest >> (60 - 4 * i)) & 15u];
    return text;
}

Result<LedPasses> ledPasses(const Project& project, const StoredPath& path, const KeptLeads& kept, Progress& progress) {
    const Result<std::vector<GeneratedInfo>> passes = project.generated();
    if (!passes) return passes.error();
    LedPasses led{{}, path};
    StoredPath before = path; // its takes up to a pass
    before.sources.clear();
    for (const PathSource source : path.sources) {
        if (source.isTake()) before.sources.push_back(source);
        const auto info = std::ranges::find(*passes, source.id, &GeneratedInfo::id);
        if (info == passes->end() || info->request.empty()) continue;
        Result<PassRequest> request = passRequestFromJson(info->request, info->name);
        if (!request || (request->leads.empty() && request->hand == HandStrokes::ignore)) continue;
        LedPasses::Pass pass{info->id, std::move(*request), {}, false, {}, {}};
        pass.digest = pass.request.strokesDigest;
        Result<std::vector<LeadTake>> leads = readLeads(project, takesOf(pass.request), kept, progress);
        if (!leads && leads.error().code == ErrorCode::cancelled) return std::move(leads).error();
        pass.leadGone = !leads;
        if (leads) pass.leads = std::move(*leads);
        if (pass.request.hand != HandStrokes::ignore && !before.sources.empty()) {
            Result<std::vector<SourceStrokes>> strokes = strokesOf(project, before);
            if (!strokes) return std::move(strokes).error();
            pass.before = std::move(*strokes);
        }
        led.passes.push_back(std::move(pass));
    }
    return led;
}

Result<std::vector<std::int64_t>> outdatedPasses(LedPasses led, const MillingContext& milling, KeptLeads& kept,
                                                 Progress& progress) {
    std::vector<std::int64_t> outdated;
    for (LedPasses::Pass& pass : led.passes) {
        const Result<PassRequest> anew = ledAnew(pass.request, std::move(pass.leads), kept, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, led.path.name, {}, {}};
        bool changed = pass.leadGone || !anew || anew->lines != pass.request.lines; // also if a take has become empty
        if (!changed && !pass.digest.empty()) {
            const Result<std::vector<TipLine>> strokes =
                handStrokes(std::move(pass.before), led.path, milling, progress);
            if (!strokes) return strokes.error();
            changed = digestOf(*strokes) != pass.digest;
        }
        if (changed) outdated.push_back(pass.id);
    }
    return outdated;
}

} // namespace burin
