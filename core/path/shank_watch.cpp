// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/shank_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// In voxels; less than the contact's own tolerance of a quarter.
constexpr double stepShare = 0.125, marginShare = 1.0 / 16.0;
constexpr double largestMargin = 0.02; // mm
/// In voxels, by which chords may leave an arc.
constexpr double chordShare = 0.02;

std::vector<RevolvedPiece> grownGuards(const Cutter& cutter, std::size_t fluteCount, double margin) {
    std::vector<RevolvedPiece> grown = pieces(cutter);
    double flutes = 0.0;
    for (std::size_t i = 0; i < fluteCount; ++i) flutes = std::max(flutes, grown[i].widestRadius());
    // A shank as wide as the flutes slides along the wall that they left.
    const auto wider = [&](double radius) {
        return radius > flutes ? radius + margin : std::max(radius, std::min(radius + margin, flutes - margin));
    };
    for (std::size_t i = fluteCount; i < grown.size(); ++i) {
        grown[i].bottom -= margin;
        grown[i].bottomRadius = wider(grown[i].bottomRadius);
        grown[i].topRadius = wider(grown[i].topRadius);
    }
    return grown;
}

/// The flutes and a column above them, slightly narrower than they are.
std::vector<RevolvedPiece> columnOf(const Cutter& cutter, double inset, double height) {
    std::vector<RevolvedPiece> column = flutePieces(cutter);
    const double least = std::min(inset, 0.2 * cutter.radius());
    double widest = 0.0;
    for (RevolvedPiece& piece : column) widest = std::max(widest, piece.widestRadius());
    if (column.size() == 1 && !column.front().bulges()) {
        RevolvedPiece& flutes = column.front();
        flutes.bottomRadius -= least;
        flutes.topRadius -= least;
        flutes.cornerRadius = std::min(flutes.cornerRadius, flutes.bottomRadius);
    }
    RevolvedPiece above;
    above.bottom = column.back().top;
    above.top = above.bottom + height;
    above.bottomRadius = above.topRadius = widest - least;
    column.push_back(above);
    return column;
}

double lowestOf(const std::vector<RevolvedPiece>& pieces, std::size_t first) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < pieces.size(); ++i) lowest = std::min(lowest, pieces[i].bottom);
    return lowest;
}

} // namespace

ShankWatch::ShankWatch(RunVolume& stock, const Cutter& cutter)
    : stock_(stock)
    , cutter_(cutter)
    , fluteCount_(flutePieces(cutter).size())
    , step_(stepShare * stock.grid().edge())
    , removal_(cutter, stock.grid(), Writing::deferred)
    , contact_(stock.grid()) {
    pieces_ = grownGuards(cutter, fluteCount_, std::min(largestMargin, marginShare * stock.grid().edge()));
    lowestGuard_ = lowestOf(pieces_, fluteCount_);
}

std::optional<ToolSection> ShankWatch::contactAt(const glm::dvec3& tip) {
    const ShankContact contact = contact_.at(stock_, pieces_, fluteCount_, ToolPose{tip}, removal_.window());
    if (!contact.touches) return std::nullopt;
    return sectionOf(cutter_, contact.piece);
}

double ShankWatch::depthAt(const glm::dvec3& tip, double most) {
    constexpr double resolution = 0.02; // mm
    std::vector<RevolvedPiece> column = columnOf(cutter_, 0.5 * stock_.grid().edge(), most);
    const auto meetsStock = [&](double lift) {
        return contact_.at(stock_, column, 0, ToolPose{tip + glm::dvec3(0.0, 0.0, lift)}, removal_.window())
            .touchesStock;
    };
    if (!meetsStock(0.0)) return 0.0;
    double low = 0.0, high = most;
    while (high - low > resolution) {
        const double middle = 0.5 * (low + high);
        (meetsStock(middle) ? low : high) = middle;
    }
    return high;
}

std::optional<ToolSection> ShankWatch::cutClear(const glm::dvec3& from, const glm::dvec3& to) {
    const auto count = static_cast<int>(std::max(1.0, std::ceil(glm::distance(from, to) / step_)));
    glm::dvec3 at = from;
    for (int i = 1; i <= count; ++i) {
        const glm::dvec3 next = glm::mix(from, to, static_cast<double>(i) / count);
        if (const auto touching = contactAt(next)) return touching;
        cut(at, next);
        at = next;
    }
    return std::nullopt;
}

ShankWatch::~ShankWatch() {
    settle(); // reserved memory is returned to the stock
}

void ShankWatch::settle() {
    outOfMemory_ = removal_.settle(stock_).outOfMemory || outOfMemory_;
}

void ShankWatch::cut(const glm::dvec3& from, const glm::dvec3& to) {
    const CutResult cut = removal_.cut(stock_, from, to);
    outOfMemory_ = cut.outOfMemory || outOfMemory_;
    if (cut.putOff) settle(); // queries between cuts have to see all of them
}

void ShankWatch::cut(const Arc& arc) {
    std::vector<glm::dvec3> ends;
    flatten(arc, chordShare * stock_.grid().edge(), ends);
    glm::dvec3 at = arc.from;
    for (const glm::dvec3& end : ends) {
        cut(at, end);
        at = end;
    }
}

void ShankWatch::keep() {
    settle();
    kept_ = stock_.snapshot();
}

void ShankWatch::goBack() {
    settle();
    removal_.reset();
    stock_.restore(kept_);
    contact_.forget();
}

} // namespace burin
