// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_fit.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// Why a fixture doesn't fit the stock, as a sentence; empty if it does. @param name of the fixture
QString fitText(const std::string& name, const FixtureFit& fit, LengthUnit unit);

} // namespace burin
