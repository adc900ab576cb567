// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace burin {

/// What matches a text that was filled from this one in English; it captures the values of %1, %2 …
QRegularExpression patternOf(TextId text);

/// `text` with the first value for %1 and so on; in one pass, so that a value may itself hold "%2".
QString filled(const QString& text, const QStringList& values);

} // namespace burin
