// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <QString>

namespace burin {

// How panels word what bodies and stock are. For display alone.

QString roleText(BodyRole role);
QString roleToolTip();
QString stockFormText(StockForm form);

} // namespace burin
