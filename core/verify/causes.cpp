// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/causes.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace burin {

namespace {

/// Kinds of findings that result from a wrong position of the tool.
bool isOfPlace(FindingKind kind) noexcept {
    switch (kind) {
    case FindingKind::gouge:
    case FindingKind::rapidInStock:
    case FindingKind::shankCollision:
    case FindingKind::holderCollision:
    case FindingKind::travelLimit:
    case FindingKind::rotaryLimit:
    case FindingKind::unknownStart:
    case FindingKind::obstacleCollision:
    case FindingKind::centrePlunge:
    case FindingKind::allowanceDiffers:
        return true;
    default:
        return false;
    }
}

bool cuts(const NcMotion& motion) noexcept {
    return motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc;
}

/// A shift, or G91, and the motions under it.
struct Region {
    std::uint32_t line = 0;
    std::size_t first = 0, end = 0; ///< motions
};

std::vector<Region> regionsOf(const ParsedProgram& program) {
    std::vector<Region> regions;
    for (const NcSettingKind kind : {NcSettingKind::shift, NcSettingKind::distance}) {
        std::optional<Region> open;
        const auto close = [&](std::size_t end) {
            if (open && open->first < end) regions.push_back({open->line, open->first, end});
            open.reset();
        };
        for (const NcSetting& setting : program.settings) {
            if (setting.kind != kind) continue;
            const bool goesOn = kind == NcSettingKind::distance && setting.value != 0 && open;
            if (goesOn) continue;
            close(setting.motions);
            if (setting.value != 0) open = Region{setting.line, setting.motions, 0};
        }
        close(program.motions.size());
    }
    std::ranges::sort(regions, {}, &Region::first);
    return regions;
}

class Causes {
public:
    Causes(const ParsedProgram& program, const PathComparison& comparison)
        : program_(program), comparison_(comparison), regions_(regionsOf(program)) {
        for (const NcSetting& setting : program.settings)
            if (setting.kind == NcSettingKind::spindle || setting.kind == NcSettingKind::toolChange)
                switches_.push_back(setting);
        findMoved();
    }

    std::vector<Finding> gather(std::vector<Finding> findings) {
        nameRegion(findings);
        std::map<std::pair<std::uint32_t, FindingKind>, Finding> gathered;
        for (const Finding& finding : findings) {
            Finding named = finding;
            named.line = causeOf(finding);
            const auto [entry, isNew] = gathered.try_emplace({named.line, named.kind}, named);
            if (isNew) continue;
            Finding& standing = entry->second;
            named.count += standing.count;
            if (isWorse(named, standing)) standing = named;
            standing.count = named.count;
        }
        std::vector<Finding> list;
        for (const auto& [key, finding] : gathered) list.push_back(finding);
        return list;
    }

private:
    /// Index of the first motion of a line; the number of motions if there is none.
    std::size_t motionOf(std::uint32_t line) const {
        const auto found = std::ranges::lower_bound(program_.motions, line, {}, &NcMotion::line);
        return found != program_.motions.end() && found->line == line
                   ? static_cast<std::size_t>(found - program_.motions.begin())
                   : program_.motions.size();
    }

    /// Finds the shift, or G91, under which the positions of the program begin to be wrong, on several lines.
    void nameRegion(const std::vector<Finding>& findings) {
        constexpr std::size_t several = 3;
        std::size_t first = program_.motions.size();
        for (const Finding& finding : findings)
            if (isOfPlace(finding.kind)) first = std::min(first, motionOf(finding.line));
        for (const Region& region : regions_) {
            if (first < region.first || first >= region.end) continue;
            const auto lines = std::ranges::count_if(findings, [&](const Finding& finding) {
                return isOfPlace(finding.kind) && isIn(region, motionOf(finding.line));
            });
            if (static_cast<std::size_t>(lines) >= several) suspect_ = region;
        }
    }
    static bool isIn(const Region& region, std::size_t motion) noexcept {
        return motion >= region.first && motion < region.end;
    }

    std::uint32_t causeOf(const Finding& finding) {
        const std::size_t motion = motionOf(finding.line);
        if (motion == program_.motions.size()) return finding.line;
        if (finding.kind == FindingKind::spindleOff || finding.kind == FindingKind::spindleOn)
            return spindleCause(finding, motion);
        if (!isOfPlace(finding.kind)) return finding.line;
        if (suspect_ && isIn(*suspect_, motion)) return suspect_->line;
        if (const std::optional<std::uint32_t> line = leftPathOn(motion)) return *line;
        return startOfRun(finding, motion);
    }

