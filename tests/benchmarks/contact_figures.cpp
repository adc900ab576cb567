// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/contact.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

namespace burin::benchmarks {

namespace {

/// A tool whose shank and holder are inside a shaft without touching anything.
struct FreeTool {
    double radius = 0.0, length = 0.0; ///< mm; flutes and shank together
    std::string suffix;
};

/// The median over all tips of the least time of a contact check, as the haptic loop makes one each tick; nothing may
/// touch.
double lookAround(Session& session, const std::string& name, const RunVolume& workpiece,
                  const std::vector<RevolvedPiece>& tool, const std::vector<glm::dvec3>& tips) {
    ContactCheck check(workpiece.grid());
    constexpr std::size_t flutes = 1;
    bool touches = false;
    std::vector<double> least = leastOfReplays(
        tips.size(), [&] { check.forget(); },
        [&](std::size_t i) {
            touches = check.at(workpiece, tool, flutes, {tips[i], {0.0, 0.0, 1.0}}).touches || touches;
        });
    session.check(!touches, "a tool in free space touches nothing");
    return percentile(session.least(name, std::move(least)), 0.5);
}

/// Opens a vertical shaft from `deep` upwards.
void openShaft(RunVolume& workpiece, double radius, double deep) {
    const Grid& grid = workpiece.grid();
    const glm::dvec2 middle(grid.box().centre());
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            if (glm::distance(grid.lineCentre({u, v}), middle) < radius)
                (void)workpiece.fillSpan({u, v}, grid.toRunPosition(deep), grid.lineEnd(), airProperty);
}

void freeTool(Session& session, const FreeTool& tool) {
    constexpr double side = 512.0;
    RunVolume workpiece = layeredBlock(static_cast<std::int32_t>(side));
    Cutter cutter = cutterOf(CutterType::ball, tool.radius);
    cutter.stickOut = tool.length;
    // Shank and the lower half of the holder are inside the shaft, with a gap all round.
    const double deep = 0.97 * side - tool.length - tool.radius;
    openShaft(workpiece, 1.8 * tool.radius, deep);
    std::vector<glm::dvec3> tips;
    for (std::size_t i = 0; i < 500; ++i) {
        const double turn = 0.05 * static_cast<double>(i);
        tips.emplace_back(0.5 * side + 0.1 * tool.radius * std::cos(turn),
                          0.5 * side + 0.1 * tool.radius * std::sin(turn), deep + 1.0 + 0.01 * static_cast<double>(i));
    }
    const std::vector<RevolvedPiece> all = pieces(cutter);
    const auto add = [&](const std::string& name, const RevolvedPiece& piece) {
        session.add(figure(name, lookAround(session, name, workpiece, {all[0], piece}, tips), "us", 3.0));
    };
    add("contact.shank_us" + tool.suffix, all[1]);
    add("contact.holder_us" + tool.suffix, all[2]);
}

} // namespace

void contactFigures(Session& session) {
    if (!session.wants("contact.")) return;
    session.stage("contact");
    freeTool(session, {50.0, 300.0, ""});
    freeTool(session, {100.0, 200.0, ".r100"});
}

} // namespace burin::benchmarks
