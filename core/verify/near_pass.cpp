// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/near_pass.h"

#include "core/base/parallel.h"
#include "core/path/part_guard.h"

#include <algorithm>
#include <array>
#include <optional>

namespace burin {

namespace {

/// Shank or holder of a tool, prepared for comparison with one mesh.
struct Section {
    Section(const MeshDistance& mesh, const Tool& tool, ToolSection which) : guard(mesh, piecesOf(tool, which)) {
        for (const RevolvedPiece& piece : guard.pieces()) bottom = std::min(bottom, piece.bottom);
    }

    static std::vector<RevolvedPiece> piecesOf(const Tool& tool, ToolSection which) {
        const std::vector<RevolvedPiece> all = pieces(tool.cutter);
        std::vector<RevolvedPiece> own;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (sectionOf(tool.cutter, i) == which) own.push_back(all[i]);
        return own;
    }

    PartGuard guard;
    /// mm above the tip; infinite: the tool has no such section
    double bottom = std::numeric_limits<double>::infinity();
};

Result<void> judgeAgainst(const MeshDistance& mesh, NearTo to, const std::vector<ToolMove>& moves,
                          std::span<const Tool> tools, const VerifyRequest& request, NearPasses& passes,
                          const Progress& progress) {
    for (const ToolSection which : {ToolSection::shank, ToolSection::holder}) {
        std::vector<Section> sections;
        for (const Tool& tool : tools) sections.emplace_back(mesh, tool, which);
        std::vector<std::optional<PartGuard::Dip>> dips(moves.size());
        parallelIntervals(std::size_t{0}, moves.size(), 64, [&](std::size_t from, std::size_t end) {
            for (std::size_t i = from; i != end; ++i) {
                const ToolMove& move = moves[i];
                const Section& section = sections[move.tool];
                if (progress.cancelled() || !move.endKnown) continue;
                if (std::min(move.begin().tip.z, move.to.tip.z) + section.bottom - request.nearDistance >
                    section.guard.top())
                    continue;
                dips[i] =
                    section.guard.deepestDip(move.begin().tip, move.to.tip, request.nearDistance, request.sampling);
            }
        });
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
        for (std::size_t i = 0; i < moves.size(); ++i) {
            if (!dips[i] || dips[i]->clearance < -request.gougeTolerance) continue;
            const ToolMove& move = moves[i];
            const glm::dvec3 tip = glm::mix(move.begin().tip, move.to.tip, dips[i]->part);
            const ToolClearance nearest = sections[move.tool].guard.clearance(tip, 2.0 * request.nearDistance);
            passes.add({which, to, move.line, nearest.meshPoint, std::max(0.0, dips[i]->clearance)});
        }
    }
    return {};
}

} // namespace

void NearPasses::add(const NearPass& pass) {
    const auto [entry, isNew] = nearest_.try_emplace({pass.line, pass.section, pass.to}, pass);
    if (!isNew && pass.distance < entry->second.distance) entry->second = pass;
}

std::vector<NearPass> NearPasses::byPlace() const {
    constexpr double alike = 1e-6; // mm: where a tool comes down and goes up again, the first line is reported
    std::vector<NearPass> nearest;
    for (const auto& [key, pass] : nearest_) nearest.push_back(pass);
    std::ranges::stable_sort(nearest, {}, &NearPass::distance);
    std::vector<NearPass> places;
    for (const NearPass& pass : nearest) {
        const auto place = std::ranges::find_if(places, [&](const NearPass& one) {
            return one.section == pass.section && one.to == pass.to &&
                   glm::distance(one.place, pass.place) <= nearPlace;
        });
        if (place == places.end()) {
            places.push_back(pass);
            continue;
        }
        ++place->lines;
        if (pass.distance - place->distance < alike) place->line = std::min(place->line, pass.line);
    }
    return places;
}

std::string idOf(const NearPass& pass) {
    const std::string section = pass.section == ToolSection::holder ? "holder" : "shank";
    switch (pass.to) {
    case NearTo::stock:
        return section + "_near_stock";
    case NearTo::part:
        return section + "_near_part";
    case NearTo::obstacle:
        return section + "_near_obstacle";
    }
    return section;
}

Result<void> judgeNearPasses(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                             const VerifyRequest& request, NearPasses& passes, const Progress& progress) {
    if (!(request.nearDistance > 0.0)) return {};
    if (Result<void> judged = judgeAgainst(*request.part, NearTo::part, moves, tools, request, passes, progress);
        !judged)
        return judged;
    for (const ObstacleSolid& obstacle : solidsOf(request.obstacles))
        if (obstacle.on)
            if (Result<void> judged =
                    judgeAgainst(*obstacle.surface, NearTo::obstacle, moves, tools, request, passes, progress);
                !judged)
                return judged;
    return {};
}

} // namespace burin
