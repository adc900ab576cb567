// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/post.h"

#include "core/base/numbers.h"
#include "core/geometry/arc.h"
#include "core/machine/axis_travel.h"
#include "core/machine/kinematics.h"
#include "core/path/machine_check.h"
#include "core/path/path_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

Result<void> checkFeed(const PathPoint& point, std::size_t index, const MachineProfile& machine) {
    if (point.kind == MoveKind::rapid) return {};
    if (!std::isfinite(point.feed) || point.feed <= 0.0)
        return Error{ErrorCode::programLimit, "feed", "missing at point " + std::to_string(index), ""};
    if (point.feed > machine.maximumFeed)
        return limitError("feed", point.feed, formatFixed(machine.maximumFeed, 3), "mm/min");
    return {};
}

/// A section that began with a feed move would cut through unknown space.
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

/// Spindle speed and coolant in force.
struct CutState {
    double speed = 0.0; ///< 1/min
    Coolant coolant = Coolant::off;

    friend bool operator==(const CutState&, const CutState&) = default;
};

/// Returns the state of the next move other than a rapid; if there is none, that of the last such move of the path.
CutState stateFrom(const Path& path, std::size_t first) {
    const auto isFeed = [](const PathPoint& point) { return point.kind != MoveKind::rapid; };
    const auto of = [&](const PathPoint& point) { return CutState{speedOf(path, point), coolantOf(path, point)}; };
    const auto begin = path.points.begin() + static_cast<std::ptrdiff_t>(first);
    if (const auto next = std::find_if(begin, path.points.end(), isFeed); next != path.points.end()) return of(*next);
    const auto last = std::find_if(std::make_reverse_iterator(begin), path.points.rend(), isFeed);
    return last == path.points.rend() ? CutState{path.spindleSpeed, path.coolant} : of(*last);
}

CutState stateAtEnd(const NcSection& section) {
    CutState state{section.spindleSpeed, section.coolant};
    for (const NcMove& move : section.moves) {
        if (move.spindleSpeed > 0.0) state.speed = move.spindleSpeed;
        state.coolant = move.coolant.value_or(state.coolant);
    }
    return state;
}

/// The section of a path: the last one if it uses the same tool in the same way.
NcSection& sectionOf(NcProgram& program, const Path& path, const PostRequest& request) {
    const PostTool tool = toolOf(path, request);
    const CutState start = stateFrom(path, 0);
    if (!program.sections.empty()) {
        NcSection& last = program.sections.back();
        if (last.toolNumber == tool.number && last.direction == tool.direction && stateAtEnd(last) == start)
            return last;
    }
    NcSection& section = program.sections.emplace_back();
    section.toolNumber = tool.number;
    section.toolName = tool.name;
    section.spindleSpeed = start.speed;
    section.direction = tool.direction;
    section.coolant = start.coolant;
    return section;
}

/// Names the moment of the hand, or the move of a planner, that a part of the path comes from.
std::string originOf(const PathPoint& point) {
    const PathSource source{point.source};
    return nameOf(source) + (source.isTake() ? ", sample " : ", move ") + std::to_string(point.sample);
}

/// Appends paths to a program as moves of the machine's axes.
class PathWriter {
public:
    PathWriter(NcProgram& program, const PostRequest& request, const MachineProfile& machine)
        : program_(program)
        , request_(request)
        , machine_(machine)
        , kinematics_(kinematicsOf(machine, request.workOffset))
        , travel_(machine) {}

    Result<void> append(const Path& path) {
        NcSection& section = sectionOf(program_, path, request_);
        bool awaitsCut = true;
        CutState state = stateAtEnd(section);
        Result<std::vector<AxisValues>> values = valuesOf(path);
        if (!values) return std::move(values).error();
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const PathPoint& point = path.points[i];
            Result<NcMove> move = moveTo(path, i, std::move((*values)[i]));
            if (!move) return std::move(move).error();
            if (point.kind == MoveKind::rapid) awaitsCut = true;
            const CutState wanted = stateFrom(path, i);
            if (wanted.speed != state.speed) move->spindleSpeed = wanted.speed;
            if (wanted.coolant != state.coolant) move->coolant = wanted.coolant;
            state = wanted;
            if (awaitsCut && point.kind == MoveKind::cut && point.sample >= 0) {
                move->comment = originOf(point);
                awaitsCut = false;
            }
            if (move->kind == NcMoveKind::arc) goAlongArc(*move, section.moves.back().target);
            travel_.goTo(kinematics_->axes(), move->target);
            section.moves.push_back(std::move(*move));
        }
        return {};
    }

    /// Checks whether the axes can reach all positions, including the heights that the dialect itself moves to before
    /// and after the moves.
    Result<void> checkTravel() {
        travel_.goTo(Axis::z, std::max(request_.safeHeight, machine_.toolChangeHeight));
        for (const Axis axis : kinematics_->axes())
            if (const std::optional<double> way = travel_.wayBeyond(axis))
                return limitError(std::string(1, letterOf(axis)) + " travel", *way,
                                  formatFixed(travel_.length(axis), 3), isRotary(axis) ? "°" : "mm");
        return {};
    }

