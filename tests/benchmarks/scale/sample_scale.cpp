// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/virtual_operator.h"
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/milling.h"
#include "core/job/recorded_cuts.h"
#include "core/tool/tool.h"
#include "tests/benchmarks/scale/scale.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace burin::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr double side = 120.0, height = 20.0; // mm, of the block

/// A folder that is deleted with the object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "burin-bench-scale-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    fs::path file(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

/// Rows back and forth through the block, 2 mm apart and 2 mm deep, at 40 mm/s with a tremor, so that throughout the
/// recording each tick cuts as much as the others.
glm::dvec3 tipAt(std::size_t tick) {
    constexpr double step = 0.04, row = 100.0, stepOver = 2.0; // mm
    const double way = step * static_cast<double>(tick), number = std::floor(way / row);
    const double along = way - number * row;
    const bool back = std::fmod(number, 2.0) > 0.5;
    const auto t = static_cast<double>(tick);
    const glm::dvec3 tremor = 0.02 * glm::dvec3(std::sin(0.06 * t), std::sin(0.05 * t + 1.0), std::sin(0.055 * t));
    return glm::dvec3(10.0 + (back ? row - along : along), 8.0 + stepOver * number, height - 2.0) + tremor;
}

/// Recordings of increasing length of a block that is milled with one trace.
class Recordings {
public:
    static std::size_t ticks(int step) { return std::size_t{30000} << step; }

    /// Prepares what `mill` needs.
    void begin(int step) {
        end();
        milling_.emplace(milling());
        Progress progress;
        bounds_.emplace(std::shared_ptr<const ClearanceField>(
            require(clearanceField(*milling_, 0.5, progress), "a benchmark's boundary")));
        project_.emplace(require(Project::create(folder_.file("milled.burin")), "a benchmark's project"));
        keep(project_->setModel(Model{}));
        keep(project_->setSetup(milling_->setup));
        keep(project_->setTool(milling_->tool));
        mapping_ = mappingFor(*milling_, touchLikeStylus());
        readings_.clear();
        for (std::size_t tick = 0; tick < ticks(step); ++tick) {
            StylusState reading;
            reading.time = 0.001 * static_cast<double>(tick);
            reading.pose.position = mapping_.toDevice(tipAt(tick));
            reading.valid = true;
            readings_.push_back(reading);
        }
    }
    TakeOutcome mill() {
        TraceStylus stylus(readings_, touchLikeStylus());
        TakeRequest request;
        request.name = "rows";
        request.mapping = mapping_;
        request.felt.gain = 0.0; // an open loop
        request.saves = false;
        const std::atomic<bool> stop{false};
        return require(recordTake(*project_, *milling_, *bounds_, stylus, request, stop), "milling");
    }
    void save() { keep(project_->save()); }
    /// As in the window: file, stock, and the recording replayed.
    double open() {
        Progress progress;
        const Project project = require(Project::open(folder_.file("milled.burin")), "opening");
        const Tool tool = require(toolFor(project, milling_->tool.id), "tool");
        MillingContext opened = require(makeMillingContext(project, tool, {}, progress), "bench");
        keep(replayTakes(project, opened, progress));
        return opened.workpieceVolume();
    }
    void close() { project_.reset(); }
    double workpieceVolume() const { return milling_->workpieceVolume(); }

private:
    void end() {
        bounds_.reset();
        project_.reset();
    }
    static void keep(const Result<void>& done) {
        if (!done) throw std::runtime_error(done.error().subject + " " + done.error().detail);
    }
    static MillingContext milling() {
        Setup setup;
        setup.voxel = 0.5;
        setup.stockMaterial = "machinable-wax";
        setup.stock = {glm::dvec3(0.0), glm::dvec3(side, side, height)};
        setup.workOffset = {0.5 * side, 0.5 * side, height};
        Progress progress;
        const Tool tool = require(loadTool("ball-6"), "tool");
        return require(
            makeMillingContext({std::make_shared<const Model>(), setup, tool, "linuxcnc-mill", {}}, progress), "bench");
    }

    TemporaryFolder folder_;
    std::optional<MillingContext> milling_;
    std::optional<ToolBounds> bounds_;
    std::optional<Project> project_;
    WorkspaceMapping mapping_;
    std::vector<StylusState> readings_;
};

} // namespace

void sampleScale(Session& session) {
    if (!session.wants("scale.samples")) return;
    Recordings recordings;
    const auto size = [](int step) { return static_cast<double>(Recordings::ticks(step)); };

    ScaledWork milling{"samples.mill"};
    milling.size = size;
    milling.prepare = [&](int step) { recordings.begin(step); };
    milling.work = [&](int step) {
        const TakeOutcome outcome = recordings.mill();
        session.check(outcome.samples == Recordings::ticks(step), "every tick is recorded");
        session.check(outcome.removed > 0.0, "the trace really mills");
    };
    scaleFigures(session, milling);

    const auto milled = [&](int step) {
        recordings.begin(step);
        (void)recordings.mill();
    };
    ScaledWork saving{"samples.save"};
    saving.size = size;
    saving.prepare = milled;
    saving.work = [&](int) { recordings.save(); };
    scaleFigures(session, saving);

    ScaledWork opening{"samples.open"};
    opening.size = size;
    opening.prepare = [&](int step) {
        milled(step);
        recordings.save();
        recordings.close();
    };
    opening.work = [&](int) {
        session.check(recordings.open() == recordings.workpieceVolume(), "the workpiece is as it was milled");
    };
    scaleFigures(session, opening);
}

} // namespace burin::benchmarks
