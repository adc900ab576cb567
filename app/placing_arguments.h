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

/// The arguments for the placement of a part, as given by the user.
struct PlacingArguments {
    std::vector<std::string> align, turn;
    std::string move;

    bool empty() const { return align.empty() && turn.empty() && move.empty(); }
};

/// Declares --align, --turn and --move.
void addPlacing(CommandParser command, PlacingArguments& arguments);

/// Applies alignments first, then rotations, then the translation; rotations are about the centre of the part's
/// bounding box.
/// @param part before the placement. Errors: argumentInvalid, those of partFaceAt.
Result<Placement> placingOf(const PlacingArguments& arguments, std::shared_ptr<const Model> part, Progress& progress);

/// {"turn": three columns, "shift_mm"}
nlohmann::json jsonOf(const Placement& placement);
/// "turned by 90 degrees about 1, 0, 0, moved by 0, 0, 12 mm"; empty if there is none.
std::string textOf(const Placement& placement);

} // namespace burin
