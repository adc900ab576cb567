// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/job/damaged/tray_job.h"

#include "core/nc/dialect_library.h"
#include "tests/core/geometry/shapes.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace burin::test {

namespace {

/// Floor and walls. mm
const std::array<Box, 5> boxes{{{{0.0, 0.0, 0.0}, {30.0, 20.0, 4.0}},
                                {{0.0, 0.0, 4.0}, {3.0, 20.0, 8.0}},
                                {{27.0, 0.0, 4.0}, {30.0, 20.0, 8.0}},
                                {{3.0, 0.0, 4.0}, {27.0, 3.0, 8.0}},
                                {{3.0, 17.0, 4.0}, {27.0, 20.0, 8.0}}}};

constexpr double safe = 15.0, allowance = 0.3, feed = 900.0, plungeFeed = 300.0; // mm, mm/min

Tool flatTool(int number, double diameter) {
    Tool tool;
    tool.id = "flat-" + std::to_string(number);
    tool.name = "Flat end mill " + std::to_string(static_cast<int>(diameter)) + " mm";
    tool.number = number;
    tool.maximumDepthOfCut = 12.0;
    tool.maximumSpindleSpeed = 20000.0;
    tool.source = "made up";
    tool.cutter.type = CutterType::flat;
    tool.cutter.diameter = diameter;
    tool.cutter.fluteLength = 14.0;
    tool.cutter.shankDiameter = diameter;
    tool.cutter.stickOut = 25.0;
    return tool;
}

class PathWriter {
public:
    explicit PathWriter(const Tool& tool) {
        path.name = tool.id;
        path.toolId = tool.id;
        path.spindleSpeed = 12000.0;
    }
    void rapid(const glm::dvec3& to) { path.points.push_back({{to}, MoveKind::rapid, 0.0}); }
    void plunge(const glm::dvec3& to) { path.points.push_back({{to}, MoveKind::plunge, plungeFeed}); }
    void cut(const glm::dvec3& to) { path.points.push_back({{to}, MoveKind::cut, feed}); }
    void turn(const glm::dvec3& to, const glm::dvec3& centre) {
        PathPoint point{{to}, MoveKind::cut, feed};
        point.arc = PathArc{centre, 2, true};
        path.points.push_back(point);
    }
    /// Moves down at a free position, and up again there.
    void descend(double x, double y, double z) {
        rapid({x, y, safe});
        rapid({x, y, z});
    }
    void rise() {
        const glm::dvec3 at = path.points.back().pose.tip;
        rapid({at.x, at.y, safe});
    }
    /// Around the tray's outside, from the middle of its low side along x and back.
    void ring(double off, double z) {
        const double right = 30.0 + off, back = 20.0 + off;
        cut({-off, 10.0, z});
        cut({-off, 20.0, z});
        turn({0.0, back, z}, {0.0, 20.0, z});
        cut({30.0, back, z});
        turn({right, 20.0, z}, {30.0, 20.0, z});
        cut({right, 0.0, z});
        turn({30.0, -off, z}, {30.0, 0.0, z});
        cut({0.0, -off, z});
        turn({-off, 0.0, z}, {0.0, 0.0, z});
        cut({-off, 10.0, z});
    }
    /// Along the pocket's walls with sharp corners, from the low side along x.
    void loop(double off, double z) {
        const double left = 3.0 + off, right = 27.0 - off, front = 3.0 + off, back = 17.0 - off;
        cut({left, 10.0, z});
        cut({left, back, z});
        cut({right, back, z});
        cut({right, front, z});
        cut({left, front, z});
        cut({left, 10.0, z});
    }

