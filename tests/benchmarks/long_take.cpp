// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/long_take.h"

#include "core/document/project.h"

#include <cmath>
#include <random>
#include <vector>

namespace burin::testing {

namespace {

glm::dvec3 rowTip(const Box& stock, std::size_t tick) {
    constexpr double step = 0.04, stepOver = 2.0, deeper = 0.4; // mm
    const double length = stock.size().x, way = step * static_cast<double>(tick), row = std::floor(way / length);
    const double along = way - row * length, rows = std::floor(stock.size().y / stepOver);
    const double layer = std::floor(row / rows), number = row - layer * rows;
    const auto t = static_cast<double>(tick);
    const glm::dvec3 tremor = 0.02 * glm::dvec3(std::sin(0.06 * t), std::sin(0.05 * t + 1.0), std::sin(0.055 * t));
    const double x = std::fmod(row, 2.0) > 0.5 ? length - along : along;
    return stock.low + glm::dvec3(x, stepOver * number, stock.size().z - deeper * (layer + 1.0)) + tremor;
}

} // namespace

bool recordLong(const QString& file, const std::string& tool, const LongTake& take) {
    Result<Project> project = Project::open(file.toStdString());
    if (!project) return false;
    const Result<Setup> setup = project->setup();
    if (!setup) return false;
    TakeInfo info;
    info.name = "long";
    info.toolId = tool;
    info.tickPeriod = 0.001;
    Result<Project::TakeWriter> writer = project->beginTake(info);
    if (!writer) return false;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> jitter(-take.noise, take.noise);
    std::vector<Sample> samples;
    for (std::size_t tick = 0; tick < take.samples; ++tick) {
        Sample sample;
        sample.tick = tick;
        sample.time = 0.001 * static_cast<double>(tick);
        sample.proxy.tip = sample.stylusTip = rowTip(setup->stock, tick);
        if (take.noise > 0.0) {
            sample.stylusTip += glm::dvec3(jitter(random), jitter(random), jitter(random));
            sample.proxy.tip = sample.stylusTip;
            sample.force = glm::dvec3(jitter(random), jitter(random), 1.0 + jitter(random));
        }
        sample.removed[0] = {100, 1};
        sample.buttons = 1;
        samples.push_back(sample);
        if (samples.size() < take.perCommit) continue;
        if (!writer->append(samples)) return false;
        samples.clear();
    }
    return writer->finish() && project->save();
}

} // namespace burin::testing
