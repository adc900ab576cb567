// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/path_report.h"

#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/passes/pass_request.h"
#include "core/path/edit.h"

#include <algorithm>
#include <sstream>

namespace burin {

using nlohmann::json;

Result<std::vector<GeneratedInfo>> passesOf(const Project& project, const StoredPath& path) {
    const Result<std::vector<GeneratedInfo>> all = project.generated();
    if (!all) return all;
    std::vector<GeneratedInfo> passes;
    for (const PathSource source : path.sources)
        if (const auto found = std::ranges::find(*all, source.id, &GeneratedInfo::id); found != all->end())
            passes.push_back(*found);
    return passes;
}

namespace {

/// null if the pass has no request, or an invalid one.
json requestOf(const GeneratedInfo& pass) {
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    return request ? json::parse(toJson(*request)) : json();
}

/// Columns of the arc; empty for a straight move.
std::string arcColumns(const PathPoint& point) {
    if (!point.arc) return ",,,,,";
    std::string text;
    for (int axis = 0; axis < 3; ++axis) text += "," + formatShortest(point.arc->centre[axis]);
    constexpr const char* letters[] = {"x", "y", "z"};
    return text + "," + letters[point.arc->axis] + (point.arc->clockwise ? ",1" : ",0");
}

/// Returns empty columns for a rapid, as it has the speed and coolant of the next move.
std::string spindleColumns(const Path& path, const PathPoint& point) {
    if (point.kind == MoveKind::rapid) return ",,";
    return "," + formatShortest(speedOf(path, point)) + "," + std::string(idOf(coolantOf(path, point)));
}

} // namespace

json jsonOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes) {
    json edits = json::array(), made = json::array();
    for (const Edit& edit : path.edits) edits.push_back(json::parse(toJson(edit)));
    for (const GeneratedInfo& pass : passes)
        made.push_back({{"id", pass.id},
                        {"name", pass.name},
                        {"tool", pass.toolId},
                        {"points", pass.pointCount},
                        {"request", requestOf(pass)}});
    return {{"id", path.id}, {"name", path.name}, {"takes", takesOf(path.sources)}, {"passes", made}, {"edits", edits}};
}

std::string textOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes) {
    std::ostringstream text;
    std::string takes;
    for (const std::int64_t take : takesOf(path.sources)) takes += " " + std::to_string(take);
    const std::string id = std::to_string(path.id);
    text << (takes.empty() ? worded(BURIN_TEXT("Command", "path %1 %2"), {id, path.name})
                           : worded(BURIN_TEXT("Command", "path %1 %2, takes%3"), {id, path.name, takes}));
    for (const GeneratedInfo& pass : passes)
        text << "\n  " << nameOf(PathSource{pass.id}) << "  " << pass.name << ", " << pass.toolId << ", "
             << pass.pointCount << (pass.request.empty() ? "" : "  " + pass.request);
    for (std::size_t i = 0; i < path.edits.size(); ++i) text << "\n  " << i << "  " << toJson(path.edits[i]);
    return text.str();
}

Result<StoredPath> pathWithId(const Project& project, std::int64_t id) {
    const Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return paths.error();
    std::string known;
    for (const StoredPath& path : *paths) {
        if (path.id == id) return path;
        known += (known.empty() ? "" : ", ") + std::to_string(path.id);
    }
    return Error{ErrorCode::nameUnknown, "path", std::to_string(id), known};
}

void addFigures(const std::vector<PassFigures>& figures, json& passes) {
    for (json& pass : passes)
        for (const PassFigures& each : figures)
            if (pass["id"].get<std::int64_t>() == each.pass) {
                pass.update({{"length_mm", each.length},
                             {"time_s", each.duration},
                             {"air_share", each.airShare},
                             {"removed_mm3", each.removed},
                             {"engagement_95_rad", each.engagement95},
                             {"engagement_most_rad", each.engagementMost}});
                pass["left_over"] = each.left ? json{{"reachable_mm2", each.left->reachable},
                                                     {"within_99_percent_mm", each.left->within99},
                                                     {"most_mm", each.left->most}}
                                              : json();
            }
}

namespace {

std::string textOfLeft(const PassFigures& pass) {
    if (!pass.left || pass.left->reachable == 0.0) return {};
    return worded(BURIN_TEXT("Command", "; stock left on 99 % of the reachable part: at most %1 mm (most: %2 mm)"),
                  {formatFixed(pass.left->within99, 3), formatFixed(pass.left->most, 3)});
}

} // namespace

std::string textOf(const std::vector<PassFigures>& figures) {
    std::string text;
    for (const PassFigures& each : figures)
        text += "\n  " +
                worded(BURIN_TEXT("Command", "pass %1: %2 mm in %3 s, %4 % of it in air; %5 mm³ removed; "
                                             "engagement within %6° for 95 % of the cut, at most %7°"),
                       {std::to_string(each.pass), formatFixed(each.length, 0), formatFixed(each.duration, 0),
                        formatFixed(100.0 * each.airShare, 1), formatFixed(each.removed, 0),
                        formatFixed(glm::degrees(each.engagement95), 0),
                        formatFixed(glm::degrees(each.engagementMost), 0)}) +
                textOfLeft(each);
    return text;
}

void addOutdated(const std::vector<std::int64_t>& outdated, json& passes) {
    for (json& pass : passes)
        pass["out_of_date"] = std::ranges::find(outdated, pass["id"].get<std::int64_t>()) != outdated.end();
}

std::string textOfOutdated(const std::vector<std::int64_t>& outdated) {
    std::string text;
    for (const std::int64_t pass : outdated)
        text += "\n  " +
                worded(BURIN_TEXT("Command", "pass %1 is out of date: hand strokes that it depends on have changed. "
                                             "Compute it again with \"recompute --outdated\"."),
                       {std::to_string(pass)});
    return text;
}

static int answer(const StoredPath& path, const std::vector<GeneratedInfo>& passes, CommandContext& context,
                  json further, const std::string& furtherText) {
    further.update(jsonOf(path, passes));
    context.answer(further, textOf(path, passes) + furtherText);
    return 0;
}

int saveAndAnswer(ProjectChange& project, const StoredPath& path, CommandContext& context, json further,
                  const std::string& furtherText) {
    const Result<std::vector<GeneratedInfo>> passes = passesOf(*project, path);
    if (!passes) return context.fail(passes.error()); // before anything is saved
    if (const Result<void> saved = project.save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, *project);
    return answer(path, *passes, context, std::move(further), furtherText);
}

int answerUnchanged(const Project& project, const StoredPath& path, CommandContext& context, json further,
                    const std::string& furtherText) {
    const Result<std::vector<GeneratedInfo>> passes = passesOf(project, path);
    if (!passes) return context.fail(passes.error());
    return answer(path, *passes, context, std::move(further), furtherText);
}

std::string csvOf(const Path& path) {
    constexpr const char* kinds[] = {"rapid", "plunge", "cut", "retract"};
    std::string text = "kind,x_mm,y_mm,z_mm,feed_mm_min,take,sample,"
                       "arc_centre_x_mm,arc_centre_y_mm,arc_centre_z_mm,arc_axis,arc_clockwise,spindle_rpm,coolant\n";
    for (const PathPoint& point : path.points) {
        text += kinds[static_cast<std::size_t>(point.kind)];
        for (int axis = 0; axis < 3; ++axis) text += "," + formatShortest(point.pose.tip[axis]);
        text += "," + formatShortest(point.feed) + "," + std::to_string(point.source) + "," +
                std::to_string(point.sample) + arcColumns(point) + spindleColumns(path, point) + "\n";
    }
    return text;
}

} // namespace burin
