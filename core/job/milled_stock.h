// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// An evaluated path, and the tool that mills it.
struct MilledPath {
    std::shared_ptr<const EvaluatedPath> evaluated; ///< never null
    Tool tool;
};

/// The stock as left by paths that are milled one after the other. It is made on the first request. Its states after
/// each path of the latest request are kept, so that a change of one path does not cut the earlier ones again.
/// Thread-safe. Blocks while another caller holds the result.
class MilledStock {
public:
    /// @param make makes the stock before all paths
    explicit MilledStock(std::function<Result<RunVolume>(Progress&)> make) : make_(std::move(make)) {}
    MilledStock(const MilledStock&) = delete;
    MilledStock& operator=(const MilledStock&) = delete;

    /// Lends the stock as left by `paths` in this order; what `use` cuts from it is discarded. If the memory of the
    /// kept stock does not suffice, `use` is called again with a newly made stock.
    /// Errors: those of `make`, volumeOutOfMemory, cancelled, those of `use`.
    Result<void> lend(std::span<const MilledPath> paths, const StockUse& use, Progress& progress);

    /// Returns the stock before all paths as a newly made, separate volume. Does not block. Errors: those of `make`.
    Result<RunVolume> makeStock(Progress& progress) const { return make_(progress); }

private:
    /// The stock after the path with the same index and all preceding ones.
    struct State {
        std::shared_ptr<const EvaluatedPath> after;
        VolumeSnapshot stock;
    };
    Result<void> lendKept(std::span<const MilledPath> paths, const StockUse& use, Progress& progress);
    Result<void> lendAnew(std::span<const MilledPath> paths, const StockUse& use, Progress& progress) const;

    std::function<Result<RunVolume>(Progress&)> make_;
    std::timed_mutex owner_; ///< of what follows
    std::optional<RunVolume> stock_;
    VolumeSnapshot untouched_;
    std::vector<State> states_;
};

} // namespace burin
