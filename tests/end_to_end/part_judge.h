// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "canonical_moves.h"

#include "core/cad/import.h"
#include "core/geometry/mesh_distance.h"
#include "core/recording/sample.h"
#include "core/tool/tool.h"
#include "tests/places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

/// A position of the tool along a program.
struct ToolSample {
    glm::dvec3 tip{0.0};
    bool cutting = false; ///< at the program's highest feed
    bool rapid = false;
    double clearance = 0.0; ///< mm from the fine mesh, negative inside
};

/// Judges the effect of a ball cutter on a part, only by the part's fine mesh and OpenCASCADE's exact distances.
class PartJudge {
public:
    /// Returns nullopt if the model cannot be read. @param radius  of the ball, mm
    static std::optional<PartJudge> of(const char* modelFile, double radius) {
        burin::Progress progress;
        burin::Result<burin::Model> model = burin::importModel(modelFile, importOptions(), progress);
        if (!model || model->bodies.size() != 1) return std::nullopt;
        return PartJudge(std::move(*model), radius);
    }

    static burin::ImportOptions importOptions() {
        burin::ImportOptions options;
        options.worker = BURIN_BUILD_DIRECTORY "/burin-import";
        return options;
    }

    const burin::Model& model() const { return model_; }
    const burin::MeshDistance& part() const { return part_; }

    /// Positions every 0.1 mm along the moves, in the model's frame, each with its clearance. The first move has no
    /// start and is skipped.
    std::vector<ToolSample> along(const std::vector<CanonicalMove>& moves, const glm::dvec3& workOffset) const {
        double cuttingFeed = 0.0;
        for (const CanonicalMove& move : moves) cuttingFeed = std::max(cuttingFeed, move.feed);
        const burin::RevolvedPiece cutter{0.0, 60.0, radius_, radius_, radius_}; // ball and shank in one, 60 mm long
        std::vector<ToolSample> samples;
        for (std::size_t i = 1; i < moves.size(); ++i) {
            const glm::dvec3 from = moves[i - 1].to, to = moves[i].to;
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / 0.1)));
            for (int step = 1; step <= steps; ++step) {
                ToolSample sample{glm::mix(from, to, static_cast<double>(step) / steps) + workOffset,
                                  !moves[i].rapid && moves[i].feed == cuttingFeed, moves[i].rapid, 0.0};
                sample.clearance = part_.clearance({&cutter, 1}, {sample.tip, {0.0, 0.0, 1.0}}, 2.0).clearance;
                samples.push_back(sample);
            }
        }
        return samples;
    }

    /// The largest depth by which the worst `count` samples enter the exact B-rep, mm; nullopt if OpenCASCADE cannot
    /// compute it.
    std::optional<double> exactGouge(std::vector<ToolSample> samples, std::size_t count) const {
        count = std::min(count, samples.size());
        const auto nearer = [](const ToolSample& a, const ToolSample& b) { return a.clearance < b.clearance; };
        std::partial_sort(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count), samples.end(), nearer);
        std::vector<glm::dvec3> centres;
        for (std::size_t i = 0; i < count; ++i) centres.push_back(samples[i].tip + glm::dvec3(0.0, 0.0, radius_));
        burin::Progress progress;
        const auto distances = burin::exactSignedDistances(model_, centres, importOptions(), progress);
        if (!distances) return std::nullopt;
        double gouge = 0.0;
        for (const double distance : *distances) gouge = std::max(gouge, radius_ - distance);
        return gouge;
    }

    /// The largest depth by which the flutes at any recorded proxy enter the part, mm; negative if they stay clear.
    double deepestProxy(const burin::Take& take, const burin::Tool& tool) const {
        const burin::RevolvedPiece cutter = flutes(tool.cutter);
        double deepest = -1e9;
        for (const burin::Sample& sample : take.samples)
            deepest = std::max(deepest, -part_.clearance({&cutter, 1}, sample.proxy, 2.0).clearance);
        return deepest;
    }

private:
    PartJudge(burin::Model model, double radius)
        : model_(std::move(model)), part_(model_.bodies.front().mesh), radius_(radius) {}

    burin::Model model_;
    burin::MeshDistance part_;
    double radius_;
};
