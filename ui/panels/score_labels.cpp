// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/score_labels.h"

#include "ui/panels/quantity.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace burin {

namespace {

/// Translation context of the labels in this file.
struct ScoreLabels {
    Q_DECLARE_TR_FUNCTIONS(ScoreLabels)
};

QString inUserLanguage(const TextId& text) {
    return QCoreApplication::translate(text.context, text.text);
}

} // namespace

QString scoreTitle(ScoreValue value) {
    return inUserLanguage(titleOf(value));
}

QString scoreDefinition(ScoreValue value) {
    return inUserLanguage(toolTipOf(value));
}

QString scoreText(ScoreValue value, const std::optional<double>& amount, LengthUnit unit) {
    if (!amount) return QStringLiteral("–");
    switch (value) {
    case ScoreValue::duration:
    case ScoreValue::milling:
        return quantityText(std::round(*amount * 10.0) / 10.0, Quantity::time, unit);
    case ScoreValue::gougeTries:
        return countText(static_cast<std::size_t>(*amount));
    case ScoreValue::largestPush:
    case ScoreValue::meanStockLeft:
    case ScoreValue::mostStockLeft:
        return quantityText(*amount, Quantity::length, unit);
    case ScoreValue::smoothness:
        return QLocale().toString(*amount, 'f', 2);
    case ScoreValue::meanForce:
    case ScoreValue::peakForce:
        return quantityText(*amount, Quantity::force, unit);
    case ScoreValue::removed:
        return volumeText(*amount, unit);
    case ScoreValue::removalRate:
        return quantityText(*amount, Quantity::removalRate, unit);
    }
    return {};
}

QString verdictText(ScoreValue value, const ScoreVerdict& verdict, LengthUnit unit) {
    if (verdict.kind == ScoreVerdict::Kind::none) return QStringLiteral("–");
    if (verdict.kind == ScoreVerdict::Kind::same) return ScoreLabels::tr("the same");
    const bool better = verdict.kind == ScoreVerdict::Kind::better;
    const QString amount = scoreText(value, verdict.difference, unit);
    if (!verdict.ratio)
        return better ? ScoreLabels::tr("▲ better by %1").arg(amount) : ScoreLabels::tr("▼ worse by %1").arg(amount);
    const QString share = shareText(std::abs(*verdict.ratio - 1.0));
    return better ? ScoreLabels::tr("▲ better by %1 (%2)").arg(amount, share)
                  : ScoreLabels::tr("▼ worse by %1 (%2)").arg(amount, share);
}

} // namespace burin
