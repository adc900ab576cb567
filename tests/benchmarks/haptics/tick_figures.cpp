// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/tick_thread.h"
#include "core/job/recorder.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/haptics/tick_scene.h"
#include "tests/benchmarks/measure/meshing_view.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/oracles/system_watch.h"

#include <cstdio>
#include <filesystem>
#include <limits>
#include <unistd.h>

namespace burin::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr double paperRate = 900.0;     // Hz (paper, 4.3.5)
constexpr std::size_t ticks = 60'000;   // 60 s of the hand at 1 kHz
constexpr std::size_t passTicks = 6000; // the workpiece is restored then: a milled block is soon all air
constexpr int replays = 4;

/// A project in its own folder, which is deleted with the object.
class TemporaryProject {
public:
    TemporaryProject() : folder_(fs::temp_directory_path() / ("burin-bench-haptics-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        project_.emplace(require(Project::create(folder_ / "ticks.burin"), "a benchmark's project"));
    }
    ~TemporaryProject() {
        project_.reset();
        std::error_code unheard;
        fs::remove_all(folder_, unheard);
    }
    TemporaryProject(const TemporaryProject&) = delete;
    TemporaryProject& operator=(const TemporaryProject&) = delete;
    Project& operator*() { return *project_; }

private:
    fs::path folder_;
    std::optional<Project> project_;
};

/// Work alongside the loop: its samples are written to the disk, its cuts are meshed.
struct Beside {
    explicit Beside(Project& project, const Tool& tool) : ring(16384) {
        if (const Result<void> kept = project.setTool(tool); !kept) throw std::runtime_error(kept.error().subject);
        TakeInfo info;
        info.name = "benchmark";
        info.toolId = tool.id;
        recorder.emplace(ring, require(project.beginTake(info), "a take"));
    }
    Ring<Sample> ring;
    std::optional<Recorder> recorder;
    MeshingView view;
};

struct TickCosts {
    std::vector<double> microseconds = std::vector<double>(ticks, std::numeric_limits<double>::infinity());
    std::size_t onBoundary = 0, cutting = 0; ///< ticks of one replay
};

/// One pass of the hand over an uncut workpiece.
class Pass {
public:
    Pass(TickScene& scene, Beside* beside)
        : scene_(scene), beside_(beside), step_(scene.workpiece, *scene.field, scene.tool, scene.settings) {}

    /// From reading the hand to delivering the sample.
    Sample tick(std::size_t i) noexcept {
        state_.time = 0.001 * static_cast<double>(i);
        state_.pose.position = scene_.hand[i];
        state_.buttons = 1;
        state_.valid = true;
        const Sample sample = step_.advance(state_, scene_.settings.tickPeriod);
        for (const RemovedMaterial& material : sample.removed) removed_.units[material.property] += material.units;
        if (beside_ != nullptr) handOver(sample, i);
        return sample;
    }
    /// Called between two ticks, not timed: lets the disk catch up.
    void waitForDisk() const {
        while (beside_ != nullptr && 2 * beside_->ring.size() > beside_->ring.capacity()) ::usleep(1000);
    }
    /// The number of properties whose loss differs from what the samples report.
    std::size_t mismatches(const RunAmounts& before) {
        step_.settle();
        const RunAmounts after = scene_.workpiece.snapshot().amounts();
        std::size_t count = 0;
        for (std::size_t p = 1; p < after.units.size(); ++p)
            count += before.units[p] - removed_.units[p] == after.units[p] ? 0U : 1U;
        return count;
    }

private:
    void handOver(const Sample& sample, std::size_t i) noexcept {
        beside_->ring.push(sample);
        if (i % 16 == 0) {
            waiting_ = scene_.workpiece.snapshot();
            offered_ = false;
        }
        if (!offered_ && (offered_ = beside_->view.offer(waiting_))) beside_->view.wake();
    }

