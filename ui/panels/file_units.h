// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QComboBox;

namespace burin {

/// Fills a box with what a file that states no unit, an STL file, may mean by 1: the data of an item are its mm.
void addFileUnits(QComboBox& box);

} // namespace burin
