// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/part_field_builder.h"

#include "core/base/available_memory.h"
#include "core/field/spread.h"
#include "tests/part_field/block_corners.h"
#include "tests/part_field/coarse_bound.h"
#include "tests/part_field/surface_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace burin {

namespace {

constexpr int brickVoxels = PartFieldLayers::brickVoxels, blockVoxels = PartFieldLayers::blockVoxels;
constexpr std::int32_t coarse = PartFieldLayers::coarse;

class Builder {
public:
    Builder(std::shared_ptr<const MeshDistance> part, const PartFieldRequest& request, Progress& progress)
        : part_(*part), progress_(progress), layers_(std::make_unique<PartFieldLayers>()) {
        layers_->part = std::move(part);
        layers_->request = request;
        layers_->request.reach = std::max(request.reach, static_cast<double>(BrickMaker::bandVoxels) * request.voxel);
    }

    Result<std::unique_ptr<const PartFieldLayers>> build() {
        if (!lay()) return Error{ErrorCode::outOfMemory, subject, "", "more blocks than a field can count"};
        sampleTop();
        if (progress_.cancelled()) return cancelled(); // unsampled corners would count as near and need memory
        divide();
        if (Result<void> fits = needMemory(subject, blockBytes()); !fits) return fits.error();
        layers_->divided.resize(places_.size());
        corners_.emplace(part_, *layers_, places_);
        corners_->sample(progress_, 0.02, 0.35);
        chooseCandidates();
        if (progress_.cancelled()) return cancelled();
        if (Result<void> fits = needMemory(subject, candidateBytes()); !fits) return fits.error();
        sampleCandidates();
        makeBricks();
        checkSurface();
        growThinFeatures();
        boundCoarseBricks();
        if (progress_.cancelled()) return cancelled();
        assemble();
        progress_.report(1.0);
        return std::unique_ptr<const PartFieldLayers>(std::move(layers_));
    }

    static constexpr const char* subject = "distance field of a part";
    static Error cancelled() { return {ErrorCode::cancelled, subject, "", ""}; }

private:
    PartAsker asker() const { return {part_, layers_->origin, voxel()}; }
    double voxel() const noexcept { return layers_->request.voxel; }

    bool lay() {
        PartFieldLayers& l = *layers_;
        l.meshBounds = part_.bounds();
        l.margin = l.request.reach;
        const Box box = l.meshBounds.empty() ? Box{glm::dvec3(0.0), glm::dvec3(0.0)} : l.meshBounds.grown(l.margin);
        l.origin = box.low;
        double count = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::max(1.0, std::ceil(box.size()[axis] / (blockVoxels * voxel())));
            count *= along + 1.0;
            if (!(count < 1e7)) return false;
            l.blocks[axis] = static_cast<int>(along);
        }
        l.setScale();
        return true;
    }

    void sampleTop() {
        PartFieldLayers& l = *layers_;
        const glm::ivec3 n = l.blocks + 1;
        top_.resize(l.topAt(l.blocks) + 1);
        const auto rows = static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
        spread(rows, 0.0, 0.02, progress_, [&](std::size_t row) {
            PartAsker ask = asker();
            const int y = static_cast<int>(row) % n.y, z = static_cast<int>(row) / n.y;
            for (int x = 0; x < n.x; ++x) top_[l.topAt({x, y, z})] = ask.ask(blockVoxels * glm::ivec3(x, y, z));
        });
        for (const DistanceSample& sample : top_)
            l.topCorners.push_back(static_cast<float>(static_cast<double>(sample.distance) * voxel()));
    }

    std::array<DistanceSample, 8> topCornersOf(const glm::ivec3& block) const noexcept {
        std::array<DistanceSample, 8> corners;
        for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = top_[layers_->topAt(block + cornerOf(i))];
        return corners;
    }

