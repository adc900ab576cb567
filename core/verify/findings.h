// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"
#include "core/verify/verify.h"

#include <map>
#include <utility>

namespace burin {

/// What the user can do about a finding: the end of a sentence, marked for translation.
TextId remedyOf(FindingKind kind);

/// Whether `one` is worse than `other`, of the same kind, and is the one to show.
bool isWorse(const Finding& one, const Finding& other) noexcept;

/// Collects findings; of each kind and program line only the worst is kept.
class Findings {
public:
    void add(FindingKind kind, std::uint32_t line, const glm::dvec3& place, double amount);
    void add(const Finding& finding);
    std::vector<Finding> inProgramOrder() const;

private:
    std::map<std::pair<std::uint32_t, FindingKind>, Finding> worst_;
};

} // namespace burin
