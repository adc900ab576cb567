// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/linker.h"

#include "core/path/turn_room.h"

#include <algorithm>

namespace burin {
namespace {

/// The same arc, in the other direction.
std::optional<PathArc> turnedBack(std::optional<PathArc> arc) {
    if (arc) arc->clockwise = !arc->clockwise;
    return arc;
}

} // namespace

Linker::Linker(LinkRoom& room, const PartGuard& guard, const PathContext& context, const EntryPlanner& planner,
               ShankWatch* watch)
    : room_(room)
    , guard_(guard)
    , planner_(planner)
    , watch_(watch)
    , stockTop_(context.stock.high.z)
    , shortestKept_(shortestKept(context.tool.cutter.diameter)) {}

void Linker::add(const PathStroke& stroke, const StrokeAccess& access) {
    if (!access.found)
        leaveOut(stroke, OmissionReason::access);
    else if (mayTouch(stroke))
        addWatched(stroke, access);
    else if (const std::optional<Piece> piece = begin(stroke, access))
        append(*piece);
    else
        leaveOut(stroke, OmissionReason::plunge);
}

/// Starts a piece straight from the last point, or from above, after leaving the last stroke.
std::optional<Linker::Piece> Linker::begin(const PathStroke& stroke, const StrokeAccess& access) {
    Piece piece{&stroke, access, false, {}};
    const glm::dvec3& start = stroke.points.front().pose.tip;
    piece.joined = !mustLift_ && !points.empty() && back_.empty() &&
                   room_.canJoin(points.back().pose.tip, start, std::min(lastRequired_, stroke.required)) &&
                   !planner_.plunges(points.back().pose.tip, start) && !joinsWithBackStep(stroke);
    if (piece.joined) return piece;
    depart();
    enterFromAbove(piece);
    if (stepsBack(piece)) begunLonger(piece);
    const bool plunges = piece.entry && piece.entry->way.empty() && piece.entry->depth > 0.0;
    if (plunges && !planner_.mayPlunge()) return std::nullopt;
    return piece;
}

void Linker::enterFromAbove(Piece& piece) const {
    const PathStroke& stroke = *piece.stroke;
    piece.entry = planner_.into(stroke, piece.access.entry);
    if (piece.entry) piece.access.entry = piece.entry->point;
    if (piece.entry && !piece.entry->way.empty()) {
        piece.way = piece.entry->way;
        return;
    }
    piece.way = swingIn(stroke, piece.access.entry);
    // At the start of the stroke the material may be cleared, but not beside it.
    if (piece.way.size() > 1 && planner_.meetsMaterial(piece.way))
        piece.way.erase(piece.way.begin(), piece.way.end() - 1);
}

/// Whether the tool turns at the stroke's beginning without enough room.
bool Linker::stepsBack(const Piece& piece) const {
    if (piece.access.entry == 0) return piece.entry && piece.entry->stepsBack;
    const std::vector<StrokePoint>& corners = piece.stroke->points;
    return turnBeyond(corners[0].pose.tip, corners[1].pose.tip) && !turnAt(*piece.stroke, 0, 1);
}

/// Gives a piece a longer first move where that helps.
void Linker::begunLonger(Piece& piece) {
    Deviation deviation;
    const std::optional<PathStroke> longer = withLongStart(*piece.stroke, guard_, deviation);
    if (!longer) return;
    Piece other{&pieces_.emplace_back(*longer), accessOf(*longer, guard_, room_.safeHeight()), false, {}};
    other.longer = true;
    if (!other.access.found) return;
    enterFromAbove(other);
    if (stepsBack(other)) return;
    piece = std::move(other);
    leftOut.include(deviation);
}

/// Whether joining straight from the last point would make a back-step.
bool Linker::joinsWithBackStep(const PathStroke& stroke) const {
    std::vector<glm::dvec3> places;
    const auto add = [&](const glm::dvec3& place) {
        if (places.empty() || places.back() != place) places.push_back(place);
    };
    if (points.size() > 1 && !points.back().arc && points.back().kind == MoveKind::cut)
        add(points[points.size() - 2].pose.tip);
    add(points.back().pose.tip);
    add(stroke.points.front().pose.tip);
    if (stroke.points.size() > 1 && !stroke.points[1].arc) add(stroke.points[1].pose.tip);
    for (std::size_t i = 2; i < places.size(); ++i)
        if (isBackStep(places[i - 2], places[i - 1], places[i])) return true;
    return false;
}

void Linker::append(const Piece& piece) {
    const PathStroke& stroke = *piece.stroke;
    if (!piece.joined) {
        const glm::dvec3& entry = piece.way.front().pose.tip;
        travel(points.empty() ? LinkRoute{room_.safeHeight(), {}} : room_.wayTo(points.back().pose.tip, entry), entry);
        enter(piece);
    } else {
        cut(stroke, 0, {});
    }
    for (std::size_t i = 1; i < stroke.points.size(); ++i) cut(stroke, i, stroke.points[i].arc);
    for (std::size_t i = stroke.points.size() - 1; i > piece.access.exit; --i) back_.push_back({&stroke, i - 1});
    lastRequired_ = stroke.required;
    mustLift_ = false;
}

void Linker::leave() {
    if (points.empty()) return;
    depart();
    const glm::dvec3 tip = points.back().pose.tip;
    go(lift(room_.safeHeight()), MoveKind::retract);
    if (points.back().pose.tip.z < room_.safeHeight()) go({tip.x, tip.y, room_.safeHeight()}, MoveKind::rapid);
}

/// All moves are added here.
void Linker::make(const PathPoint& point) {
    if (watch_ != nullptr && !rehearsed_ && !points.empty() && point.kind != MoveKind::rapid) {
        const glm::dvec3& from = points.back().pose.tip;
        if (point.arc)
            watch_->cut(Arc{from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise});
        else
            watch_->cut(from, point.pose.tip);
    }
    points.push_back(point);
}

/// The point beyond an end of a stroke at which the tool turns to follow the stroke back.
std::optional<glm::dvec3> Linker::turnAt(const PathStroke& stroke, std::size_t end, std::size_t before) const {
    const glm::dvec3& tip = stroke.points[end].pose.tip;
    const std::optional<glm::dvec3> beyond = turnBeyond(tip, stroke.points[before].pose.tip);
    return beyond && guard_.isClear(tip, *beyond, stroke.required, defaultSampling) ? beyond : std::nullopt;
}

void Linker::turn(const PathStroke& stroke, std::size_t end, std::size_t before) {
    const std::optional<glm::dvec3> beyond = turnAt(stroke, end, before);
    if (!beyond) return;
    for (const glm::dvec3& place : {*beyond, stroke.points[end].pose.tip}) {
        clear(place, {});
        make({{place, uprightAxis}, MoveKind::cut, 0.0, stroke.source, stroke.points[end].sample});
    }
}

/// Goes to where the last stroke can be left, and leaves it tangentially.
void Linker::depart() {
    if (!back_.empty()) turn(*back_.front().first, back_.front().second + 1, back_.front().second);
    for (const auto& [stroke, index] : back_) cut(*stroke, index, turnedBack(stroke->points[index + 1].arc));
    back_.clear();
    swingOut();
}

/// From the end of a stroke on and up, at the feed.
void Linker::swingOut() {
    if (points.size() < 2 || points.back().kind != MoveKind::cut || points.back().arc) return;
    const glm::dvec3 tip = points.back().pose.tip;
    const std::vector<glm::dvec3> places = room_.swing(tip, tip - points[points.size() - 2].pose.tip, lastRequired_);
    for (std::size_t i = 1; i < places.size(); ++i) {
        room_.cleared().cut(places[i - 1], places[i]);
        go(places[i], MoveKind::retract);
    }
}

/// From above to the entry of a stroke; only the entry point if it is entered straight down.
std::vector<StrokePoint> Linker::swingIn(const PathStroke& stroke, std::size_t entry) const {
    const glm::dvec3& tip = stroke.points[entry].pose.tip;
    std::vector<glm::dvec3> places{tip};
    if (entry == 0 && stroke.points.size() > 1 && !stroke.points[1].arc)
        places = room_.swing(tip, tip - stroke.points[1].pose.tip, stroke.required);
    std::vector<StrokePoint> way(places.size());
    for (std::size_t i = 0; i < way.size(); ++i) way[way.size() - 1 - i].pose.tip = places[i];
    return way;
}

/// The end of the first, feed-controlled part of a retraction: `approach` up, and farther as long as the flutes cut.
glm::dvec3 Linker::lift(double height) const {
    const glm::dvec3& tip = points.back().pose.tip;
    return {tip.x, tip.y, std::min(std::max(tip.z + room_.approach(), room_.cleared().risenHeight(tip)), height)};
}

/// Up, across, and down as a rapid to `approach` above the remaining stock at an entry.
void Linker::travel(const LinkRoute& route, const glm::dvec3& entry) {
    std::vector<glm::dvec3> rapids;
    if (!points.empty()) {
        go(lift(route.height), MoveKind::retract);
        const glm::dvec3& tip = points.back().pose.tip;
        rapids.push_back(tip);
        if (tip.z < route.height) rapids.emplace_back(tip.x, tip.y, route.height);
    }
    for (const glm::dvec2& corner : route.corners) rapids.emplace_back(corner, route.height);
    rapids.emplace_back(entry.x, entry.y, route.height);
    const double free = std::max(room_.cleared().freeHeight(entry.x, entry.y) + room_.approach(), entry.z);
    if (free < route.height) rapids.emplace_back(entry.x, entry.y, free);
    const std::size_t first = points.empty() ? 0 : 1;
    if (room_.rounding() > 0.0) rapids = room_.rounded(rapids);
    for (std::size_t i = first; i < rapids.size(); ++i) go(rapids[i], MoveKind::rapid);
}

/// Cuts to a point of a stroke, along the arc or straight.
void Linker::cut(const PathStroke& stroke, std::size_t index, const std::optional<PathArc>& arc) {
    const StrokePoint& point = stroke.points[index];
    clear(point.pose.tip, arc);
    make({point.pose, MoveKind::cut, 0.0, stroke.source, point.sample, arc});
}

/// Records in the height map that the flutes go there.
void Linker::clear(const glm::dvec3& tip, const std::optional<PathArc>& arc) {
    const glm::dvec3 from = points.empty() ? tip : points.back().pose.tip;
    if (arc)
        room_.cleared().cut(Arc{from, tip, arc->centre, arc->axis, arc->clockwise});
    else
        room_.cleared().cut(from, tip);
}

/// Goes to the stroke's first point: straight down, or on the planned entry.
void Linker::enter(const Piece& piece) {
    const PathStroke& stroke = *piece.stroke;
    const StrokePoint& entry = stroke.points[piece.access.entry];
    for (const StrokePoint& point : piece.way) {
        clear(point.pose.tip, point.arc);
        make({point.pose, MoveKind::plunge, 0.0, stroke.source, entry.sample, point.arc});
    }
    if (piece.entry && piece.entry->depth > 0.0)
        entries.push_back({piece.entry->form, stroke.source, entry.sample, entry.pose.tip, piece.entry->depth});
    for (std::size_t i = piece.access.entry; i > 0; --i) cut(stroke, i - 1, turnedBack(stroke.points[i].arc));
    if (piece.access.entry > 0) turn(stroke, 0, 1);
}

} // namespace burin