    void divide() {
        PartFieldLayers& l = *layers_;
        const auto reach = static_cast<float>(l.request.reach / voxel());
        for (int z = 0; z < l.blocks.z; ++z)
            for (int y = 0; y < l.blocks.y; ++y)
                for (int x = 0; x < l.blocks.x; ++x) {
                    const std::array<DistanceSample, 8> corners = topCornersOf({x, y, z});
                    const CoarseBound bound = coarseBound(corners, blockVoxels);
                    const bool wanted = !l.meshBounds.empty() && mayBeWithin(corners, blockVoxels, reach);
                    l.blockNumber.push_back(wanted ? static_cast<std::int32_t>(places_.size()) : coarse);
                    l.topBound.push_back(inMillimetres(bound.error));
                    l.topLeast.push_back(inMillimetres(bound.least));
                    if (wanted) places_.push_back({x, y, z});
                }
    }

    double blockBytes() const noexcept {
        return static_cast<double>(places_.size()) *
               static_cast<double>(sizeof(FieldBlock) + BlockCorners::bytesPerBlock());
    }
    /// Memory of the candidates while they are made, and of the finished bricks.
    double candidateBytes() const noexcept {
        constexpr std::size_t each = 8 * sizeof(DistanceSample) + sizeof(MadeBrick) + sizeof(FineBrick) +
                                     static_cast<std::size_t>(PartFieldLayers::narrowStride);
        return static_cast<double>(candidates_.size()) * static_cast<double>(each);
    }

    float inMillimetres(float voxels) const noexcept {
        return static_cast<float>(static_cast<double>(voxels) * voxel());
    }

    /// The bricks near the surface.
    void chooseCandidates() {
        for (FieldBlock& block : layers_->divided) block.fine.fill(coarse);
        spread(places_.size(), 0.35, 0.36, progress_, [&](std::size_t block) {
            FieldBlock& in = layers_->divided[block];
            for (int z = 0; z < 8; ++z)
                for (int y = 0; y < 8; ++y)
                    for (int x = 0; x < 8; ++x)
                        if (corners_->isNear(block, {x, y, z}) &&
                            mayBeWithin(corners_->brickCorners(block, {x, y, z}), brickVoxels, BrickMaker::bandVoxels))
                            in.fine[CellGrid::cellAt(x, y, z)] = 0;
        });
        for (std::size_t block = 0; block < places_.size(); ++block)
            for (int z = 0; z < 8; ++z)
                for (int y = 0; y < 8; ++y)
                    for (int x = 0; x < 8; ++x) {
                        std::int32_t& number = layers_->divided[block].fine[CellGrid::cellAt(x, y, z)];
                        if (number == coarse) continue;
                        number = static_cast<std::int32_t>(candidates_.size());
                        candidates_.push_back({8 * places_[block] + glm::ivec3(x, y, z), block});
                    }
    }

    /// Computes the samples between the corners of a candidate, where they are smooth; otherwise samples those that are
    /// 4 voxels apart and not on its upper faces.
    void sampleCandidates() {
        fours_.resize(candidates_.size() * 8);
        spreadIntervals(candidates_.size(), 0.4, 0.6, progress_, [&](std::size_t first, std::size_t end) {
            PartAsker ask = asker();
            SampleGrid corners(2), third(3);
            for (std::size_t i = first; i < end; ++i) {
                FieldCandidate& candidate = candidates_[i];
                candidate.smooth = suffices(candidate, refineCorners(candidate, corners, third), third, ask);
                if (candidate.smooth) continue;
                fours_[i * 8] = corners.get(0);
                for (const int corner : {1, 3, 2, 6, 7, 5, 4}) // one step apart
                    fours_[i * 8 + static_cast<std::size_t>(corner)] =
                        ask.ask(brickVoxels * candidate.brick + 4 * cornerOf(corner));
            }
        });
    }

