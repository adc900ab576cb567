// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/milled_stock.h"

#include "core/path/path_removal.h"

#include <chrono>

namespace burin {

namespace {

/// Progress values at the end of making the stock and of cutting the paths before; the rest is for the use of the
/// stock.
constexpr double madeShare = 0.3, cutShare = 0.6;

} // namespace

Result<void> MilledStock::lend(std::span<const MilledPath> paths, const StockUse& use, Progress& progress) {
    std::unique_lock mine(owner_, std::defer_lock);
    // The present holder can take seconds, during which a cancellation must be noticed.
    while (!mine.try_lock_for(std::chrono::milliseconds(5)))
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "stock", "", ""};
    Result<void> done = lendKept(paths, use, progress);
    if (done || done.error().code != ErrorCode::volumeOutOfMemory) return done;
    // The kept states occupy memory that the paths may need.
    states_.clear();
    untouched_ = {};
    stock_.reset();
    return lendAnew(paths, use, progress);
}

Result<void> MilledStock::lendKept(std::span<const MilledPath> paths, const StockUse& use, Progress& progress) {
    if (!stock_) {
        const ProgressPart part(progress, 0.0, madeShare);
        Result<RunVolume> stock = make_(progress);
        if (!stock) return stock.error();
        stock_ = std::move(*stock);
        untouched_ = stock_->snapshot();
    }
    std::size_t known = 0;
    while (known < states_.size() && known < paths.size() && states_[known].after == paths[known].evaluated) ++known;
    if (known < paths.size()) states_.resize(known); // those of other paths are obsolete
    stock_->restore(known == 0 ? untouched_ : states_[known - 1].stock);
    for (std::size_t i = known; i < paths.size(); ++i) {
        const double share = (cutShare - madeShare) / static_cast<double>(paths.size());
        const ProgressPart part(progress, madeShare + share * static_cast<double>(i),
                                madeShare + share * static_cast<double>(i + 1));
        const MilledPath& path = paths[i];
        if (Result<void> done = cutPath(path.evaluated->path, path.tool.cutter, *stock_, progress); !done) return done;
        states_.push_back({path.evaluated, stock_->snapshot()});
    }
    const ProgressPart part(progress, cutShare, 1.0);
    return use(*stock_);
}

Result<void> MilledStock::lendAnew(std::span<const MilledPath> paths, const StockUse& use, Progress& progress) const {
    Result<RunVolume> stock = make_(progress);
    if (!stock) return stock.error();
    for (const MilledPath& path : paths)
        if (Result<void> done = cutPath(path.evaluated->path, path.tool.cutter, *stock, progress); !done) return done;
    return use(*stock);
}

} // namespace burin
