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

/// A path that is evaluated, and the tool that mills it.
struct MilledPath {
    std::shared_ptr<const EvaluatedPath> evaluated; ///< never null
    Tool tool;
};

/// The stock as paths leave it, one after the other. It is made when somebody asks for it first; what it looks like
/// after each of the paths asked for last is kept, so that a change of a later one cuts no earlier one again.
/// Thread-safe. Blocks while another caller holds the result.
class MilledStock {
public:
    /// @param make the stock before all paths
    explicit MilledStock(std::function<Result<RunVolume>(Progress&)> make) : make_(std::move(make)) {}
    MilledStock(const MilledStock&) = delete;
    MilledStock& operator=(const MilledStock&) = delete;

    /// Lends the stock as `paths`, in this order, leave it; what `use` cuts of it is forgotten. `use` is called again,
    /// with a stock made anew, where the memory of the one that is kept does not suffice.
    /// Errors: those of `make`, volumeOutOfMemory, cancelled, what `use` gives.
    Result<void> lend(std::span<const MilledPath> paths, const StockUse& use, Progress& progress);

    /// The stock before all paths, as a volume of its own: made anew. Waits for nobody. Errors: those of `make`.
    Result<RunVolume> makeStock(Progress& progress) const { return make_(progress); }

private:
    /// After the path of the same place; with all those before it.
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
