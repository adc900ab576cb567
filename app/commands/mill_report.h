// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling.h"

#include <nlohmann/json.hpp>

#include <string>

namespace burin {

/// What a recorded take did, as answered by `burin mill`.
nlohmann::json jsonOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties);
std::string textOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties);

} // namespace burin
