// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "ui/theme/length_unit.h"

class QComboBox;

namespace burin {

/// Fills a box with the possible units of a file that states none (STL). The data of each item is the size of the unit
/// in mm.
void addFileUnits(QComboBox& box);

/// Offers the units that a model's file can be read in, and the one that is used: the items' data is as above, the
/// tooltip is the size of the model in that unit. The unit that the file states is marked.
void offerFileUnits(QComboBox& box, const Model& model, LengthUnit shown);

} // namespace burin
