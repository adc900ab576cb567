// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Strokes, areas and guides that the user draws for the path.
#include "core/path/hand_interval.h"
#include "ui/window/path_scene_presenter.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::string_view areaKey = "outline_mm";

std::vector<glm::dvec3> closed(std::vector<glm::dvec3> outline) {
    if (!outline.empty()) outline.push_back(outline.front());
    return outline;
}

/// Identifies an edit of a path as long as it is not changed.
std::string keyOf(const StoredPath& path, std::size_t edit) {
    return std::to_string(path.id) + ' ' + std::to_string(edit) + ' ' + toJson(path.edits[edit]);
}

} // namespace

void PathScenePresenter::setDrawing(bool wanted) {
    field_.reset();
    startDrawing(wanted ? heightOf(workbench_.path.selection()) : std::nullopt);
}

void PathScenePresenter::setFieldDrawing(const DrawnField& field, bool wanted) {
    const StoredPath* path = workbench_.path.stored();
    if (!wanted || path == nullptr || field.edit >= path->edits.size()) {
        setDrawing(false);
        return;
    }
    field_ = field;
    drawnFor_ = keyOf(*path, field.edit);
    std::optional<SourceInterval> interval;
    for (const EditField& each : fieldsOf(path->edits[field.edit].parameters))
        if (const auto* meant = std::get_if<SourceInterval>(&each.value)) interval = *meant;
    startDrawing(heightOf(interval));
}

void PathScenePresenter::toggleLastDrawing() {
    const StoredPath* path = workbench_.path.stored();
    const std::optional<DrawnField> last = path != nullptr ? lastDrawn(path->edits) : std::nullopt;
    if (last) setFieldDrawing(*last, field_ != last);
}

void PathScenePresenter::startDrawing(std::optional<double> height) {
    drawing_ = height.has_value();
    if (!drawing_) field_.reset();
    drawn_.clear();
    hand_.setDrawing(height);
    if (drawing_) viewport_.setFocus(); // so that drawing receives Esc, wherever it was started
    emit changed();
}

/// Whether the selection or edit for which drawing was started still exists unchanged.
bool PathScenePresenter::stillMeant() const {
    if (!field_) return workbench_.path.selection().has_value();
    const StoredPath* path = workbench_.path.stored();
    return path != nullptr && field_->edit < path->edits.size() && keyOf(*path, field_->edit) == drawnFor_;
}

void PathScenePresenter::showDrawing(const std::vector<glm::dvec3>& places) {
    drawn_ = places;
    PlaceChains lines{drawsArea() ? closed(places) : places};
    const StoredPath* path = workbench_.path.stored();
    if (field_ && path != nullptr && field_->edit < path->edits.size()) {
        EditParameters parameters = path->edits[field_->edit].parameters;
        setDrawn(parameters, field_->key, places);
        if (const auto* mirror = std::get_if<Mirror>(&parameters)) lines.push_back(outlineOf(*mirror));
    }
    viewport_.setMoveMark(lines);
}

void PathScenePresenter::finishDrawing(const std::vector<glm::dvec3>& places) {
    const std::optional<DrawnField> field = stillMeant() ? field_ : std::nullopt;
    const bool lost = field_ && !field;
    setDrawing(false);
    if (lost) return;
    const StoredPath* path = workbench_.path.stored();
    if (!field) {
        workbench_.path.replaceSelection(asTheHandWent(places));
    } else if (path != nullptr && field->edit < path->edits.size()) {
        Edit edit = path->edits[field->edit];
        setDrawn(edit.parameters, field->key, places);
        workbench_.path.changeEdit(field->edit, edit);
    }
}

/// Reverses the drawing if its ends then match those of the selection better: drawing from right to left what the hand
/// milled from left to right should not add moves there and back.
std::vector<glm::dvec3> PathScenePresenter::asTheHandWent(std::vector<glm::dvec3> places) const {
    const PathPoint *first = nullptr, *last = nullptr;
    const std::vector<std::vector<PathPoint>> chosen = chosenPoints();
    for (const std::vector<PathPoint>& chain : chosen)
        for (const PathPoint& point : chain) {
            if (first == nullptr || point.sample < first->sample) first = &point;
            if (last == nullptr || point.sample > last->sample) last = &point;
        }
    if (first == nullptr || places.empty()) return places;
    const auto apart = [&](const glm::dvec3& begin, const glm::dvec3& end) {
        return glm::distance(begin, first->pose.tip) + glm::distance(end, last->pose.tip);
    };
    if (apart(places.back(), places.front()) < apart(places.front(), places.back())) std::ranges::reverse(places);
    return places;
}

bool PathScenePresenter::drawsArea() const {
    return field_ && field_->key == areaKey;
}

/// The intersection of the plane with the stock, slightly enlarged.
std::vector<glm::dvec3> PathScenePresenter::outlineOf(const Mirror& mirror) const {
    constexpr double beyond = 5.0; // mm
    const auto& milling = workbench_.workpiece.milling();
    if (!milling) return {};
    const Box box = milling->setup.stock.grown(beyond);
    const int along = mirror.across == Mirror::Across::x ? 1 : 0;
    std::vector<glm::dvec3> outline(4, glm::dvec3(mirror.at));
    for (std::size_t i = 0; i < outline.size(); ++i) {
        outline[i][along] = i == 1 || i == 2 ? box.high[along] : box.low[along];
        outline[i].z = i < 2 ? box.low.z : box.high.z;
    }
    return closed(outline);
}

/// Shows areas, mirrors and drawn guides.
void PathScenePresenter::showOutlines() {
    PlaceChains lines;
    if (active_ && workbench_.path.stored() != nullptr)
        for (const Edit& edit : workbench_.path.stored()->edits) {
            if (!edit.enabled || std::holds_alternative<ReplaceInterval>(edit.parameters)) continue;
            if (const auto* mirror = std::get_if<Mirror>(&edit.parameters)) lines.push_back(outlineOf(*mirror));
            for (const EditField& field : fieldsOf(edit.parameters))
                if (const auto* places = std::get_if<std::vector<glm::dvec3>>(&field.value))
                    lines.push_back(field.key == areaKey ? closed(*places) : *places);
        }
    viewport_.setOutlines(lines);
}

/// Height of the start of an interval of the path, or the middle height of all cutting moves.
std::optional<double> PathScenePresenter::heightOf(const std::optional<SourceInterval>& interval) const {
    if (!path_) return std::nullopt;
    const auto isUsable = [](const PathPoint& point) { return hasMoment(point) && point.kind != MoveKind::rapid; };
    if (interval && interval->source != 0)
        for (const std::vector<PathPoint>& chain : pointsOf(path_->path, *interval))
            if (const auto found = std::ranges::find_if(chain, isUsable); found != chain.end())
                return found->pose.tip.z;
    std::vector<double> heights;
    for (const PathPoint& point : path_->path.points)
        if (isUsable(point)) heights.push_back(point.pose.tip.z);
    if (heights.empty()) return std::nullopt;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return *middle;
}

} // namespace burin
