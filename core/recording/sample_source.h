// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/recording/sample.h"

#include <functional>
#include <span>

namespace burin {

/// Receives the samples of a take in order, some thousands at a time; its first error ends the visit.
using SampleVisitor = std::function<Result<void>(std::span<const Sample>)>;
/// Visits all samples of a take, each time it is called. Errors: its own, and those of the visitor.
using SampleSource = std::function<Result<void>(const SampleVisitor& visit)>;

} // namespace burin
