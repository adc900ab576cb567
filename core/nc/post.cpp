// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/post.h"

#include "core/base/numbers.h"
#include "core/geometry/arc.h"
#include "core/geometry/box.h"
#include "core/path/path_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

Error limitError(const std::string& what, double value, const std::string& limit, const char* unit) {
    return Error{ErrorCode::programLimit, what, formatFixed(value, 3) + " " + unit + ", limit " + limit, ""};
}

Result<void> checkSpindle(double speed, const MachineProfile& machine) {
    if (!std::isfinite(speed) || speed <= 0.0 || speed < machine.minimumSpindleSpeed)
        return limitError("spindle speed", speed, formatFixed(machine.minimumSpindleSpeed, 0), "1/min");
    if (speed > machine.maximumSpindleSpeed)
        return limitError("spindle speed", speed, formatFixed(machine.maximumSpindleSpeed, 0), "1/min");
    return {};
}

Result<void> checkFeed(const PathPoint& point, std::size_t index, const MachineProfile& machine) {
    if (point.kind == MoveKind::rapid) return {};
    if (!std::isfinite(point.feed) || point.feed <= 0.0)
        return Error{ErrorCode::programLimit, "feed", "missing at point " + std::to_string(index), ""};
    if (point.feed > machine.maximumFeed)
        return limitError("feed", point.feed, formatFixed(machine.maximumFeed, 3), "mm/min");
    return {};
}

Result<void> checkTravel(const Box& reach, const MachineProfile& machine) {
    static constexpr std::array<const char*, 3> names{"X travel", "Y travel", "Z travel"};
    const glm::dvec3 size = reach.size();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(size[axis] <= machine.travel[axis]))
            return limitError(names[static_cast<std::size_t>(axis)], size[axis], formatFixed(machine.travel[axis], 3),
                              "mm");
    }
    return {};
}

/// A section that began with a feed move would plough through the unknown.
Result<void> checkPaths(const std::vector<Path>& paths, const PostRequest& request) {
    if (paths.empty()) return Error{ErrorCode::pathEmpty, request.programName, "", ""};
    for (const Path& path : paths) {
        if (path.points.empty()) return Error{ErrorCode::pathEmpty, path.name, "", ""};
        if (path.points.front().kind != MoveKind::rapid)
            return Error{ErrorCode::argumentInvalid, "path", path.name,
                         "has to begin with a rapid move; link it first"};
        const bool named =
            request.tools.empty() ? path.toolId == paths.front().toolId : request.tools.contains(path.toolId);
        if (!named) return Error{ErrorCode::argumentInvalid, "paths", path.name, "its tool has no number"};
    }
    return {};
}

PostTool toolOf(const Path& path, const PostRequest& request) {
    if (const auto found = request.tools.find(path.toolId); found != request.tools.end()) return found->second;
    return {request.toolNumber, request.toolName, SpindleDirection::clockwise};
}

/// The section of a path: the last one where it uses the same tool in the same way.
NcSection& sectionOf(NcProgram& program, const Path& path, const PostRequest& request) {
    const PostTool tool = toolOf(path, request);
    if (!program.sections.empty()) {
        NcSection& last = program.sections.back();
        if (last.toolNumber == tool.number && last.spindleSpeed == path.spindleSpeed &&
            last.direction == tool.direction && last.coolant == path.coolant)
            return last;
    }
    NcSection& section = program.sections.emplace_back();
    section.toolNumber = tool.number;
    section.toolName = tool.name;
    section.spindleSpeed = path.spindleSpeed;
    section.direction = tool.direction;
    section.coolant = path.coolant;
    return section;
}

/// Says which moment of the hand, or which move of a planner, an interval comes from.
std::string originOf(const PathPoint& point) {
    const PathSource source{point.source};
    return nameOf(source) + (source.isTake() ? ", sample " : ", move ") + std::to_string(point.sample);
}

/// The box of an arc's path, by the quarters that it passes.
void includeArc(const NcMove& move, const glm::dvec3& from, Box& reach) {
    const Arc arc{from, move.target, move.arc.centre, move.arc.axis, move.arc.clockwise};
    constexpr int steps = 64; // outside by at most 0.12 % of the radius, far below what travel is known to
    const ArcTurn turn = turnOf(arc);
    for (int i = 1; i < steps; ++i) reach.include(placeOn(arc, turn, static_cast<double>(i) / steps));
}

