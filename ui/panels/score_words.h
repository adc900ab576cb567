// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/take_score.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

// How a score is worded for display.

QString scoreTitle(ScoreValue value);      ///< "Duration"
QString scoreDefinition(ScoreValue value); ///< a sentence
/// "12.3 s"; "–" of nothing.
QString scoreText(ScoreValue value, const std::optional<double>& amount, LengthUnit unit);
/// "▲ better by 2.3 s (19 %)": the difference, and its share of the reference.
QString verdictText(ScoreValue value, const ScoreVerdict& verdict, LengthUnit unit);

} // namespace burin
