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

/// Meshes changes in a thread of its own, as the window does: only the newest snapshot is used, older ones are skipped.
/// Brick by brick, at full detail.
class MeshingView {
public:
    MeshingView() : thread_([this] { work(); }) {}
    ~MeshingView() { finish(); }
    MeshingView(const MeshingView&) = delete;
    MeshingView& operator=(const MeshingView&) = delete;

    /// Called by the loop, never blocks. Returns false if the view is just taking the previous snapshot; then offer it
    /// again in the next tick.
    bool offer(VolumeSnapshot& snapshot) noexcept;
    void wake() noexcept { wake_.notify_one(); }
    /// The time for each picture, µs: finding the changed bricks and making their surface. To be called after the loop
    /// has ended.
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
    std::vector<double> pictures_; ///< owned by the thread until it has ended
    std::size_t bricks_ = 0;
    std::thread thread_; // last, as it uses the other members
};

} // namespace burin::benchmarks