Result<void> appendPath(NcProgram& program, const Path& path, const PostRequest& request, const MachineProfile& machine,
                        Box& reach) {
    NcSection& section = sectionOf(program, path, request);
    bool awaitsCut = true;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        if (!isFinite(point.pose.tip))
            return Error{ErrorCode::argumentInvalid, "path", path.name,
                         "point " + std::to_string(i) + " is not finite"};
        if (Result<void> feed = checkFeed(point, i, machine); !feed) return feed;
        NcMove move;
        move.kind = point.kind == MoveKind::rapid ? NcMoveKind::rapid : NcMoveKind::line;
        if (point.arc) {
            if (i == 0 || move.kind == NcMoveKind::rapid || !isFinite(point.arc->centre))
                return Error{ErrorCode::argumentInvalid, "path", path.name,
                             "point " + std::to_string(i) + " can't be the end of an arc"};
            move.kind = NcMoveKind::arc;
            move.arc = {point.arc->centre - request.workOffset, point.arc->axis, point.arc->clockwise};
        }
        move.target = point.pose.tip - request.workOffset;
        move.feed = point.kind == MoveKind::rapid ? 0.0 : point.feed;
        move.take = point.source;
        move.sample = point.sample;
        if (point.kind == MoveKind::rapid) awaitsCut = true;
        if (awaitsCut && point.kind == MoveKind::cut && point.sample >= 0) {
            move.comment = originOf(point);
            awaitsCut = false;
        }
        if (move.kind == NcMoveKind::arc) includeArc(move, section.moves.back().target, reach);
        reach.include(move.target);
        section.moves.push_back(std::move(move));
    }
    return {};
}

/// Checks the length of each line and gathers them.
class TextSink final : public LineSink {
public:
    explicit TextSink(int maximumLineLength) : maximumLineLength_(maximumLineLength) {}

    Result<void> line(std::string_view text) override {
        ++count_;
        if (text.size() > static_cast<std::size_t>(std::max(maximumLineLength_, 0)))
            return Error{ErrorCode::programLimit, "length of line " + std::to_string(count_),
                         std::to_string(text.size()) + " characters, limit " + std::to_string(maximumLineLength_), ""};
        if (text.find_first_of("\r\n") != std::string_view::npos)
            return Error{ErrorCode::internalFault, "post-processor", "line " + std::to_string(count_), "line break"};
        content_.append(text);
        content_.push_back('\n');
        return {};
    }
    std::string take() { return std::move(content_); }

private:
    int maximumLineLength_;
    std::size_t count_ = 0;
    std::string content_;
};

} // namespace

Result<NcProgram> toProgram(const std::vector<Path>& paths, const PostRequest& request, const MachineProfile& machine) {
    if (Result<void> valid = checkPaths(paths, request); !valid) return valid.error();
    for (const Path& path : paths)
        if (Result<void> speed = checkSpindle(path.spindleSpeed, machine); !speed) return speed.error();
    NcProgram program;
    program.name = request.programName;
    program.header = request.header;
    program.units = request.units;
    program.workOffset = request.workOffsetNumber;
    program.safeHeight = request.safeHeight;
    program.blendTolerance = request.blendTolerance;
    Box reach;
    for (const Path& path : paths) {
        if (Result<void> done = appendPath(program, path, request, machine, reach); !done) return done.error();
    }
    // The heights that the dialect goes to by itself, before and after the moves.
    const double top = std::max(request.safeHeight, machine.toolChangeHeight);
    reach.include(glm::dvec3(reach.low.x, reach.low.y, top));
    if (Result<void> travel = checkTravel(reach, machine); !travel) return travel.error();
    return program;
}

Result<std::string> writeProgram(const NcProgram& program, const MachineProfile& machine, const PostProcessor& post,
                                 Progress& progress) {
    TextSink sink(machine.maximumLineLength);
    if (Result<void> written = post.write(program, machine, sink, progress); !written) return written.error();
    return sink.take();
}

} // namespace burin
