// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/kept_edits.h"

#include "core/machine/machine_library.h"
#include "core/path/hand_trail.h"
#include "core/path/stated_axes.h"
#include "core/path/stated_feeds.h"

#include <bit>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <utility>

namespace burin {

namespace {

void write(std::ostream& text, const CuttingConditions& conditions) {
    text << conditions.spindleSpeed << ' ' << conditions.feed << ' ' << conditions.plungeFeed << ' '
         << conditions.surfaceSpeed << ' ' << conditions.limitedByMachine << ' ' << conditions.rampAngle << ';';
}

void write(std::ostream& text, const glm::dvec3& place) {
    text << place.x << ' ' << place.y << ' ' << place.z << ';';
}

/// FNV-1a of all corners, word by word: bodies of different shape may have the same extent.
std::uint64_t digestOf(const MeshDistance& surface) {
    std::uint64_t digest = 14695981039346656037u;
    for (const Triangle& triangle : surface.triangles())
        for (const glm::dvec3& corner : triangle)
            for (int axis = 0; axis < 3; ++axis)
                digest = (digest ^ std::bit_cast<std::uint64_t>(corner[axis])) * 1099511628211u;
    return digest;
}

/// What can change in a context while its part and its stock stay the same, as text; obstacles by a digest of their
/// surface. Numbers are exact.
std::string contextText(const PathContext& context) {
    std::ostringstream text;
    text << std::hexfloat << toJson(context.tool) << ' ' << toJson(context.machine) << ' '
         << static_cast<int>(context.advisedCoolant) << ' ' << context.tickPeriod << ' ';
    write(text, context.conditions);
    for (const CuttingConditions& conditions : context.materialConditions) write(text, conditions);
    for (const glm::dvec3& place : {context.stock.low, context.stock.high, context.workOffset}) write(text, place);
    for (const ObstacleSolid& obstacle : context.obstacles)
        text << obstacle.on << ' ' << obstacle.margin << ' ' << digestOf(*obstacle.surface) << ' ';
    return text.str();
}

std::size_t bytesOf(const EditReport& report) noexcept {
    std::size_t bytes = sizeof(EditReport) + report.entries.size() * sizeof(StrokeEntry) +
                        report.inserted.size() * sizeof(glm::dvec3) + report.omissions.size() * sizeof(Omission);
    for (const Omission& part : report.omissions) bytes += part.line.size() * sizeof(glm::dvec3);
    return bytes;
}

/// Of a state alone, without what it shares with the others.
std::size_t bytesOf(const EditedState& state) noexcept {
    std::size_t bytes = state.path.points.size() * sizeof(PathPoint);
    for (const PathStroke& stroke : state.path.strokes)
        bytes += sizeof(PathStroke) + stroke.points.size() * sizeof(StrokePoint);
    for (const EditReport& report : state.reports) bytes += bytesOf(report);
    return bytes;
}

/// Of the sources' trails and stated values, which all states of a path share.
std::size_t sharedBytesOf(const EditedState& state) noexcept {
    return (state.path.hand ? state.path.hand->bytes() : 0) + (state.path.stated ? state.path.stated->bytes() : 0) +
           (state.path.axes ? state.path.axes->bytes() : 0);
}

} // namespace

void KeptEdits::begin(const std::vector<Edit>& edits, const PathContext& context) {
    std::vector<std::string> texts;
    for (const Edit& edit : edits) texts.push_back(toJson(edit));
    std::size_t same = 0;
    if (const std::string now = contextText(context); now == context_) {
        while (same < texts.size() && same < edits_.size() && texts[same] == edits_[same]) ++same;
    } else {
        context_ = now;
    }
    edits_ = std::move(texts);
    while (count() > same) {
        bytes_ -= bytesOf(newest());
        states_.erase(std::prev(states_.end()));
    }
}

void KeptEdits::keep(std::size_t count, const EditedState& state) {
    const std::size_t bytes = bytesOf(state), shared = sharedBytesOf(state);
    if (states_.contains(count) || shared + bytes > mostBytes) return;
    while (bytes_ + shared + bytes > mostBytes) {
        bytes_ -= bytesOf(states_.begin()->second);
        states_.erase(states_.begin());
    }
    states_.emplace(count, state);
    bytes_ += bytes;
}

std::size_t KeptEdits::bytes() const noexcept {
    return states_.empty() ? 0 : bytes_ + sharedBytesOf(newest());
}

} // namespace burin
