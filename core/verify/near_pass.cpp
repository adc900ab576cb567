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

/// Judges the moves of a program against one mesh after the other.
class NearJudge {
public:
    NearJudge(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request,
              std::span<const std::uint32_t> numbers, KeptDips& kept)
        : moves_(moves), tools_(tools), request_(request), numbers_(numbers), kept_(kept) {}

    /// @param mesh null: left out
    Result<void> judge(const MeshDistance* mesh, NearTo to, NearPasses& passes, const Progress& progress) {
        for (const ToolSection which : {ToolSection::shank, ToolSection::holder}) {
            KeptDips::List& known = kept_.of(question_++);
            if (mesh == nullptr) continue;
            std::vector<Section> sections;
            for (const Tool& tool : tools_) sections.emplace_back(*mesh, tool, which);
            const Dips dips = dipsOf(sections, known, progress);
            if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
            for (std::size_t i = 0; i < moves_.size(); ++i) {
                const ToolMove& move = moves_[i];
                if (move.endKnown) known.keep(numbers_[i], dips[i]);
                if (!dips[i] || dips[i]->clearance < -request_.gougeTolerance) continue;
                const ToolClearance nearest =
                    sections[move.tool].guard.clearance(move.poseAt(dips[i]->part), 2.0 * request_.nearDistance);
                passes.add({which, to, move.line, nearest.meshPoint, std::max(0.0, dips[i]->clearance)});
            }
        }
        return {};
    }

private:
    using Dips = std::vector<std::optional<PartGuard::Dip>>;

    Dips dipsOf(const std::vector<Section>& sections, const KeptDips::List& known, const Progress& progress) const {
        Dips dips(moves_.size());
        parallelIntervals(std::size_t{0}, moves_.size(), 64, [&](std::size_t from, std::size_t end) {
            for (std::size_t i = from; i != end; ++i) {
                const ToolMove& move = moves_[i];
                const Section& section = sections[move.tool];
                if (progress.cancelled() || !move.endKnown || known.find(numbers_[i], dips[i])) continue;
                if (!move.tilted() &&
                    std::min(move.begin().tip.z, move.to.tip.z) + section.bottom - request_.nearDistance >
                        section.guard.top())
                    continue;
                dips[i] = section.guard.deepestDip(move.begin(), move.to, request_.nearDistance, request_.sampling);
            }
        });
        return dips;
    }

    const std::vector<ToolMove>& moves_;
    std::span<const Tool> tools_;
    const VerifyRequest& request_;
    std::span<const std::uint32_t> numbers_;
    KeptDips& kept_;
    std::size_t question_ = 0; ///< number of the next list of `kept_`
};

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
                             const VerifyRequest& request, std::span<const std::uint32_t> numbers, KeptDips& kept,
                             NearPasses& passes, const Progress& progress) {
    if (!(request.nearDistance > 0.0)) return {};
    NearJudge judge(moves, tools, request, numbers, kept);
    if (Result<void> judged = judge.judge(request.part, NearTo::part, passes, progress); !judged) return judged;
    for (const ObstacleSolid& obstacle : solidsOf(request.obstacles))
        if (Result<void> judged =
                judge.judge(obstacle.on ? obstacle.surface.get() : nullptr, NearTo::obstacle, passes, progress);
            !judged)
            return judged;
    return {};
}

} // namespace burin
