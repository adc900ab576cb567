// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"

namespace burin {

/// Sets the unit of a model whose `lengthUnit` is set, and adds a note if it needs one: not mm, not stated by the file,
/// or not the one that it states.
/// @param unit mm, that the file states or that its format means @param stated whether the file states it
/// @param instead as ReadRequest::unitInstead
void setUnit(Model& model, double unit, bool stated, double instead);

} // namespace burin
