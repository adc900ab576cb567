// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// Describes a doubtful finding of the embedding, how it was treated and the remedy; ends with a full stop.
QString embeddingText(const EmbeddingFinding& finding, LengthUnit unit);

} // namespace burin
