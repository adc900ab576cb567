// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/progress.h"
#include "core/cad/model.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// What the command line says of how a part is to lie, as it was written.
struct PlacingArguments {
    std::vector<std::string> align, turn;
    std::string move;

    bool empty() const { return align.empty() && turn.empty() && move.empty(); }
};

/// Declares --align, --turn and --move.
void addPlacing(CommandParser command, PlacingArguments& arguments);

/// First what is aligned, then turned, then moved; turns leave the middle of the part's box where it is.
/// @param part as it lies before. Errors: argumentInvalid, those of partFaceAt.
Result<Placement> placingOf(const PlacingArguments& arguments, std::shared_ptr<const Model> part, Progress& progress);

/// {"turn": three columns, "shift_mm"}
nlohmann::json jsonOf(const Placement& placement);
/// "turned by 90 degrees about 1, 0, 0, moved by 0, 0, 12 mm"; empty for none.
std::string textOf(const Placement& placement);

} // namespace burin
