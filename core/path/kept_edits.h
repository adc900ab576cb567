// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"
#include "core/path/evaluate.h"
#include "core/path/stroke.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace burin {

/// A path after some of its edits, with their reports.
struct EditedState {
    PathUnderEdit path;
    std::vector<EditReport> reports;
    double errorBudget = 0.0; ///< mm, as EvaluatedPath::errorBudget
};

/// The states of a path between its edits, kept from one evaluation to the next, so that a change of one edit applies
/// only this edit and those after it. Belongs to one path with the same sources, and to one state of part, stock and
/// fixtures, and to the same paths before it: its owner begins a new object when these change. The evaluation itself
/// discards what other edits, tools, machines or cutting data have made. One thread at a time.
class KeptEdits {
public:
    /// Memory that the states may occupy; beyond it, those after fewer edits are discarded first.
    static constexpr std::size_t mostBytes = 400'000'000;

    /// States of other edits, or of the same edits in another context, are discarded.
    void begin(const std::vector<Edit>& edits, const PathContext& context);
    /// Returns the number of the first edits that the state returned by `newest` is after; 0: none is kept.
    std::size_t count() const noexcept { return states_.empty() ? 0 : states_.rbegin()->first; }
    const EditedState& newest() const { return states_.rbegin()->second; } ///< `count` must not be 0
    /// Keeps the state after the first `count` edits.
    void keep(std::size_t count, const EditedState& state);
    /// Memory that the states occupy, with their reports, and the trails of the sources that they share.
    std::size_t bytes() const noexcept;

private:
    std::string context_;
    std::vector<std::string> edits_;
    std::map<std::size_t, EditedState> states_; ///< by the number of edits before it
    std::size_t bytes_ = 0;
};

} // namespace burin