private:
    /// The values of the axes at each point, going on from those at the end of the program so far.
    Result<std::vector<AxisValues>> valuesOf(const Path& path) const {
        using By = CoursePose::By;
        std::vector<CoursePose> poses;
        poses.reserve(path.points.size());
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const PathPoint& point = path.points[i];
            if (!isFinite(point.pose.tip)) return pointError(path, i, " is not finite");
            poses.push_back({point.pose, point.kind == MoveKind::rapid ? By::rapid : point.arc ? By::arc : By::line});
        }
        const AxisValues none;
        const AxisValues* before = &none;
        for (const NcSection& section : program_.sections)
            if (!section.moves.empty()) before = &section.moves.back().target;
        return axesAlong(*kinematics_, poses, *before);
    }

    Result<NcMove> moveTo(const Path& path, std::size_t i, AxisValues target) const {
        const PathPoint& point = path.points[i];
        if (Result<void> feed = checkFeed(point, i, machine_); !feed) return feed.error();
        NcMove move;
        move.kind = point.kind == MoveKind::rapid ? NcMoveKind::rapid : NcMoveKind::line;
        move.target = std::move(target);
        if (point.arc) {
            if (i == 0 || move.kind == NcMoveKind::rapid || !isFinite(point.arc->centre))
                return pointError(path, i, " can't be the end of an arc");
            const Result<AxisValues> centre = valuesAt(ToolPose{point.arc->centre}, i); // as if the tip were there
            if (!centre) return centre.error();
            move.kind = NcMoveKind::arc;
            move.arc = {centre->linear(), point.arc->axis, point.arc->clockwise};
        }
        move.feed = point.kind == MoveKind::rapid ? 0.0 : point.feed;
        move.source = point.source;
        move.sample = point.sample;
        return move;
    }

    static Error pointError(const Path& path, std::size_t i, const char* what) {
        return Error{ErrorCode::argumentInvalid, "path", path.name, "point " + std::to_string(i) + what};
    }

    Result<AxisValues> valuesAt(const ToolPose& pose, std::size_t i) const {
        Result<AxisValues> values = kinematics_->axesOf(pose);
        if (values) return values;
        Error error = std::move(values).error();
        error.detail = "point " + std::to_string(i);
        return error;
    }

    /// Includes points along the path of an arc.
    void goAlongArc(const NcMove& move, const AxisValues& from) {
        const Arc arc{from.linear(), move.target.linear(), move.arc.centre, move.arc.axis, move.arc.clockwise};
        // underestimates by at most 0.12 % of the radius, far less than the accuracy of the travel
        constexpr int steps = 64;
        const ArcTurn turn = turnOf(arc);
        for (int i = 1; i < steps; ++i)
            travel_.goTo(linearAxes, AxisValues(placeOn(arc, turn, static_cast<double>(i) / steps)));
    }

    NcProgram& program_;
    const PostRequest& request_;
    const MachineProfile& machine_;
    std::unique_ptr<const Kinematics> kinematics_;
    AxisTravel travel_;
};

/// Checks the length of each line and collects the lines.
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
        for (const PathPoint& point : path.points)
            if (Result<void> speed = checkSpindleSpeed(speedOf(path, point), machine); !speed) return speed.error();
    NcProgram program;
    program.name = request.programName;
    program.header = request.header;
    program.units = request.units;
    program.workOffset = request.workOffsetNumber;
    program.safeHeight = request.safeHeight;
    program.blendTolerance = request.blendTolerance;
    PathWriter writer(program, request, machine);
    for (const Path& path : paths)
        if (Result<void> done = writer.append(path); !done) return done.error();
    if (Result<void> travel = writer.checkTravel(); !travel) return travel.error();
    return program;
}

Result<std::string> writeProgram(const NcProgram& program, const MachineProfile& machine, const PostProcessor& post,
                                 Progress& progress) {
    TextSink sink(machine.maximumLineLength);
    if (Result<void> written = post.write(program, machine, sink, progress); !written) return written.error();
    return sink.take();
}

} // namespace burin
