// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace burin {

/// A pattern that matches English texts filled from this one; it captures the values of %1, %2 …
QRegularExpression patternOf(TextId text);

/// `text` with the first value for %1 and so on; in one pass, so that a value may itself contain "%2".
QString filled(const QString& text, const QStringList& values);

} // namespace burin
