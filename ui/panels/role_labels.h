// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <QString>

namespace burin {

// Labels of the panels for the roles of bodies and the forms of stock. For display only.

QString roleText(BodyRole role);
QString roleToolTip();
QString stockFormText(StockForm form);

} // namespace burin
