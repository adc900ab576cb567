// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/recording/sample.h"
#include "core/recording/sample_source.h"

#include <filesystem>

namespace burin {

/// Writes the stylus data of a take as a trace that mills the same when it is played (trace_file.h). If the spindle
/// stopped in the take, or strokes of it do not count, the trace is one of ticks with these changes: strokes that were
/// undone or switched off are milled and then undone where they end. An interval that does not count and begins within
/// a stroke is passed through with the spindle stopped. Otherwise the trace consists of the valid readings alone. The
/// file is written completely or not at all. Errors: fileNotWritable, diskFull, those of `samples`.
Result<void> writeTakeTrace(const std::filesystem::path& file, const TakeOutline& take, const SampleSource& samples);

} // namespace burin
