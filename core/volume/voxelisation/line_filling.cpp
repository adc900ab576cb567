// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/line_filling.h"

#include <algorithm>
#include <cstdlib>

namespace burin {

std::span<const InnerSpan> LineFilling::spans(std::span<const LineCrossing> crossings, LineIndex line,
                                              const OpenMesh* open, VoxelisationReport& report) {
    spans_.clear();
    std::int32_t winding = 0, least = 0, most = 0;
    std::size_t caps = 0;
    for (const LineCrossing crossing : crossings) {
        winding += crossing.turn();
        least = std::min(least, winding);
        most = std::max(most, winding);
        caps += crossing.cap() ? 1U : 0U;
    }
    if (crossings.front().position() < 0 || crossings.back().position() > static_cast<std::int32_t>(grid_.lineEnd()))
        ++report.clippedLines;
    const bool odd = (crossings.size() - caps) % 2 != 0;
    if (odd) ++report.linesWithOddCrossings;
    if (caps > 0)
        doubt(crossings, line, report.throughHoles);
    else if (winding != 0)
        doubt(crossings, line, report.turnedFaces);
    else if (least < 0)
        doubt(crossings, line, report.insideOut);
    if (winding == 0 && caps == 0 && std::max(most, -least) > 1) noteOverlaps(crossings, line, report.overlaps);

    constexpr std::size_t mostCapsToLookAt = 20'000;
    if (winding != 0)
        byParity(crossings);
    else if (caps > 0 && open->capCount() <= mostCapsToLookAt)
        throughHoles(crossings, line, *open);
    else
        byWinding(crossings);
    for (const InnerSpan& span : spans_) report.filledUnits += span.to - span.from;
    return spans_;
}

void LineFilling::byWinding(std::span<const LineCrossing> crossings) {
    std::int32_t winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].turn();
        if (winding != 0) add(crossings[i], crossings[i + 1]);
    }
}

void LineFilling::byParity(std::span<const LineCrossing> crossings) {
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) add(crossings[i], crossings[i + 1]);
}

void LineFilling::throughHoles(std::span<const LineCrossing> crossings, LineIndex line, const OpenMesh& open) {
    const glm::dvec2 centre = grid_.lineCentre(line);
    glm::dvec3 place(0.0);
    place[grid_.axisOfU()] = centre.x;
    place[grid_.axisOfV()] = centre.y;
    std::int32_t winding = 0; // of surface and caps together: an integer
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].turn();
        if (crossings[i].position() == crossings[i + 1].position()) continue;
        const double middle = 0.5 * (crossings[i].position() + crossings[i + 1].position());
        place[grid_.axisOfRuns()] = grid_.low()[grid_.axisOfRuns()] + grid_.edge() * middle / unitsPerVoxel;
        if (std::abs(winding - open.windingOfCaps(place)) > 0.5) add(crossings[i], crossings[i + 1]);
    }
}

void LineFilling::add(LineCrossing from, LineCrossing to) {
    const auto clamped = [&](std::int32_t position) {
        return static_cast<RunPosition>(std::clamp(position, 0, static_cast<std::int32_t>(grid_.lineEnd())));
    };
    const InnerSpan span{clamped(from.position()), clamped(to.position())};
    if (span.from == span.to) return;
    if (!spans_.empty() && spans_.back().to == span.from)
        spans_.back().to = span.to;
    else
        spans_.push_back(span);
}

/// For a line on which the winding numbers close. Shells that only touch wind twice around nothing, or around a
/// rounding error.
void LineFilling::noteOverlaps(std::span<const LineCrossing> crossings, LineIndex line, DoubtfulLines& overlaps) const {
    std::int32_t winding = 0;
    std::size_t first = 0;
    bool found = false;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const bool before = std::abs(winding) > 1;
        winding += crossings[i].turn();
        const bool after = std::abs(winding) > 1;
        if (after && !before) first = i;
        if (after || !before || crossings[i].position() - crossings[first].position() <= slit) continue;
        overlaps.place.include(placeOf(crossings.subspan(first, i - first + 1), line));
        found = true;
    }
    if (found) ++overlaps.count;
}

void LineFilling::doubt(std::span<const LineCrossing> crossings, LineIndex line, DoubtfulLines& doubtful) const {
    ++doubtful.count;
    doubtful.place.include(placeOf(crossings, line));
}

/// The box from the first crossing to the last, with the width of the line, mm.
Box LineFilling::placeOf(std::span<const LineCrossing> crossings, LineIndex line) const {
    Box box;
    const glm::dvec2 centre = grid_.lineCentre(line);
    for (const LineCrossing end : {crossings.front(), crossings.back()})
        for (const double side : {-0.5, 0.5}) {
            glm::dvec3 place(0.0);
            place[grid_.axisOfU()] = centre.x + side * grid_.edge();
            place[grid_.axisOfV()] = centre.y + side * grid_.edge();
            place[grid_.axisOfRuns()] = grid_.toMillimetres(
                static_cast<RunPosition>(std::clamp(end.position(), 0, static_cast<std::int32_t>(grid_.lineEnd()))));
            box.include(place);
        }
    return box;
}

void appendPainted(std::span<const Segment> present, std::span<const InnerSpan> spans, PropertyIndex property,
                   BrickLines& lines, RunAmounts& replaced) {
    std::size_t i = 0;
    RunPosition reached = 0; // everything before it has been appended
    for (const InnerSpan& span : spans) {
        for (; present[i].end() <= span.from; ++i) lines.append(present[i].end(), present[i].property());
        lines.append(span.from, present[i].property());
        for (reached = span.from; reached < span.to;) {
            const RunPosition end = std::min(present[i].end(), span.to);
            replaced.units[present[i].property()] += end - reached;
            reached = end;
            if (present[i].end() == end && i + 1 < present.size()) ++i;
        }
        lines.append(span.to, property);
    }
    for (; i < present.size(); ++i) lines.append(present[i].end(), present[i].property());
    lines.endLine();
}

} // namespace burin
