// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/pass_figures.h"

#include "core/document/project.h"
#include "core/job/milled_stock.h"
#include "core/path/engagement_record.h"
#include "core/path/path_source.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace burin {

namespace {

constexpr double sampling = 0.5; // mm, of what is told apart

/// Adds up what stretches of one pass met.
class Sum {
public:
    void add(const MetStretch& stretch, double feed) {
        figures_.length += stretch.length;
        if (feed > 0.0) figures_.duration += 60.0 * stretch.length / feed; // mm/min
        const double removed = std::accumulate(stretch.removed.begin(), stretch.removed.end(), 0.0,
                                               [](double sum, const MaterialVolume& one) { return sum + one.volume; });
        figures_.removed += removed;
        if (removed > 0.0)
            met_.emplace_back(stretch.engagement.arc, stretch.length);
        else
            air_ += stretch.length;
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
    std::vector<std::pair<double, double>> met_; // rad and mm
};

} // namespace

Result<std::vector<PassFigures>> passFigures(const Project& project, const MillingContext& milling,
                                             const StoredPath& path, const EvaluatedPath& evaluated,
                                             Progress& progress) {
    std::vector<PathSource> passes = path.sources;
    std::erase_if(passes, [](const PathSource& source) { return !source.isGenerated(); });
    if (passes.empty()) return std::vector<PassFigures>{};
    std::vector<MilledPath> before;
    for (const std::shared_ptr<const EvaluatedPath>& each : evaluated.after) {
        Result<Tool> tool = toolFor(project, each->path.toolId);
        if (!tool) return std::move(tool).error();
        before.push_back({each, std::move(*tool)});
    }
    std::vector<MetStretch> record;
    const auto cut = [&](RunVolume& stock) -> Result<void> {
        Result<std::vector<MetStretch>> met =
            recordEngagement(evaluated.path.points, milling.tool, stock, sampling, progress);
        if (!met) return std::move(met).error();
        record = std::move(*met);
        return {};
    };
    if (Result<void> lent = milling.stock->lend(before, cut, progress); !lent) return std::move(lent).error();
    std::vector<PassFigures> figures;
    for (const PathSource& pass : passes) {
        Sum sum;
        for (const MetStretch& stretch : record)
            if (const PathPoint& point = evaluated.path.points[stretch.move]; point.source == pass.id)
                sum.add(stretch, point.feed);
        figures.push_back(sum.figures(pass.id));
    }
    return figures;
}

} // namespace burin