    /// Whether a candidate's corners determine the samples between them: at once where the curvature is small,
    /// otherwise if the sample at the brick's centre agrees.
    static bool suffices(const FieldCandidate& candidate, const LineCheck& eight, const SampleGrid& third,
                         PartAsker& ask) {
        if (isSmooth(eight)) return true;
        return mayBeSmooth(eight) &&
               agrees(third.get(third.at(1, 1, 1)), ask.ask(brickVoxels * candidate.brick + brickVoxels / 2));
    }

    LineCheck refineCorners(const FieldCandidate& candidate, SampleGrid& corners, SampleGrid& third) const {
        const std::array<DistanceSample, 8> samples = corners_->brickCorners(candidate.block, candidate.brick & 7);
        for (std::size_t corner = 0; corner < 8; ++corner) corners.set(corner, samples[corner]);
        LineCheck eight;
        refine(corners, third, static_cast<float>(brickVoxels), eight);
        return eight;
    }

    /// The 27 samples of a candidate: its own, those of the next candidates, and where there is no candidate, sampled
    /// from the mesh.
    /// @return the error of those that were not sampled
    LineError gather(std::size_t number, SampleGrid& third) const {
        PartAsker ask = asker();
        const FieldCandidate& candidate = candidates_[number];
        SampleGrid corners(2);
        if (candidate.smooth) return lineError(refineCorners(candidate, corners, third));
        for (int z = 0; z < 3; ++z)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 3; ++x) {
                    const glm::ivec3 local{x, y, z}, step = local / 2, in = local - 2 * step;
                    const std::int32_t owner = candidateAt(*layers_, candidate.brick + step);
                    if (owner != coarse && !candidates_[static_cast<std::size_t>(owner)].smooth)
                        third.set(third.at(x, y, z), fours_[static_cast<std::size_t>(owner) * 8 +
                                                            static_cast<std::size_t>(in.x + 2 * in.y + 4 * in.z)]);
                    else if (in == glm::ivec3(0))
                        third.set(third.at(x, y, z),
                                  corners_->brickCorners(
                                      candidate.block,
                                      candidate.brick & 7)[static_cast<std::size_t>(step.x + 2 * step.y + 4 * step.z)]);
                    else
                        third.set(third.at(x, y, z), ask.ask(brickVoxels * candidate.brick + 4 * (local)));
                }
        return {};
    }

    static bool inBand(const SampleGrid& third) noexcept {
        for (int eighth = 0; eighth < 8; ++eighth) {
            std::array<DistanceSample, 8> corners;
            for (int i = 0; i < 8; ++i) {
                const glm::ivec3 at = cornerOf(eighth) + cornerOf(i);
                corners[static_cast<std::size_t>(i)] = third.get(third.at(at.x, at.y, at.z));
            }
            if (mayBeWithin(corners, 4.0F, BrickMaker::bandVoxels)) return true;
        }
        return false;
    }

    void makeBricks() {
        made_.resize(candidates_.size());
        spreadIntervals(candidates_.size(), 0.6, 0.95, progress_, [&](std::size_t first, std::size_t end) {
            BrickMaker maker(part_, layers_->origin, voxel());
            SampleGrid third(3);
            for (std::size_t i = first; i < end && !progress_.cancelled(); ++i) {
                const LineError error = gather(i, third);
                candidates_[i].fine = inBand(third);
                if (candidates_[i].fine) maker.make(brickVoxels * candidates_[i].brick, third, error, made_[i]);
            }
        });
    }

    /// Bricks that contradict a point of the mesh or another brick are made again, sample by sample, and so are those
    /// that then contradict the new ones.
    void checkSurface() {
        SurfaceCheck check(part_, *layers_, candidates_, made_);
        std::vector<std::uint8_t> asked(candidates_.size(), 0);
        for (std::vector<std::size_t> again = check.contradicted(progress_); !again.empty() && !progress_.cancelled();
             again = check.contradictedBy(again, asked)) {
            spread(again.size(), 0.9, 0.93, progress_, [&](std::size_t i) {
                BrickMaker maker(part_, layers_->origin, voxel());
                const std::size_t number = again[i];
                candidates_[number].fine = true;
                maker.makeClosely(brickVoxels * candidates_[number].brick, made_[number]);
            });
            for (const std::size_t number : again) asked[number] = 1;
        }
        allowForWideFacets(check);
    }

    /// Curvature between samples was assumed to be even; where facets are wide there are kinks.
    void allowForWideFacets(const SurfaceCheck& check) {
        spreadIntervals(made_.size(), 0.93, 0.93, progress_, [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                MadeBrick& made = made_[i];
                if (!candidates_[i].fine || !(made.kinkError > 0.0F) || !check.isFacetNear(i, made.wideFacet)) continue;
                made.bound += made.kinkError;
                made.least = std::max(made.least - made.kinkError, 0.0F);
            }
        });
    }

    /// A feature that folds between samples continues into adjacent bricks, which may not know of it.
    void growThinFeatures() {
        std::vector<std::size_t> last(made_.size());
        std::iota(last.begin(), last.end(), std::size_t{0});
        while (!last.empty() && !progress_.cancelled()) {
            const std::map<std::size_t, CellMask> seeds = thinBeside(last);
            std::vector<std::pair<std::size_t, CellMask>> places(seeds.begin(), seeds.end());
            std::vector<std::uint8_t> grown(places.size(), 0);
            spread(places.size(), 0.93, 0.95, progress_, [&](std::size_t i) {
                const auto& [number, cells] = places[i];
                ExactCellFinder finder(part_, layers_->origin, voxel());
                grown[i] = finder.grow(glm::dvec3(brickVoxels * candidates_[number].brick), cells, made_[number]);
            });
            last.clear();
            for (std::size_t i = 0; i < places.size(); ++i)
                if (grown[i] != 0) last.push_back(places[i].first);
        }
    }

    /// The cells of fine bricks next to those cells of the given bricks in which the surface folds between samples.
    std::map<std::size_t, CellMask> thinBeside(std::span<const std::size_t> bricks) const {
        std::map<std::size_t, CellMask> seeds;
        for (const std::size_t number : bricks) {
            if (!candidates_[number].fine || made_[number].thinMask == CellMask{}) continue;
            for (int side = 0; side < 6; ++side) {
                glm::ivec3 step(0);
                step[side / 2] = 2 * (side % 2) - 1;
                const std::int32_t next = candidateAt(*layers_, candidates_[number].brick + step);
                if (next == coarse || !candidates_[static_cast<std::size_t>(next)].fine) continue;
                const CellMask beside = cellsBeside(made_[number].thinMask, step);
                if (beside == CellMask{}) continue;
                CellMask& cells = seeds[static_cast<std::size_t>(next)];
                for (std::size_t z = 0; z < cells.size(); ++z) cells[z] |= beside[z];
            }
        }
        return seeds;
    }

    /// Where corners lie between sampled ones, the error of a value is the error there plus its own.
    void boundCoarseBricks() {
        spread(places_.size(), 0.95, 0.98, progress_, [&](std::size_t block) {
            FieldBlock& in = layers_->divided[block];
            for (int cube = 0; cube < BlockCorners::cubes; ++cube) {
                const glm::ivec3 low = 2 * BlockCorners::cubeAt(cube);
                const bool near = corners_->isNear(block, low);
                const CoarseBound whole =
                    near ? CoarseBound{}
                         : coarseBound(corners_->cubeCorners(block, BlockCorners::cubeAt(cube)), 2.0F * brickVoxels);
                for (int i = 0; i < 8; ++i) {
                    const glm::ivec3 brick = low + cornerOf(i);
                    const std::size_t at = CellGrid::cellAt(brick.x, brick.y, brick.z);
                    const std::int32_t candidate = in.fine[at];
                    if (candidate != coarse && candidates_[static_cast<std::size_t>(candidate)].fine) continue;
                    const CoarseBound bound = near ? coarseBound(corners_->brickCorners(block, brick), brickVoxels)
                                                   : CoarseBound{2.0F * whole.error, whole.least};
                    in.bound[at] = inMillimetres(bound.error);
                    in.least[at] = inMillimetres(bound.least);
                }
            }
        });
    }

    void assemble() {
        PartFieldLayers& l = *layers_;
        for (FieldBlock& block : l.divided) std::fill(block.fine.begin(), block.fine.end(), coarse);
        std::size_t fine = 0, wide = 0;
        for (std::size_t i = 0; i < made_.size(); ++i)
            if (candidates_[i].fine) {
                ++fine;
                wide += made_[i].header.wide;
            }
        l.bricks.reserve(fine);
        l.narrow.resize((fine - wide) * PartFieldLayers::narrowStride);
        l.wide.resize(wide * CellGrid::samples);
        std::size_t narrowCount = 0, wideCount = 0;
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (!candidates_[i].fine) continue;
            MadeBrick& made = made_[i];
            FieldBlock& block = l.divided[candidates_[i].block];
            const glm::ivec3 in = candidates_[i].brick & 7;
            const std::size_t at = CellGrid::cellAt(in.x, in.y, in.z);
            block.fine[at] = static_cast<std::int32_t>(l.bricks.size());
            block.bound[at] = made.bound;
            block.least[at] = made.least;
            l.bandVoxels += made.bandVoxels;
            if (made.header.wide != 0) {
                std::copy(made.wide.begin(), made.wide.end(),
                          l.wide.begin() + static_cast<std::ptrdiff_t>(wideCount * CellGrid::samples));
                made.header.samples = static_cast<std::uint32_t>(wideCount++);
            } else {
                std::copy(made.narrow.begin(), made.narrow.end(),
                          l.narrow.begin() + static_cast<std::ptrdiff_t>(narrowCount * PartFieldLayers::narrowStride));
                made.header.samples = static_cast<std::uint32_t>(narrowCount++);
            }
            if (!made.cellLists.empty()) adoptExact(made);
            l.bricks.push_back(made.header);
        }
        for (std::size_t block = 0; block < l.divided.size(); ++block) {
            const auto& least = l.divided[block].least;
            l.topLeast[l.blockAt(places_[block])] = *std::min_element(least.begin(), least.end());
        }
        l.exactCells.shrink_to_fit();
        l.cellLists.shrink_to_fit();
        l.lists.shrink_to_fit();
    }

    void adoptExact(MadeBrick& made) {
        PartFieldLayers& l = *layers_;
        ExactCells cells;
        cells.mask = made.exactMask;
        cells.first = static_cast<std::uint32_t>(l.cellLists.size());
        int before = 0;
        for (std::size_t z = 0; z < 8; ++z) {
            cells.before[z] = static_cast<std::uint16_t>(before);
            before += std::popcount(cells.mask[z]);
        }
        const auto offset = static_cast<std::uint32_t>(l.lists.size());
        for (const std::uint32_t list : made.cellLists) l.cellLists.push_back(list + offset);
        l.lists.insert(l.lists.end(), made.lists.begin(), made.lists.end());
        made.header.exact = static_cast<std::uint32_t>(l.exactCells.size());
        l.exactCells.push_back(cells);
    }

    const MeshDistance& part_;
    Progress& progress_;
    std::unique_ptr<PartFieldLayers> layers_;
    std::vector<DistanceSample> top_;
    std::vector<glm::ivec3> places_; ///< of the divided blocks
    std::optional<BlockCorners> corners_;
    std::vector<FieldCandidate> candidates_;
    std::vector<DistanceSample> fours_;
    std::vector<MadeBrick> made_;
};

} // namespace

Result<std::unique_ptr<const PartFieldLayers>> buildPartField(std::shared_ptr<const MeshDistance> part,
                                                              const PartFieldRequest& request, Progress& progress) {
    return Builder(std::move(part), request, progress).build();
}

} // namespace burin
