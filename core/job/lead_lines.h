// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/document/project.h"
#include "core/passes/pass_request.h"
#include "core/path/stroke.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace burin {

/// The strokes of a take as guide lines for a pass, smoothed so that no row contains the tremor of the hand. mm, setup
/// frame. Never empty.
using LeadLines = std::shared_ptr<const std::vector<PassLine>>;

/// Keeps the lines of takes, so that a take is read and smoothed again only when its strokes have changed. Thread-safe.
/// Takes of other projects do no harm: lines belong to the recording and to what of it counts.
class KeptLeads {
public:
    /// Null: they are not known, or the take is another one by now.
    LeadLines find(const TakeOutline& take) const;
    void keep(const TakeOutline& take, LeadLines lines);
    void forget();

private:
    struct Kept {
        TakeOutline take;
        LeadLines lines;
    };
    mutable std::mutex mutex_;
    std::map<std::int64_t, Kept> kept_; ///< by take
};

/// A take that leads a pass, as it was read from its project.
struct LeadTake {
    TakeOutline take;
    Tool tool;
    LeadLines lines{};       ///< if they were kept
    SourceStrokes strokes{}; ///< otherwise
};
/// Reads a take, unless its lines are kept. Errors: those of Project::takeOutline and toolFor; cancelled.
Result<LeadTake> readLead(const Project& project, std::int64_t take, const KeptLeads& kept, const Progress& progress);
/// The lines of a take, which are kept from now on. Needs no project. Cancellable. Errors: those of evaluate;
/// pathEmpty.
Result<LeadLines> linesOf(LeadTake lead, KeptLeads& kept, Progress& progress);

} // namespace burin
