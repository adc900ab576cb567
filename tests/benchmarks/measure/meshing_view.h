// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace burin::benchmarks {

/// Meshes what changed, on a thread of its own, as the window does: the newest snapshot counts, older ones are skipped.
/// Brick by brick, at full detail.
class MeshingView {
public:
    MeshingView() : thread_([this] { work(); }) {}
    ~MeshingView() { finish(); }
    MeshingView(const MeshingView&) = delete;
    MeshingView& operator=(const MeshingView&) = delete;

    /// From the loop: never waits. False when the view is just taking the one before; offer it again next tick.
    bool offer(VolumeSnapshot& snapshot) noexcept;
    void wake() noexcept { wake_.notify_one(); }
    /// What each picture took, µs: which bricks changed, and their surface. Once the loop is over.
    const std::vector<double>& pictures() const noexcept { return pictures_; }
    std::size_t bricks() const noexcept { return bricks_; }
    /// Waits for the picture that is being made.
    void finish();

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    VolumeSnapshot newest_;
    bool fresh_ = false, ended_ = false;
    std::vector<double> pictures_; ///< the thread's own until it ended
    std::size_t bricks_ = 0;
    std::thread thread_; // last: it uses the others
};

} // namespace burin::benchmarks
