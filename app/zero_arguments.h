// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/setup/program_zero.h"

#include <nlohmann/json.hpp>

#include <string>

namespace burin {

/// The arguments for program zero, as given by the user.
struct ZeroArguments {
    std::string zero, workOffset;

    bool empty() const { return zero.empty() && workOffset.empty(); }
};

/// Declares --zero and --work-offset.
void addZero(CommandParser command, ZeroArguments& arguments);

/// Applies the arguments to a program zero. @param part in the setup frame
/// Errors: argumentInvalid, those of partFaceAt.
Result<ProgramZero> changedZero(ProgramZero zero, const ZeroArguments& arguments, const Model& part,
                                Progress& progress);

/// {"work_offset", "on", "sides", "point_mm"}; only those of sides and point that apply.
nlohmann::json jsonOf(const ProgramZero& zero);
/// "G54, stock: X middle, Y middle, Z high".
std::string textOf(const ProgramZero& zero);

} // namespace burin
