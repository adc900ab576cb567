// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"
#include "tests/core/tool/fixed_tools.h"

#include <array>
#include <functional>
#include <numbers>

namespace burin::benchmarks {

namespace {

using std::nullopt;
using Limit = std::optional<double>;

/// A peer for the median tick. The paper's method is reported with the main figure, the others have figures of their
/// own.
struct PeerRequest {
    std::string name;   ///< as displayed
    std::string suffix; ///< of the figure's name
    std::unique_ptr<CuttingPeer> (*make)(const VolumeSnapshot&, const LineBlock&, const EndMill&);
    Limit ratioAtLeast;
};

std::unique_ptr<CuttingPeer> makeOpenVdb(const VolumeSnapshot& workpiece, const LineBlock&, const EndMill& tool) {
    return openVdbCutter(workpiece, tool);
}

PeerRequest paper(Limit ratio) {
    return {"paper's way", "", paperCutter, ratio};
}
PeerRequest openVdb() {
    return {"OpenVDB Int8, incremental leaf writes", ".against_openvdb", makeOpenVdb, 8.0};
}
PeerRequest bytes() {
    return {"dense bytes, incremental", ".against_bytes", denseByteCutter, nullopt};
}
PeerRequest bits() {
    return {"dense bits, incremental, no material", ".against_bits", denseBitCutter, nullopt};
}

struct CutCase {
    std::string name;
    std::function<RunVolume()> scene;
    Cutter cutter;
    std::vector<ToolPose> path;
    Limit p50, p999;
    std::vector<PeerRequest> peers;
};

/// Results of a case that are still needed after it was measured.
struct Measured {
    std::vector<double> ticks; ///< µs
    double p50 = 0.0, p999 = 0.0;
    std::uint64_t removedUnits = 0;
};

double peerMedian(Session& session, const CutCase& task, const PeerRequest& request, const VolumeSnapshot& workpiece) {
    std::vector<glm::dvec3> tips;
    for (const ToolPose& pose : task.path) tips.push_back(pose.tip);
    const auto peer =
        request.make(workpiece, blockOf(tips, task.cutter.radius(), workpiece.grid()), endMillOf(task.cutter));
    if (!peer) return 0.0;
    VoxelCounts removed{};
    const auto restart = [&] {
        peer->restart();
        peer->cut(tips.front(), tips.front(), removed);
    };
    const ReplayRule rule{4, 6, 0.5};
    std::vector<double> ticks = leastOfReplays(
        tips.size() - 1, restart, [&](std::size_t i) { peer->cut(tips[i], tips[i + 1], removed); }, rule);
    return percentile(session.least(task.name + ", " + request.name, std::move(ticks)), 0.5);
}

/// A case's own figures and those of its peers. Returns nullopt if none of its figures is requested.
std::optional<Measured> measure(Session& session, const CutCase& task) {
    if (!session.wants(task.name)) return nullopt;
    session.stage(task.name);
    RunVolume workpiece = task.scene();
    Measured measured;
    {
        Milling milling(workpiece, task.cutter);
        measured.ticks = session.least(task.name, milling.leastTicks(session, task.path));
        measured.removedUnits = milling.removedUnits();
        milling.restartInAir(session);
    }
    measured.p50 = percentile(measured.ticks, 0.5);
    measured.p999 = percentile(measured.ticks, 0.999);
    const VolumeSnapshot start = workpiece.snapshot();
    Figure median = figure(task.name + ".p50", measured.p50, "us", task.p50);
    for (const PeerRequest& request : task.peers) {
        const std::string name = median.name + request.suffix;
        if (!session.wants(name)) continue;
        session.stage(task.name + ", " + request.name);
        const double theirs = peerMedian(session, task, request, start);
        if (theirs == 0.0) continue; // built without that peer
        if (request.suffix.empty())
            median = against(std::move(median), request.name, theirs, request.ratioAtLeast);
        else
            session.add(against(figure(name, measured.p50, "us"), request.name, theirs, request.ratioAtLeast));
    }
    session.add(std::move(median));
    session.add(figure(task.name + ".p999", measured.p999, "us", task.p999));
    session.add(
        figure(task.name + ".voxels_per_tick",
               static_cast<double>(measured.removedUnits) / unitsPerVoxel / static_cast<double>(measured.ticks.size()),
               "voxels"));
    return measured;
}

std::function<RunVolume()> block(std::int32_t side) {
    return [side] { return layeredBlock(side); };
}

CutCase ballWalk(const std::string& name, std::int32_t side, double radius, double step, std::size_t ticks, Limit p50,
                 Limit p999, std::vector<PeerRequest> peers) {
    return {name,
            [side] { return halfBlock(side); },
            cutterOf(CutterType::ball, radius, fluteLengthFromAbove),
            upright(walkFromAbove(side, radius, step, ticks)),
            p50,
            p999,
            std::move(peers)};
}

/// Cost must not grow with the grid.
void walksAtOneVoxel(Session& session) {
    const auto r50 = [&](std::int32_t side, std::vector<PeerRequest> peers) {
        return measure(session, ballWalk("cut.ball.r50.m1." + std::to_string(side), side, 50.0, 1.0, 2000, 20.0, 40.0,
                                         std::move(peers)));
    };
    const auto small = r50(512, {paper(7.5)});
    if (small && session.wants("cut.ball.r50.m1.512.p50.against_csg_difference")) {
        session.stage("cut.ball.r50.m1.512, OpenVDB csgDifference");
        const std::string name = "cut.ball.r50.m1.512.p50.against_csg_difference";
        const auto times = csgDifferenceTimes(512.0, 50.0, walkFromAbove(512.0, 50.0, 1.0, 2000));
        if (times)
            session.add(against(figure(name, small->p50, "us"), "OpenVDB level set, csgDifference",
                                percentile(session.least(name, *times), 0.5), 1000.0));
    }
    (void)r50(1024, {paper(7.5), openVdb(), bytes(), bits()});
    const auto large = r50(2048, {paper(7.5)});
    (void)measure(session, {"cut.ball.r50.m1.1024.immersed",
                            block(1024),
                            cutterOf(CutterType::ball, 50.0),
                            upright(walk(1024.0, 50.0, 1.0, 2000)),
                            nullopt,
                            nullopt,
                            {paper(nullopt)}});
    if (small && large) session.add(figure("cut.ball.r50.m1.2048_over_512", large->p50 / small->p50, "1", 1.2));
    (void)measure(session,
                  ballWalk("cut.ball.r100.m1.2048", 2048, 100.0, 1.0, 1500, 60.0, 100.0, {paper(9.5), openVdb()}));
    (void)measure(session, ballWalk("cut.ball.r200.m1.2048", 2048, 200.0, 1.0, 1000, nullopt, 300.0, {}));
}

void slowAndFastWalks(Session& session) {
    (void)measure(session, ballWalk("cut.ball.r50.m005.1024", 1024, 50.0, 0.05, 2000, 15.0, 28.0, {paper(nullopt)}));
    (void)measure(session, ballWalk("cut.ball.r100.m005.2048", 2048, 100.0, 0.05, 2000, 45.0, 70.0, {paper(nullopt)}));
    const std::string name = "cut.ball.r100.m5.2048";
    const auto fast = measure(session, ballWalk(name, 2048, 100.0, 5.0, 1000, nullopt, 200.0, {}));
    if (!fast) return;
    double spent = 0.0; // µs
    for (const double tick : fast->ticks) spent += tick;
    const double voxels = static_cast<double>(fast->removedUnits) / unitsPerVoxel;
    Figure rate = figure(name + ".gvoxel_per_s", 1e-3 * voxels / spent, "Gvoxel/s", 1.5);
    rate.atLeast = true;
    session.add(std::move(rate));
}

void otherScenes(Session& session) {
    (void)measure(session, {"cut.raster.r50.m1.1024",
                            block(1024),
                            cutterOf(CutterType::ball, 50.0),
                            upright(raster(1024.0, 50.0, 1.0, 2000)),
                            20.0,
                            40.0,
                            {paper(7.5)}});
    (void)measure(session, {"cut.lattice.r100.m1.512",
                            [] { return gyroidLattice(512, 30); },
                            cutterOf(CutterType::ball, 100.0),
                            upright(walk(512.0, 100.0, 1.0, 1000)),
                            nullopt,
                            400.0,
                            {}});
}

void tiltedTools(Session& session) {
    struct Kind {
        const char* name;
        CutterType type;
        double p999;
    };
    constexpr std::array kinds{Kind{"ball", CutterType::ball, 60.0}, Kind{"flat", CutterType::flat, 60.0},
                               Kind{"bull", CutterType::bullNose, 160.0}};
    const double tilt = std::numbers::pi / 6.0;
    for (const Kind& kind : kinds)
        (void)measure(session, {"cut." + std::string(kind.name) + ".r50.tilt30.512",
                                block(512),
                                cutterOf(kind.type, 50.0),
                                tilted(walk(512.0, 50.0, 1.0, 1000), tilt),
                                nullopt,
                                kind.p999,
                                {}});
}

/// A tool of arbitrary shape that doesn't turn: a bumpy body, 240 voxels high and 48 across, which is 60 mm by 12 mm at
/// voxels of 0.25 mm. All of it cuts.
Cutter bumpyTool() {
    TriangleMesh body = shapes::starShaped(64, 64, [](double longitude, double latitude) {
        return 1.0 + 0.12 * std::sin(5.0 * longitude) * std::cos(latitude) + 0.1 * std::sin(9.0 * latitude);
    });
    const Box box = boundingBox(body);
    for (glm::dvec3& vertex : body.vertices)
        vertex = {vertex.x * 48.0 / box.size().x, vertex.y * 48.0 / box.size().y,
                  (vertex.z - box.low.z) * 240.0 / box.size().z};
    return cutters::fixed(std::move(body), {}, 0.3);
}

void toolsThatDontTurn(Session& session) {
    struct Walk {
        const char* step;
        double length; // voxels per tick: at 0.25 mm and 1 kHz 12.5 and 250 mm/s
    };
    for (const Walk& each : {Walk{"m005", 0.05}, Walk{"m1", 1.0}}) {
        const std::string name = std::string("cut.fixed.60mm.") + each.step + ".512";
        if (!session.wants(name)) continue;
        (void)measure(
            session,
            {name, block(512), bumpyTool(), upright(walk(512.0, 50.0, each.length, 2000)), nullopt, 700.0, {}});
    }
    // A core drill of 12 × 60 mm with a bore of 8 mm, in voxels of 0.25 mm.
    Cutter drill = cutters::annular(60.0);
    std::vector<ProfileElement> profile = drill.profile;
    for (ProfileElement& element : profile) element = {4.0 * element.radius, 4.0 * element.height};
    PlanRegion section = drill.solid->section;
    for (PlanRing& ring : section.rings)
        for (glm::dvec2& corner : ring) corner *= 4.0;
    drill = cutters::make(CutterType::profile, 4.0 * drill.diameter, 0.0, 4.0 * drill.fluteLength);
    drill.profile = profile;
    drill.solid = std::make_shared<const ToolSolid>(turningSolid(std::move(section), profile));
    for (const Walk& each : {Walk{"m005", 0.05}, Walk{"m1", 1.0}}) {
        const std::string name = std::string("cut.hollow.60mm.") + each.step + ".512";
        if (session.wants(name))
            (void)measure(session,
                          {name, block(512), drill, upright(walk(512.0, 50.0, each.length, 2000)), nullopt, 700.0, {}});
    }
}

/// Rows along a block's top at a distance of one radius, each as long as the block, then the same a radius deeper.
std::vector<glm::dvec3> rowsOverBlock(const glm::dvec3& size, double radius, std::size_t ticks) {
    const double step = 0.2 * radius;
    const auto perRow = static_cast<std::size_t>(size.x / step);
    const auto rows = static_cast<std::size_t>(size.y / radius);
    std::vector<glm::dvec3> tips;
    for (std::size_t i = 0; tips.size() <= ticks; ++i) {
        const std::size_t row = i / perRow, along = i % perRow;
        const double x = static_cast<double>(row % 2 == 0 ? along : perRow - along) * step;
        const double y = 0.5 + static_cast<double>(row % rows) * radius;
        const double depth = 0.5 + radius * static_cast<double>(1 + row / rows);
        tips.emplace_back(x, y, size.z - depth);
    }
    return tips;
}

/// Figure 13 b of the paper: a block of 40 × 32 × 40 voxels.
void paperCase(Session& session) {
    constexpr glm::ivec3 size(40, 32, 40);
    const auto measureRadius = [&](const std::string& name, double radius) {
        (void)measure(session, {name,
                                [&] { return plainBlock(size); },
                                cutterOf(CutterType::ball, radius),
                                upright(rowsOverBlock(size, radius, 2000)),
                                nullopt,
                                nullopt,
                                {paper(nullopt)}});
    };
    measureRadius("cut.paper_case.r0_5", 0.5);
    measureRadius("cut.paper_case.r5", 5.0);
}

/// A whole footprint at once, in two cases: coming down on the stock, and a take that begins deep within it.
void firstContact(Session& session) {
    const std::string name = "cut.first_contact.r200";
    if (!session.wants(name)) return;
    session.stage(name);
    constexpr double side = 2048.0, radius = 200.0;
    RunVolume workpiece = layeredBlock(static_cast<std::int32_t>(side));
    Milling milling(workpiece, cutterOf(CutterType::ball, radius));
    const double top = 0.97 * side;
    std::vector<ToolPose> path;
    for (double height = 40.0; height > -40.0; height -= 1.0)
        path.push_back({glm::dvec3(0.5 * side, 0.5 * side, top + height), {0.0, 0.0, 1.0}});
    const auto worstOf = [&](const char* contact, const std::vector<ToolPose>& poses) {
        std::vector<double> least = leastOfReplays(
            poses.size() - 1, [&] { milling.restartInAir(session); },
            [&](std::size_t i) { milling.tick(poses[i], poses[i + 1]); }, [&] { milling.giveBackView(); }, {5, 8, 1.0});
        milling.finish(session);
        return percentile(session.least(name + contact, std::move(least)), 1.0);
    };
    const double descending = worstOf(".descending", path);
    // The tool is deep in the stock at its first tick, and moves on from there.
    std::vector<ToolPose> deep{{glm::dvec3(0.5 * side), {0.0, 0.0, 1.0}}};
    for (const glm::dvec3& tip : walk(side, radius, 1.0, 100)) deep.push_back({tip, {0.0, 0.0, 1.0}});
    deep.front() = deep[1];
    const double within = worstOf(".begun_within", deep);
    session.add(figure(name, std::max(descending, within), "us", 1000.0));
    session.add(figure(name + ".descending", descending, "us", 1000.0));
    session.add(figure(name + ".begun_within", within, "us", 1000.0));
}

} // namespace

void cuttingFigures(Session& session) {
    paperCase(session);
    walksAtOneVoxel(session);
    slowAndFastWalks(session);
    otherScenes(session);
    tiltedTools(session);
    toolsThatDontTurn(session);
    firstContact(session);
}

} // namespace burin::benchmarks