    Path path;
};

/// Around the outside, at each level from the side and back. @param off mm from the walls
void addRings(PathWriter& writer, std::initializer_list<double> levels, double beside, double off) {
    for (const double z : levels) {
        writer.descend(beside, 10.0, z);
        writer.ring(off, z);
        writer.cut({beside, 10.0, z});
        writer.rise();
    }
}

Path roughing(const Tool& tool) {
    const double off = tool.cutter.radius() + allowance;
    PathWriter writer(tool);
    writer.descend(-8.0, -1.0, 8.0);
    bool back = false;
    for (const double y : {-1.0, 4.0, 9.0, 14.0, 19.0, 22.0}) {
        writer.cut({back ? 38.0 : -8.0, y, 8.0});
        writer.cut({back ? -8.0 : 38.0, y, 8.0});
        back = !back;
    }
    writer.rise();
    for (const double z : {6.0, 4.3}) {
        writer.descend(15.0, 10.0, z == 6.0 ? 8.5 : 6.5);
        writer.cut({3.0 + off, 10.0, z});
        writer.cut({27.0 - off, 10.0, z});
        writer.loop(off, z);
        writer.rise();
    }
    addRings(writer, {5.0, 2.0, 0.2}, -10.0, off);
    return writer.path;
}

Path finishing(const Tool& tool) {
    const double radius = tool.cutter.radius();
    PathWriter writer(tool);
    writer.descend(15.0, 10.0, 5.0);
    writer.plunge({15.0, 10.0, 4.0});
    for (const double off : {6.8, 5.5, 3.5, radius}) writer.loop(off, 4.0);
    writer.cut({3.0 + radius, 10.0, 8.2}); // over the wall
    writer.cut({-3.5, 10.0, 8.2});
    writer.rise();
    addRings(writer, {4.0, 0.1}, -6.0, radius);
    return writer.path;
}

MillingContext trayMilling(const Tool& tool) {
    Model model;
    for (const Box& box : boxes) {
        Body body;
        body.name = "tray " + std::to_string(model.bodies.size() + 1);
        body.box = box;
        body.mesh = shapes::box(box.low, box.high);
        model.bodies.push_back(std::move(body));
    }
    Setup setup;
    setup.voxel = 0.5;
    setup.stockMaterial = "machinable-wax";
    setup.stock = {{-3.0, -3.0, -1.0}, {33.0, 23.0, 9.0}};
    setup.workOffset = {15.0, 10.0, 9.0};
    Progress progress;
    Result<MillingContext> milling =
        makeMillingContext({std::make_shared<const Model>(model), setup, tool, "linuxcnc-mill", {}, {}}, progress);
    if (!milling) std::abort(); // the test's own set-up
    return std::move(*milling);
}

} // namespace

TrayJob::TrayJob()
    : milling(trayMilling(flatTool(1, 6.0))), tools{flatTool(1, 6.0), flatTool(2, 3.0), flatTool(3, 10.0)} {
    paths.paths = {roughing(tools[0]), finishing(tools[1])};
    paths.tools = {tools[0], tools[1]};
}

ProgramRequest TrayJob::request(const std::string& dialect) const {
    ProgramRequest request;
    request.name = "tray.ngc";
    request.dialect = dialect;
    request.tools = tools;
    request.promised = std::make_shared<const std::vector<Path>>(paths.paths);
    return request;
}

std::string TrayJob::post(const std::string& dialect) const {
    const bool one = dialect == "grbl";
    const ProgramPaths posted = one ? ProgramPaths{{paths.paths.front()}, {tools.front()}} : paths;
    Progress progress;
    Result<CheckedProgram> program = makeProgram(milling, posted, request(dialect), progress);
    if (!program) std::abort();
    return std::move(program->text);
}

double TrayJob::depthInPart(const glm::dvec3& tip, double radius) {
    double deepest = -1e9;
    for (const Box& box : boxes) {
        const double dx = std::max({box.low.x - tip.x, tip.x - box.high.x, 0.0});
        const double dy = std::max({box.low.y - tip.y, tip.y - box.high.y, 0.0});
        deepest = std::max(deepest, std::min(radius - std::hypot(dx, dy), box.high.z - tip.z));
    }
    return deepest;
}

} // namespace burin::test
