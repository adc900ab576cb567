// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/post.h"

#include "core/base/numbers.h"
#include "core/geometry/box.h"

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

/// One tool and one speed through all paths; a program that begins with a feed move would plough through the unknown.
Result<void> checkPaths(const std::vector<Path>& paths, const PostRequest& request) {
    if (paths.empty()) return Error{ErrorCode::pathEmpty, request.programName, "", ""};
    for (const Path& path : paths) {
        if (path.points.empty()) return Error{ErrorCode::pathEmpty, path.name, "", ""};
        if (path.points.front().kind != MoveKind::rapid)
            return Error{ErrorCode::argumentInvalid, "path", path.name,
                         "has to begin with a rapid move; link it first"};
        if (path.toolId != paths.front().toolId || path.spindleSpeed != paths.front().spindleSpeed)
            return Error{ErrorCode::argumentInvalid, "paths", path.name, "one tool and one spindle speed a program"};
    }
    return {};
}

/// Says which moment of the hand a stretch comes from.
std::string originOf(const PathPoint& point) {
    return "take " + std::to_string(point.take) + ", sample " + std::to_string(point.sample);
}

Result<void> appendPath(NcProgram& program, const Path& path, const PostRequest& request, const MachineProfile& machine,
                        Box& reach) {
    bool awaitsCut = true;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        if (!isFinite(point.tip))
            return Error{ErrorCode::argumentInvalid, "path", path.name,
                         "point " + std::to_string(i) + " is not finite"};
        if (Result<void> feed = checkFeed(point, i, machine); !feed) return feed;
        NcMove move;
        move.kind = point.kind == MoveKind::rapid ? NcMoveKind::rapid : NcMoveKind::line;
        move.target = point.tip - request.workOffset;
        move.feed = point.kind == MoveKind::rapid ? 0.0 : point.feed;
        move.take = point.take;
        move.sample = point.sample;
        if (point.kind == MoveKind::rapid) awaitsCut = true;
        if (awaitsCut && point.kind == MoveKind::cut && point.sample >= 0) {
            move.comment = originOf(point);
            awaitsCut = false;
        }
        reach.include(move.target);
        program.moves.push_back(std::move(move));
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
    if (Result<void> speed = checkSpindle(paths.front().spindleSpeed, machine); !speed) return speed.error();
    NcProgram program;
    program.name = request.programName;
    program.header = request.header;
    program.toolNumber = request.toolNumber;
    program.toolName = request.toolName;
    program.spindleSpeed = paths.front().spindleSpeed;
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
