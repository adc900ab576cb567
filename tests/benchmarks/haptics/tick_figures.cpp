// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/haptic_step.h"
#include "core/project/recorder.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/haptics/tick_scene.h"
#include "tests/benchmarks/measure/meshing_view.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/measure/tick_watch.h"

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <unistd.h>

namespace burin::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr double paperRate = 900.0;     // Hz (paper, 4.3.5)
constexpr std::size_t ticks = 60'000;   // 60 s of the hand at 1 kHz
constexpr std::size_t passTicks = 6000; // the workpiece is made whole again then: a milled block is soon all air

/// A project in a folder of its own that goes with it.
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

/// What goes on beside a loop: its samples go to the disk, what it cuts is meshed.
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

double processorMicroseconds() noexcept {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

struct TickCosts {
    std::vector<double> microseconds = std::vector<double>(ticks);
    std::size_t onBoundary = 0, cutting = 0;
};

void count(const Sample& sample, RunAmounts& removed) noexcept {
    for (const RemovedMaterial& material : sample.removed) removed.units[material.property] += material.units;
}

/// Mills for 60 s of the hand's time as fast as it goes; processor time of the loop's thread alone, from reading the
/// hand to handing the sample over.
TickCosts costsOf(TickScene& scene, Beside* beside, Session& session) {
    TickCosts costs;
    TickWatch watch;
    const VolumeSnapshot whole = scene.workpiece.snapshot();
    const RunAmounts before = whole.amounts();
    StylusState state;
    state.valid = true;
    state.buttons = 1;
    for (std::size_t first = 0; first < ticks; first += passTicks) {
        Session::throwIfCancelled();
        scene.workpiece.restore(whole);
        HapticStep step(scene.workpiece, *scene.field, scene.tool, scene.settings);
        RunAmounts removed;
        VolumeSnapshot waiting;
        bool offered = true;
        watch.begin();
        for (std::size_t i = first; i < first + passTicks; ++i) {
            const double start = processorMicroseconds();
            state.time = 0.001 * static_cast<double>(i);
            state.pose.position = scene.hand[i];
            const Sample sample = step(state, scene.settings.tickPeriod);
            if (beside != nullptr) {
                beside->ring.push(sample);
                if (i % 16 == 0) {
                    waiting = scene.workpiece.snapshot();
                    offered = false;
                }
                if (!offered && (offered = beside->view.offer(waiting))) beside->view.wake();
            }
            costs.microseconds[i] = processorMicroseconds() - start;
            count(sample, removed);
            costs.onBoundary += (sample.flags & sampleOnBoundary) != 0 ? 1U : 0U;
            costs.cutting += sample.reportedRemoval > 0.0 ? 1U : 0U;
            while (beside != nullptr && 2 * beside->ring.size() > beside->ring.capacity())
                ::usleep(1000); // the disk's turn
        }
        watch.end();
        step.settle();
        const RunAmounts after = scene.workpiece.snapshot().amounts();
        std::size_t mismatches = 0;
        for (std::size_t p = 1; p < after.units.size(); ++p)
            mismatches += before.units[p] - removed.units[p] == after.units[p] ? 0U : 1U;
        session.countMismatches(mismatches);
    }
    session.countInterruptions(watch.allocations(), watch.pageFaults());
    return costs;
}

void addCosts(Session& session, const std::string& stem, const TickCosts& costs) {
    const auto share = [](std::size_t some) { return static_cast<double>(some) / static_cast<double>(ticks); };
    double sum = 0.0;
    for (const double cost : costs.microseconds) sum += cost;
    session.add(figure(stem + ".cpu_us.p50", percentile(costs.microseconds, 0.5), "us", 50.0));
    session.add(figure(stem + ".cpu_us.p999", percentile(costs.microseconds, 0.999), "us", 300.0));
    session.add(figure(stem + ".cpu_us.max", percentile(costs.microseconds, 1.0), "us", 700.0));
    Figure rate = figure(stem + ".rate_hz", 1e6 * static_cast<double>(ticks) / sum, "Hz", 4000.0);
    rate.atLeast = true;
    session.add(against(std::move(rate), "the paper's loop, as published", paperRate));
    session.add(figure(stem + ".share_on_boundary", share(costs.onBoundary), "1"));
    session.add(figure(stem + ".share_cutting", share(costs.cutting), "1"));
}

} // namespace

void tickFigures(Session& session) {
    if (!session.wants("tick.")) return;
    if (session.wants("tick.cpu_us") || session.wants("tick.rate_hz")) {
        session.stage("tick.cpu_us");
        TickScene scene = paperBlock(5.0, ticks); // the paper's radius of 0.5 as half a millimetre in voxels of 0.1
        addCosts(session, "tick", costsOf(scene, nullptr, session));
    }
    for (const std::int32_t side : {512, 1024})
        for (const int radius : {25, 50}) {
            const std::string stem = "tick." + std::to_string(side) + ".r" + std::to_string(radius);
            if (!session.wants(stem)) continue;
            session.stage(stem);
            TemporaryProject project;
            TickScene scene = buriedPart(side, radius, ticks);
            Beside beside(*project, scene.tool);
            addCosts(session, stem, costsOf(scene, &beside, session));
        }
}

} // namespace burin::benchmarks
