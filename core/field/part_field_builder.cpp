// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/part_field_builder.h"

#include "core/field/coarse_bound.h"
#include "core/field/spread.h"
#include "core/field/surface_points.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int brickVoxels = PartFieldLayers::brickVoxels, blockVoxels = PartFieldLayers::blockVoxels;
constexpr std::int32_t coarse = PartFieldLayers::coarse;
constexpr std::size_t perBlock = CellGrid::cellCount; // bricks, and corners that a block owns
constexpr std::size_t evensPerBlock = 125;
constexpr int cubes = 64; // of 2 x 2 x 2 bricks, a block

glm::ivec3 cornerOf(int i) noexcept {
    return {i & 1, (i >> 1) & 1, (i >> 2) & 1};
}

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
        divide();
        sampleCorners();
        chooseCandidates();
        sampleCandidates();
        makeBricks();
        checkSurface();
        boundCoarseBricks();
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, subject, "", ""};
        assemble();
        progress_.report(1.0);
        return std::unique_ptr<const PartFieldLayers>(std::move(layers_));
    }

    static constexpr const char* subject = "distance field of a part";

private:
    struct Candidate {
        glm::ivec3 brick; ///< counted from the origin
        std::size_t block;
        bool smooth = false; ///< its corners tell what lies between
        bool fine = false;
    };

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
        for (const PartSample& sample : top_)
            l.topCorners.push_back(static_cast<float>(static_cast<double>(sample.distance) * voxel()));
    }

    std::array<PartSample, 8> topCornersOf(const glm::ivec3& block) const noexcept {
        std::array<PartSample, 8> corners;
        for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = top_[layers_->topAt(block + cornerOf(i))];
        return corners;
    }

    void divide() {
        PartFieldLayers& l = *layers_;
        const auto reach = static_cast<float>(l.request.reach / voxel());
        for (int z = 0; z < l.blocks.z; ++z)
            for (int y = 0; y < l.blocks.y; ++y)
                for (int x = 0; x < l.blocks.x; ++x) {
                    const std::array<PartSample, 8> corners = topCornersOf({x, y, z});
                    const CoarseBound bound = coarseBound(corners, blockVoxels);
                    const bool wanted = !l.meshBounds.empty() && mayBeWithin(corners, blockVoxels, reach);
                    l.blockNumber.push_back(wanted ? static_cast<std::int32_t>(places_.size()) : coarse);
                    l.topBound.push_back(inMillimetres(bound.error));
                    l.topLeast.push_back(inMillimetres(bound.least));
                    if (wanted) places_.push_back({x, y, z});
                }
        l.divided.resize(places_.size());
        owned_.resize(places_.size() * perBlock);
        evens_.resize(places_.size() * evensPerBlock);
        near_.resize(places_.size());
    }

    float inMillimetres(float voxels) const noexcept {
        return static_cast<float>(static_cast<double>(voxels) * voxel());
    }

    /// Every second corner is asked for; those between where the surface is within reach.
    void sampleCorners() {
        const auto reach = static_cast<float>(layers_->request.reach / voxel());
        spread(places_.size(), 0.02, 0.06, progress_, [&](std::size_t block) { sampleEven(block); });
        spread(places_.size(), 0.06, 0.1, progress_, [&](std::size_t block) {
            PartAsker ask = asker();
            gatherEven(block, ask);
            near_[block] = 0;
            for (int cube = 0; cube < cubes; ++cube)
                if (mayBeWithin(cubeCorners(block, cubeAt(cube)), 2.0F * brickVoxels, reach))
                    near_[block] |= std::uint64_t{1} << cube;
        });
        spread(places_.size(), 0.1, 0.3, progress_, [&](std::size_t block) { sampleOwned(block); });
        corners_.resize(places_.size() * CellGrid::samples);
        spread(places_.size(), 0.3, 0.35, progress_, [&](std::size_t block) { gatherCorners(block); });
        owned_ = {};
    }

    /// Each block those that are not on its upper faces.
    void sampleEven(std::size_t block) {
        PartAsker ask = asker();
        for (int z = 0; z < 8; z += 2)
            for (int row = 0; row < 8; row += 2)
                for (int column = 0; column < 8; column += 2) { // to and fro: each near the last one
                    const int y = z % 4 == 0 ? row : 6 - row, x = row % 4 == 0 ? column : 6 - column;
                    owned_[block * perBlock + CellGrid::cellAt(x, y, z)] =
                        ask.ask(brickVoxels * (8 * places_[block] + glm::ivec3(x, y, z)));
                }
    }

    void gatherEven(std::size_t block, PartAsker& ask) {
        for (int z = 0; z < 5; ++z)
            for (int y = 0; y < 5; ++y)
                for (int x = 0; x < 5; ++x) {
                    const glm::ivec3 local = 2 * glm::ivec3(x, y, z), step = local / 8, in = local - 8 * step;
                    const std::int32_t number = blockNumberAt(places_[block] + step);
                    evens_[block * evensPerBlock + evenAt({x, y, z})] =
                        number == coarse
                            ? ask.ask(brickVoxels * (8 * places_[block] + local))
                            : owned_[static_cast<std::size_t>(number) * perBlock + CellGrid::cellAt(in.x, in.y, in.z)];
                }
    }

    void sampleOwned(std::size_t block) {
        PartAsker ask = asker();
        for (int z = 0; z < 8; ++z)
            for (int row = 0; row < 8; ++row)
                for (int column = 0; column < 8; ++column) {
                    const int y = z % 2 == 0 ? row : 7 - row, x = row % 2 == 0 ? column : 7 - column;
                    if (x % 2 != 0 || y % 2 != 0 || z % 2 != 0)
                        owned_[block * perBlock + CellGrid::cellAt(x, y, z)] = cornerOfBlock(block, {x, y, z}, ask);
                }
    }

    void gatherCorners(std::size_t block) {
        PartAsker ask = asker();
        for (int z = 0; z < 9; ++z)
            for (int y = 0; y < 9; ++y)
                for (int x = 0; x < 9; ++x) {
                    const glm::ivec3 local{x, y, z}, step = local / 8, in = local - 8 * step;
                    const std::int32_t number = blockNumberAt(places_[block] + step);
                    const std::size_t at = CellGrid::sampleAt(x, y, z);
                    PartSample& sample = corners_[block * CellGrid::samples + at];
                    sample =
                        number == coarse
                            ? cornerOfBlock(block, local, ask)
                            : owned_[static_cast<std::size_t>(number) * perBlock + CellGrid::cellAt(in.x, in.y, in.z)];
                    layers_->divided[block].corners[at] = inMillimetres(sample.distance);
                }
    }

    /// Asked for where a cube that it belongs to is within reach, between the even ones otherwise.
    PartSample cornerOfBlock(std::size_t block, const glm::ivec3& corner, PartAsker& ask) const {
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 cube = (8 * places_[block] + corner - cornerOf(i)) >> 1; // counted from the origin
            const std::int32_t number = blockNumberAt(cube >> 2);
            if (number == coarse) continue;
            const glm::ivec3 in = cube & 3;
            if (((near_[static_cast<std::size_t>(number)] >> (in.x + 4 * in.y + 16 * in.z)) & 1U) != 0)
                return ask.ask(brickVoxels * (8 * places_[block] + corner));
        }
        const glm::ivec3 cube = glm::min(corner / 2, 3);
        const glm::vec3 share = 0.5F * glm::vec3(corner - 2 * cube);
        const std::array<PartSample, 8> corners = cubeCorners(block, cube);
        PartSample sum;
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 weight = glm::mix(1.0F - share, share, glm::vec3(cornerOf(i)));
            const float part = weight.x * weight.y * weight.z;
            sum.distance += part * corners[static_cast<std::size_t>(i)].distance;
            sum.gradient += part * corners[static_cast<std::size_t>(i)].gradient;
        }
        return sum;
    }

    static glm::ivec3 cubeAt(int cube) noexcept { return {cube & 3, (cube >> 2) & 3, cube >> 4}; }
    static std::size_t evenAt(const glm::ivec3& e) noexcept {
        return static_cast<std::size_t>(e.x + 5 * (e.y + 5 * e.z));
    }
    std::array<PartSample, 8> cubeCorners(std::size_t block, const glm::ivec3& cube) const noexcept {
        std::array<PartSample, 8> corners;
        for (int i = 0; i < 8; ++i)
            corners[static_cast<std::size_t>(i)] = evens_[block * evensPerBlock + evenAt(cube + cornerOf(i))];
        return corners;
    }

    std::int32_t blockNumberAt(const glm::ivec3& block) const noexcept {
        const glm::ivec3& n = layers_->blocks;
        if (glm::any(glm::lessThan(block, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(block, n))) return coarse;
        return layers_->blockNumber[layers_->blockAt(block)];
    }

    bool isNear(std::size_t block, const glm::ivec3& brick) const noexcept {
        const glm::ivec3 cube = brick / 2;
        return ((near_[block] >> (cube.x + 4 * cube.y + 16 * cube.z)) & 1U) != 0;
    }

    std::array<PartSample, 8> brickCorners(std::size_t block, const glm::ivec3& brick) const noexcept {
        std::array<PartSample, 8> corners;
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 at = brick + cornerOf(i);
            corners[static_cast<std::size_t>(i)] =
                corners_[block * CellGrid::samples + CellGrid::sampleAt(at.x, at.y, at.z)];
        }
        return corners;
    }

    /// Those near the surface.
    void chooseCandidates() {
        spread(places_.size(), 0.35, 0.36, progress_, [&](std::size_t block) {
            FieldBlock& in = layers_->divided[block];
            in.fine.fill(coarse);
            for (int z = 0; z < 8; ++z)
                for (int y = 0; y < 8; ++y)
                    for (int x = 0; x < 8; ++x)
                        if (isNear(block, {x, y, z}) &&
                            mayBeWithin(brickCorners(block, {x, y, z}), brickVoxels, BrickMaker::bandVoxels))
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

    /// What lies between the corners of a candidate, where they are smooth; otherwise it asks for those of its samples
    /// 4 voxels apart that are not on its upper faces.
    void sampleCandidates() {
        fours_.resize(candidates_.size() * 8);
        spreadStretches(candidates_.size(), 0.4, 0.6, progress_, [&](std::size_t first, std::size_t end) {
            PartAsker ask = asker();
            SampleGrid corners(2), third(3);
            for (std::size_t i = first; i < end; ++i) {
                Candidate& candidate = candidates_[i];
                candidate.smooth = refineCorners(candidate, corners, third);
                if (candidate.smooth) continue;
                fours_[i * 8] = corners.get(0);
                for (const int corner : {1, 3, 2, 6, 7, 5, 4}) // a step each
                    fours_[i * 8 + static_cast<std::size_t>(corner)] =
                        ask.ask(brickVoxels * candidate.brick + 4 * cornerOf(corner));
            }
        });
    }

    bool refineCorners(const Candidate& candidate, SampleGrid& corners, SampleGrid& third) const {
        const std::array<PartSample, 8> samples = brickCorners(candidate.block, candidate.brick & 7);
        for (std::size_t corner = 0; corner < 8; ++corner) corners.set(corner, samples[corner]);
        LineCheck eight;
        refine(corners, third, static_cast<float>(brickVoxels), eight);
        return isSmooth(eight);
    }

    std::int32_t candidateAt(const glm::ivec3& brick) const noexcept {
        const std::int32_t block = blockNumberAt(brick >> 3);
        if (block == coarse) return coarse;
        const glm::ivec3 in = brick & 7;
        return layers_->divided[static_cast<std::size_t>(block)].fine[CellGrid::cellAt(in.x, in.y, in.z)];
    }

    /// The 27 samples of a candidate: its own, the next ones', and where these are none, asked for.
    void gather(std::size_t number, SampleGrid& third) const {
        PartAsker ask = asker();
        const Candidate& candidate = candidates_[number];
        SampleGrid corners(2);
        if (candidate.smooth) {
            refineCorners(candidate, corners, third);
            return;
        }
        for (int z = 0; z < 3; ++z)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 3; ++x) {
                    const glm::ivec3 local{x, y, z}, step = local / 2, in = local - 2 * step;
                    const std::int32_t owner = candidateAt(candidate.brick + step);
                    if (owner != coarse && !candidates_[static_cast<std::size_t>(owner)].smooth)
                        third.set(third.at(x, y, z), fours_[static_cast<std::size_t>(owner) * 8 +
                                                            static_cast<std::size_t>(in.x + 2 * in.y + 4 * in.z)]);
                    else if (in == glm::ivec3(0))
                        third.set(third.at(x, y, z),
                                  brickCorners(candidate.block,
                                               candidate.brick &
                                                   7)[static_cast<std::size_t>(step.x + 2 * step.y + 4 * step.z)]);
                    else
                        third.set(third.at(x, y, z), ask.ask(brickVoxels * candidate.brick + 4 * (local)));
                }
    }

    static bool inBand(const SampleGrid& third) noexcept {
        for (int eighth = 0; eighth < 8; ++eighth) {
            std::array<PartSample, 8> corners;
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
        spreadStretches(candidates_.size(), 0.6, 0.95, progress_, [&](std::size_t first, std::size_t end) {
            BrickMaker maker(part_, layers_->origin, voxel());
            SampleGrid third(3);
            for (std::size_t i = first; i < end && !progress_.cancelled(); ++i) {
                gather(i, third);
                candidates_[i].fine = inBand(third);
                if (candidates_[i].fine) maker.make(brickVoxels * candidates_[i].brick, third, false, made_[i]);
            }
        });
    }

    /// Every point of the mesh is a bound of the distances around it, which finds what lies between samples: bricks
    /// that contradict one are made again, sample by sample.
    void checkSurface() {
        std::vector<std::uint8_t> wrong(candidates_.size(), 0);
        const std::span<const Triangle> triangles = part_.triangles();
        spreadStretches(triangles.size(), 0.85, 0.92, progress_, [&](std::size_t first, std::size_t end) {
            SurfacePoints points;
            for (std::size_t i = first; i < end; ++i)
                points.of(triangles[i], 1.5 * voxel(), [&](const glm::dvec3& point) { check(point, wrong); });
        });
        std::vector<std::size_t> again;
        for (std::size_t i = 0; i < wrong.size(); ++i)
            if (wrong[i] != 0) again.push_back(i);
        spread(again.size(), 0.92, 0.95, progress_, [&](std::size_t i) {
            BrickMaker maker(part_, layers_->origin, voxel());
            const std::size_t number = again[i];
            candidates_[number].fine = true;
            maker.make(brickVoxels * candidates_[number].brick, SampleGrid(3), true, made_[number]);
        });
    }

    void check(const glm::dvec3& point, std::vector<std::uint8_t>& wrong) const {
        const glm::dvec3 place = (point - layers_->origin) / voxel();
        const glm::ivec3 home = glm::ivec3(place) >> 3;
        const glm::ivec3 side =
            glm::mix(glm::ivec3(-1), glm::ivec3(1), glm::greaterThan(place - 8.0 * glm::dvec3(home), glm::dvec3(4.0)));
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 brick = home + side * cornerOf(i);
            const std::int32_t number = candidateAt(brick);
            if (number == coarse) continue;
            const glm::vec3 local(place - 8.0 * glm::dvec3(brick)), inside = glm::clamp(local, 0.0F, 8.0F);
            const float away = glm::length(local - inside);
            if (away <= BrickMaker::bandVoxels && contradicts(static_cast<std::size_t>(number), inside, away))
                std::atomic_ref(wrong[static_cast<std::size_t>(number)]).store(1, std::memory_order_relaxed);
        }
    }

    bool contradicts(std::size_t number, const glm::vec3& inside, float away) const noexcept {
        if (!candidates_[number].fine) return true;
        const MadeBrick& made = made_[number];
        const float allowed = inMillimetres(away) + made.bound;
        return std::abs(distanceIn(made, inside)) > allowed && !isExactIn(made, inside);
    }

    /// Where corners lie between asked ones, a value is off by the error there, and once more by its own.
    void boundCoarseBricks() {
        spread(places_.size(), 0.95, 0.98, progress_, [&](std::size_t block) {
            FieldBlock& in = layers_->divided[block];
            for (int cube = 0; cube < cubes; ++cube) {
                const glm::ivec3 low = 2 * cubeAt(cube);
                const bool near = isNear(block, low);
                const CoarseBound whole =
                    near ? CoarseBound{} : coarseBound(cubeCorners(block, cubeAt(cube)), 2.0F * brickVoxels);
                for (int i = 0; i < 8; ++i) {
                    const glm::ivec3 brick = low + cornerOf(i);
                    const std::size_t at = CellGrid::cellAt(brick.x, brick.y, brick.z);
                    const std::int32_t candidate = in.fine[at];
                    if (candidate != coarse && candidates_[static_cast<std::size_t>(candidate)].fine) continue;
                    const CoarseBound bound = near ? coarseBound(brickCorners(block, brick), brickVoxels)
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
    std::vector<PartSample> top_;
    std::vector<glm::ivec3> places_;  ///< of the divided blocks
    std::vector<PartSample> owned_;   ///< per divided block
    std::vector<PartSample> evens_;   ///< per divided block, every second of its corners
    std::vector<std::uint64_t> near_; ///< per divided block, a bit a cube of 2 x 2 x 2 bricks: within reach
    std::vector<PartSample> corners_; ///< per divided block, those on its upper faces too
    std::vector<Candidate> candidates_;
    std::vector<PartSample> fours_;
    std::vector<MadeBrick> made_;
};

} // namespace

Result<std::unique_ptr<const PartFieldLayers>> buildPartField(std::shared_ptr<const MeshDistance> part,
                                                              const PartFieldRequest& request, Progress& progress) {
    return Builder(std::move(part), request, progress).build();
}

} // namespace burin
