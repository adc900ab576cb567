// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/take_score.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

// Texts for the display of scores.

QString scoreTitle(ScoreValue value);      ///< "Duration"
QString scoreDefinition(ScoreValue value); ///< a sentence
/// "12.3 s"; "–" if there is no value.
QString scoreText(ScoreValue value, const std::optional<double>& amount, LengthUnit unit);
/// "▲ better by 2.3 s (19 %)": the difference, and its percentage of the reference value.
QString verdictText(ScoreValue value, const ScoreVerdict& verdict, LengthUnit unit);

} // namespace burin
