// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/pass_film.h"

#include "core/base/units.h"
#include "core/geometry/plan_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double drawnWithin = 1e-6;  // mm
constexpr double arrowsAcross = 12.0; // arrows along the diagonal of the rows

double lengthOfAll(const std::vector<TipLine>& lines) {
    double length = 0.0;
    for (const TipLine& line : lines) length += lengthOf(line);
    return length;
}

/// Draws the first `length` mm of lines that are drawn one after the other.
void draw(const std::vector<TipLine>& lines, double length, PassFilm::Picture& picture) {
    for (const TipLine& line : lines) {
        if (line.empty()) continue;
        TipLine drawn{line.front()};
        for (std::size_t i = 1; i < line.size() && length > 0.0; ++i) {
            const double piece = glm::distance(line[i - 1], line[i]);
            const double share = piece > length ? length / piece : 1.0;
            drawn.push_back(glm::mix(line[i - 1], line[i], share));
            length -= piece;
        }
        if (length >= -drawnWithin) ++picture.rows;
        picture.tip = drawn.back();
        picture.lines.push_back(std::move(drawn));
        if (length <= 0.0) return;
    }
}

double diagonalOf(const std::vector<TipLine>& lines) {
    Box box;
    for (const TipLine& line : lines)
        for (const glm::dvec3& place : line) box.include(place);
    return box.empty() ? 0.0 : glm::length(box.size());
}

/// An arrow that follows a line up to a point, with its head there.
TipLine arrow(TipLine shaft, double head) {
    const glm::dvec3 tip = shaft.back(), back = tip - shaft[shaft.size() - 2];
    const glm::dvec2 level(back);
    if (glm::length(level) == 0.0) return shaft;
    const glm::dvec2 along = head * glm::normalize(level), across(-along.y, along.x);
    shaft.push_back(tip + glm::dvec3(-along + 0.5 * across, 0.0));
    shaft.push_back(tip);
    shaft.push_back(tip + glm::dvec3(-along - 0.5 * across, 0.0));
    return shaft;
}

} // namespace

std::vector<TipLine> directionArrows(const std::vector<TipLine>& lines, double apart) {
    std::vector<TipLine> arrows;
    if (!(apart > 0.0)) return arrows;
    const double shaft = 0.5 * apart;
    for (const TipLine& line : lines) {
        double done = 0.0, next = 0.5 * apart; // mm along the line
        TipLine open;                          // the arrow that is being drawn
        for (std::size_t i = 1; i < line.size(); ++i) {
            const double piece = glm::distance(line[i - 1], line[i]);
            const auto at = [&](double way) { return glm::mix(line[i - 1], line[i], (way - done) / piece); };
            while (piece > 0.0 && (open.empty() ? next : next + shaft) <= done + piece) {
                if (open.empty()) {
                    open.push_back(at(next));
                    continue;
                }
                open.push_back(at(next + shaft));
                arrows.push_back(arrow(std::move(open), 0.2 * apart));
                open.clear();
                next += apart;
            }
            if (!open.empty() && glm::distance(open.back(), line[i]) > 0.0) open.push_back(line[i]);
            done += piece;
        }
    }
    return arrows;
}

PassFilm::PassFilm(std::vector<TipLine> leads, std::vector<TipLine> rows)
    : leads_(std::move(leads))
    , rows_(std::move(rows))
    , directions_(directionArrows(rows_, diagonalOf(rows_) / arrowsAcross)) {}

PassFilm::Picture PassFilm::at(double seconds) const {
    Picture picture;
    if (!leads_.empty()) {
        draw(leads_, lengthOfAll(leads_) * std::clamp(seconds / leadSeconds, 0.0, 1.0), picture);
        picture.rows = 0;
        seconds -= leadSeconds;
    }
    if (seconds < 0.0) return picture;
    picture.tip.reset();
    if (seconds < directionSeconds) {
        picture.lines.insert(picture.lines.end(), directions_.begin(), directions_.end());
        return picture;
    }
    draw(rows_, lengthOfAll(rows_) * std::min(1.0, (seconds - directionSeconds) / rowSeconds), picture);
    return picture;
}

PassRequest withSample(PassRequest request, const Box& part) {
    constexpr int points = 64;
    constexpr double waves = 0.15;      // of the part's width
    constexpr double sampleDepth = 0.5; // mm
    const glm::dvec3 size = part.size(), centre = part.centre();
    const bool follows =
        request.kind == PassKind::engrave || (request.kind == PassKind::flow && request.hand != HandStrokes::extend);
    if (follows && request.lines.empty()) {
        PassLine& line = request.lines.emplace_back();
        for (int i = 0; i <= points; ++i) {
            const double share = static_cast<double>(i) / points;
            line.emplace_back(part.low.x + share * size.x, centre.y + waves * size.y * std::sin(2.0 * pi * share),
                              part.high.z);
        }
    }
    if (request.kind == PassKind::engrave && request.depth == 0.0) request.depth = sampleDepth;
    if (request.area.empty() &&
        (request.kind == PassKind::pocket || (request.kind == PassKind::profile && request.inside)))
        request.area = rectangle(glm::dvec2(centre - 0.25 * size), glm::dvec2(centre + 0.25 * size));
    return request;
}

} // namespace burin
