// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

namespace burin::benchmarks {

namespace {

/// A tool whose shank and holder stand in a shaft and over the stock without touching anything.
struct FreeTool {
    double radius = 0.0, length = 0.0; ///< mm; of flutes and shank together
    std::string suffix;
};

/// Median over tips of the least time of a look; nothing may touch.
double lookAround(Run& run, const RunVolume& workpiece, const std::vector<RevolvedPiece>& tool,
                  const std::vector<glm::dvec3>& tips) {
    bool touches = false;
    const std::vector<double> least = leastOfReplays(
        tips.size(), [] {},
        [&](std::size_t i) { touches = shankContact(workpiece, tool, tips[i]).touches || touches; });
    run.check(!touches, "a tool in free space touches nothing");
    return percentile(least, 0.5);
}

void freeTool(Run& run, const FreeTool& tool) {
    constexpr double side = 512.0;
    RunVolume workpiece = layeredBlock(static_cast<std::int32_t>(side));
    Cutter cutter = cutterOf(CutterType::ball, tool.radius);
    cutter.stickOut = tool.length;
    // The shaft: 1.2 times as wide as the tool, so deep that most of the shank stands in it.
    const double top = 0.97 * side, deep = top - 0.7 * tool.length;
    Milling milling(workpiece, cutterOf(CutterType::flat, 1.2 * tool.radius));
    const auto at = [&](double z) { return ToolPose{{0.5 * side, 0.5 * side, z}, {0.0, 0.0, 1.0}}; };
    milling.restart(run, at(top));
    for (double z = top; z > deep; z -= 1.0) milling.tick(at(z), at(z - 1.0));
    milling.finish(run);
    std::vector<glm::dvec3> tips;
    for (std::size_t i = 0; i < 500; ++i) {
        const double turn = 0.05 * static_cast<double>(i);
        tips.emplace_back(0.5 * side + 0.1 * tool.radius * std::cos(turn),
                          0.5 * side + 0.1 * tool.radius * std::sin(turn), deep + 1.0 + 0.01 * static_cast<double>(i));
    }
    const std::vector<RevolvedPiece> all = pieces(cutter);
    run.add(figure("contact.shank_us" + tool.suffix, lookAround(run, workpiece, {all[0], all[1]}, tips), "us", 3.0));
    run.add(figure("contact.holder_us" + tool.suffix, lookAround(run, workpiece, {all[0], all[2]}, tips), "us", 3.0));
}

} // namespace

void contactFigures(Run& run) {
    if (!run.wants("contact.")) return;
    run.stage("contact");
    freeTool(run, {50.0, 300.0, ""});
    freeTool(run, {100.0, 400.0, ".r100"});
}

} // namespace burin::benchmarks