    TickScene& scene_;
    Beside* beside_;
    HapticStep step_;
    StylusState state_;
    RunAmounts removed_;
    VolumeSnapshot waiting_;
    bool offered_ = true;
};

/// Mills for 60 s of the hand's time as fast as possible; processor time of the loop's thread only. Intrinsic: every
/// pass is replayed, and the least time of each tick is kept.
TickCosts costsOf(TickScene& scene, Beside* beside, Session& session) {
    TickCosts costs;
    const VolumeSnapshot whole = scene.workpiece.snapshot();
    const RunAmounts before = whole.amounts();
    for (std::size_t first = 0; first < ticks; first += passTicks)
        for (int replay = 0; replay < replays; ++replay) {
            Session::throwIfCancelled();
            scene.workpiece.restore(whole);
            Pass pass(scene, beside);
            for (std::size_t i = first; i < first + passTicks; ++i) {
                const double start = processorMicroseconds();
                const Sample sample = pass.tick(i);
                costs.microseconds[i] = std::min(costs.microseconds[i], processorMicroseconds() - start);
                costs.onBoundary += replay == 0 && (sample.flags & sampleOnBoundary) != 0 ? 1U : 0U;
                costs.cutting += replay == 0 && sample.reportedRemoval > 0.0 ? 1U : 0U;
                pass.waitForDisk();
            }
            session.countMismatches(pass.mismatches(before));
        }
    return costs;
}

/// The system resources that a pass uses from its second tick on.
tests::SystemUse demandsOf(TickScene& scene) {
    const VolumeSnapshot whole = scene.workpiece.snapshot();
    makeCodeResident(); // as the loop does before its first tick
    Pass pass(scene, nullptr);
    tests::SystemWatch watch;
    pass.tick(0);
    watch.begin();
    for (std::size_t i = 1; i < passTicks; ++i) pass.tick(i);
    const tests::SystemUse cost = watch.end();
    scene.workpiece.restore(whole);
    return cost;
}

void addDemands(Session& session, const tests::SystemUse& demands) {
    const auto add = [&](const char* name, std::uint64_t count) {
        session.add(figure(name, static_cast<double>(count), "calls", 0.0));
    };
    if (!tests::SystemWatch().counts()) {
        session.note(
            "This kernel or build can't count what a tick asks of the system: tick.allocations, tick.locks and "
            "tick.syscalls are left out.");
        return;
    }
    add("tick.allocations", demands.allocations + demands.releases);
    add("tick.locks", demands.locks);
    add("tick.syscalls", demands.systemCalls);
    add("tick.page_faults", demands.pageFaults);
}

void addCosts(Session& session, const std::string& stem, const TickCosts& costs) {
    const auto share = [](std::size_t some) { return static_cast<double>(some) / static_cast<double>(ticks); };
    const std::vector<double> least = session.least(stem, costs.microseconds);
    double sum = 0.0;
    for (const double cost : least) sum += cost;
    session.add(figure(stem + ".cpu_us.p50", percentile(least, 0.5), "us", 50.0));
    session.add(figure(stem + ".cpu_us.p999", percentile(least, 0.999), "us", 300.0));
    session.add(figure(stem + ".cpu_us.max", percentile(least, 1.0), "us", 700.0));
    Figure rate = figure(stem + ".rate_hz", 1e6 * static_cast<double>(ticks) / sum, "Hz", 4000.0);
    rate.atLeast = true;
    session.add(against(std::move(rate), "the paper's loop, as published", paperRate));
    session.add(figure(stem + ".share_on_boundary", share(costs.onBoundary), "1"));
    session.add(figure(stem + ".share_cutting", share(costs.cutting), "1"));
}

} // namespace

void tickFigures(Session& session) {
    if (!session.wants("tick.")) return;
    tests::SystemUse demands;
    const auto measure = [&](const std::string& stem, TickScene scene, Beside* beside) {
        const tests::SystemUse one = demandsOf(scene);
        demands.allocations += one.allocations;
        demands.releases += one.releases;
        demands.locks += one.locks;
        demands.systemCalls += one.systemCalls;
        demands.pageFaults += one.pageFaults;
        addCosts(session, stem, costsOf(scene, beside, session));
    };
    session.stage("tick.cpu_us");
    measure("tick", paperBlock(5.0, ticks), nullptr); // the paper's 0.5 taken as half a millimetre in voxels of 0.1
    for (const std::int32_t side : {512, 1024})
        for (const int radius : {25, 50}) {
            const std::string stem = "tick." + std::to_string(side) + ".r" + std::to_string(radius);
            if (!session.wants(stem)) continue;
            session.stage(stem);
            TickScene scene = buriedPart(side, radius, ticks);
            TemporaryProject project;
            Beside beside(*project, scene.tool);
            measure(stem, std::move(scene), &beside);
        }
    addDemands(session, demands);
}

} // namespace burin::benchmarks
