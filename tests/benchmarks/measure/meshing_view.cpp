// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/meshing_view.h"

#include "core/volume/surface/surface.h"
#include "tests/benchmarks/measure/replay.h"

namespace burin::benchmarks {

bool MeshingView::offer(VolumeSnapshot& snapshot) noexcept {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return false;
    std::swap(newest_, snapshot); // the caller releases the other one
    fresh_ = true;
    return true;
}

void MeshingView::finish() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void MeshingView::work() {
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    std::vector<SurfaceBrick> changed;
    VolumeSnapshot shown;
    for (;;) {
        VolumeSnapshot next;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return fresh_ || ended_; });
            if (ended_) return;
            fresh_ = false;
            next = std::move(newest_);
        }
        if (!shown.empty()) {
            const Clock::time_point start = Clock::now();
            changedSurfaceBricks(shown, next, changed);
            for (const SurfaceBrick brick : changed) extractor.extractBrick(next, brick, mesh);
            bricks_ += changed.size();
            pictures_.push_back(microseconds(Clock::now() - start));
        }
        shown = std::move(next);
    }
}

} // namespace burin::benchmarks
