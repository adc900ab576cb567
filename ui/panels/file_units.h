// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QComboBox;

namespace burin {

/// Fills a box with the possible units of a file that states none (STL). The data of each item is the size of the unit
/// in mm.
void addFileUnits(QComboBox& box);

} // namespace burin
