// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/edited_path.h"

#include "ui/scene/path_lines.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

constexpr double rapidDash = 2.0, plungeDash = 0.5; // mm; also the length of the gap after it
constexpr double mostDashes = 200.0;                // maximum for one move

void addDashes(std::vector<LineEnds>& lines, const glm::dvec3& from, const glm::dvec3& to, double dash) {
    const double periods = std::clamp(std::round(glm::distance(from, to) / (2.0 * dash)), 1.0, mostDashes);
    const auto at = [&](double period) { return glm::mix(from, to, std::min(1.0, period / (periods + 0.5))); };
    for (double period = 0.0; period < periods + 0.5; period += 1.0) lines.emplace_back(at(period), at(period + 0.5));
}

/// Adds a plunge: straight, or as the turns of a helix.
void addPlunge(std::vector<LineEnds>& lines, const glm::dvec3& from, const PathPoint& point) {
    std::vector<LineEnds> chords;
    addMove(chords, from, point);
    for (const auto& [start, end] : chords) addDashes(lines, start, end, plungeDash);
}

std::size_t indexOf(MoveKind kind) {
    return static_cast<std::size_t>(kind);
}

/// The omitted parts, each with a dot at its start, because some are too short to be visible as lines.
PlaceChains omissionsOf(const EvaluatedPath& path) {
    PlaceChains chains;
    for (const EditReport& report : path.reports)
        for (const Omission& part : report.omissions) {
            chains.push_back(part.line);
            chains.push_back({part.line.front()});
        }
    return chains;
}

} // namespace

EditedPath::EditedPath(vtkRenderer& renderer)
    : lines_{HaloedLines(renderer), HaloedLines(renderer), HaloedLines(renderer), HaloedLines(renderer),
             HaloedLines(renderer)}
    , omitted_(renderer) {}

void EditedPath::setPalette(const Palette& palette) {
    const auto colour = [&](std::size_t kind, const QColor& line) { lines_[kind].setColours(line, palette.pathHalo); };
    colour(indexOf(MoveKind::cut), palette.path);
    colour(conventional, palette.conventionalPath);
    colour(indexOf(MoveKind::rapid), palette.rapidPath);
    colour(indexOf(MoveKind::plunge), palette.plungePath);
    colour(indexOf(MoveKind::retract), palette.rapidPath);
    omitted_.setColours(palette.force, palette.pathHalo);
}

void EditedPath::setLineWidth(double screenPixels) {
    for (HaloedLines& lines : lines_) lines.setWidth(screenPixels);
    omitted_.setLineWidth(screenPixels);
}

void EditedPath::setPath(const EvaluatedPath& evaluated) {
    const Path& path = evaluated.path;
    std::array<std::vector<LineEnds>, kinds> lines;
    box_ = {};
    auto interval = evaluated.sides.begin();
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        while (interval != evaluated.sides.end() && interval->last < i) ++interval;
        const bool against = interval != evaluated.sides.end() && interval->first <= i &&
                             interval->side == MillingSide::conventional && point.kind == MoveKind::cut;
        box_.include(point.pose.tip);
        if (i == 0) continue;
        const glm::dvec3& from = path.points[i - 1].pose.tip;
        std::vector<LineEnds>& kind = lines[against ? conventional : indexOf(point.kind)];
        if (point.kind == MoveKind::rapid)
            addDashes(kind, from, point.pose.tip, rapidDash);
        else if (point.kind == MoveKind::plunge)
            addPlunge(kind, from, point);
        else
            addMove(kind, from, point);
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) lines_[kind].setLines(lineData(lines[kind]));
    omissions_ = omissionsOf(evaluated);
    for (const std::vector<glm::dvec3>& chain : omissions_)
        for (const glm::dvec3& point : chain) box_.include(point);
    empty_ = path.points.empty();
    setVisible(visible_);
}

void EditedPath::setFeedsHidden(bool hidden) {
    feedsHidden_ = hidden;
    setVisible(visible_);
}

void EditedPath::setVisible(bool visible) {
    visible_ = visible;
    for (std::size_t kind = 0; kind < kinds; ++kind)
        lines_[kind].setVisible(visible_ && !empty_ && (!feedsHidden_ || kind == indexOf(MoveKind::rapid)));
    omitted_.set(visible_ ? omissions_ : PlaceChains{});
}

} // namespace burin
