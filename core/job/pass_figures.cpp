// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/pass_figures.h"

#include "core/document/project.h"
#include "core/job/milled_stock.h"
#include "core/passes/pass_request.h"
#include "core/path/engagement_record.h"
#include "core/path/path_source.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace burin {

namespace {

constexpr double sampling = 0.5; // mm, resolution

/// Adds up the intervals of one pass.
class Sum {
public:
    void add(const MetInterval& interval, double feed) {
        figures_.length += interval.length;
        if (feed > 0.0) figures_.duration += 60.0 * interval.length / feed; // mm/min
        const double removed = std::accumulate(interval.removed.begin(), interval.removed.end(), 0.0,
                                               [](double sum, const MaterialVolume& one) { return sum + one.volume; });
        figures_.removed += removed;
        if (removed > 0.0)
            met_.emplace_back(interval.engagement.arc, interval.length);
        else
            air_ += interval.length;
    }
    PassFigures figures(std::int64_t pass) {
        figures_.pass = pass;
        figures_.airShare = figures_.length > 0.0 ? air_ / figures_.length : 0.0;
        std::ranges::sort(met_);
        if (met_.empty()) return figures_;
        figures_.engagementMost = met_.back().first;
        double within = 0.0;
        for (const auto& [arc, length] : met_) {
            within += length;
            figures_.engagement95 = arc;
            if (within >= 0.95 * (figures_.length - air_)) break;
        }
        return figures_;
    }

private:
    PassFigures figures_;
    double air_ = 0.0;                           // mm
    std::vector<std::pair<double, double>> met_; // engagement, rad, and length, mm
};

/// Returns the requests of passes, by their ids. Errors: those of Project::generated.
Result<std::map<std::int64_t, PassRequest>> requestsOf(const Project& project) {
    const Result<std::vector<GeneratedInfo>> all = project.generated();
    if (!all) return all.error();
    std::map<std::int64_t, PassRequest> requests;
    for (const GeneratedInfo& pass : *all)
        if (const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name))
            requests.emplace(pass.id, *request);
    return requests;
}

bool comesToThePart(PassKind kind) noexcept {
    return !isInHoles(kind) && kind != PassKind::engrave;
}

/// Adds the stock left after each pass and all preceding ones have been milled.
void addStockLeft(std::vector<PassFigures>& figures, const FigureMatter& matter, const std::vector<PathPoint>& points,
                  const MillingContext& milling, const Progress& progress) {
    if (milling.part.bounds().empty()) return;
    StockLeftMeter meter(milling.part, milling.setup.stock);
    for (const MilledPath& each : matter.before) {
        const std::vector<PathPoint>& way = each.evaluated->path.points;
        if (!way.empty()) meter.sweep(way, 1, way.size() - 1, each.tool, progress);
    }
    std::size_t swept = 1;
    for (PassFigures& each : figures) {
        std::size_t last = 0;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].source == each.pass) last = i;
        if (last >= swept) meter.sweep(points, swept, last, milling.tool, progress);
        swept = std::max(swept, last + 1);
        const auto request = matter.requests.find(each.pass);
        if (request == matter.requests.end() || !comesToThePart(request->second.kind) || progress.cancelled()) continue;
        each.left = meter.leftBy(request->second, milling.tool, progress);
    }
}

} // namespace

Result<FigureMatter> figureMatter(const Project& project, const EvaluatedPath& evaluated) {
    FigureMatter matter;
    for (const std::shared_ptr<const EvaluatedPath>& each : evaluated.after) {
        Result<Tool> tool = toolFor(project, each->path.toolId);
        if (!tool) return std::move(tool).error();
        matter.before.push_back({each, std::move(*tool)});
    }
    Result<std::map<std::int64_t, PassRequest>> requests = requestsOf(project);
    if (!requests) return std::move(requests).error();
    matter.requests = std::move(*requests);
    return matter;
}

Result<std::vector<PassFigures>> passFigures(const FigureMatter& matter, const MillingContext& milling,
                                             const StoredPath& path, const EvaluatedPath& evaluated,
                                             Progress& progress) {
    std::vector<PathSource> passes = path.sources;
    std::erase_if(passes, [](const PathSource& source) { return !source.isGenerated(); });
    if (passes.empty()) return std::vector<PassFigures>{};
    std::vector<MetInterval> record;
    const auto cut = [&](RunVolume& stock) -> Result<void> {
        Result<std::vector<MetInterval>> met =
            recordEngagement(evaluated.path.points, milling.tool, stock, sampling, progress);
        if (!met) return std::move(met).error();
        record = std::move(*met);
        return {};
    };
    if (Result<void> lent = milling.stock->lend(matter.before, cut, progress); !lent) return std::move(lent).error();
    std::vector<PassFigures> figures;
    for (const PathSource& pass : passes) {
        Sum sum;
        for (const MetInterval& interval : record)
            if (const PathPoint& point = evaluated.path.points[interval.move]; point.source == pass.id)
                sum.add(interval, point.feed);
        figures.push_back(sum.figures(pass.id));
    }
    addStockLeft(figures, matter, evaluated.path.points, milling, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
    return figures;
}

} // namespace burin