    /// The line at which the program left its path, for a motion that is off it or begins there: that of the first
    /// motion that ended off it, or of the shift set right before.
    std::optional<std::uint32_t> leftPathOn(std::size_t motion) const {
        if (comparison_.ends.empty()) return std::nullopt;
        const auto moved = moved_.find(program_.motions[motion].tool);
        if (moved != moved_.end() && motion >= moved->second.first) return moved->second.line;
        std::optional<std::size_t> first;
        for (std::size_t i = motion + 1; i-- > 0;) {
            const PathSide side = comparison_.ends[i];
            if (side == PathSide::off) first = i;
            if (side == PathSide::on && i != motion) break;
            if (i != motion && program_.motions[i].tool != program_.motions[motion].tool) break;
        }
        return first ? std::optional(whereLeft(*first)) : std::nullopt;
    }
    /// @param first index of a motion that ends off its path
    std::uint32_t whereLeft(std::size_t first) const {
        for (const Region& region : regions_)
            if (isIn(region, first) && noneOnPath(region.first, first)) return region.line;
        return program_.motions[first].line;
    }
    /// Finds the tools whose moves are mostly off their paths, each with the first such move: a path shifted along a
    /// move still coincides with itself there.
    void findMoved() {
        constexpr std::size_t many = 10;
        constexpr std::size_t share = 3; // one in this many
        struct Count {
            std::size_t on = 0, off = 0, first = 0;
        };
        std::map<int, Count> counts;
        for (std::size_t i = 0; i < comparison_.ends.size(); ++i) {
            if (comparison_.ends[i] == PathSide::unknown) continue;
            Count& count = counts[program_.motions[i].tool];
            if (comparison_.ends[i] == PathSide::on)
                ++count.on;
            else if (count.off++ == 0)
                count.first = i;
        }
        for (const auto& [tool, count] : counts)
            if (count.off >= many && share * count.off >= count.on + count.off)
                moved_[tool] = {count.first, whereLeft(count.first)};
    }
    bool noneOnPath(std::size_t from, std::size_t end) const {
        return std::none_of(comparison_.ends.begin() + static_cast<std::ptrdiff_t>(from),
                            comparison_.ends.begin() + static_cast<std::ptrdiff_t>(end),
                            [](PathSide side) { return side == PathSide::on; });
    }

    /// Consecutive motions have one finding of a kind: at the first.
    std::uint32_t startOfRun(const Finding& finding, std::size_t motion) {
        Run& run = runs_[finding.kind];
        std::size_t end = motion + 1;
        while (end < program_.motions.size() && program_.motions[end].line == finding.line) ++end;
        if (run.line == 0 || motion != run.end) run.line = finding.line;
        run.end = end;
        return run.line;
    }

    /// One cause for all that is cut until the spindle is switched: an M5 in the middle of a cut, otherwise the first
    /// cut.
    std::uint32_t spindleCause(const Finding& finding, std::size_t motion) {
        const auto behind = std::ranges::upper_bound(switches_, motion, {}, &NcSetting::motions);
        std::uint32_t line = finding.line;
        if (behind != switches_.begin()) {
            const NcSetting& last = *std::prev(behind);
            const bool stops = last.kind == NcSettingKind::spindle && last.value == 0 &&
                               last.motions < program_.motions.size() && cuts(program_.motions[last.motions]);
            if (stops) line = last.line;
        }
        return spindle_.try_emplace(behind - switches_.begin(), line).first->second;
    }

    struct Run {
        std::uint32_t line = 0;
        std::size_t end = 0; ///< motions
    };
    const ParsedProgram& program_;
    const PathComparison& comparison_;
    std::vector<Region> regions_;
    std::optional<Region> suspect_;
    struct Left {
        std::size_t first = 0;  ///< index of the first motion off its path
        std::uint32_t line = 0; ///< the line that caused it
    };
    std::map<int, Left> moved_;       ///< by T number
    std::vector<NcSetting> switches_; ///< of spindle and tool, in program order
    std::map<FindingKind, Run> runs_;
    std::map<std::ptrdiff_t, std::uint32_t> spindle_; ///< the line, by the number of switches before it
};

} // namespace

std::vector<Finding> byCause(std::vector<Finding> findings, const ParsedProgram& program,
                             const PathComparison& comparison) {
    return Causes(program, comparison).gather(std::move(findings));
}

} // namespace burin
