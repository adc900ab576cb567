// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <cstddef>

class IGESData_IGESModel;
class StepData_StepModel;

namespace burin {

// Notes on what a file has and a model does not keep.

/// @param count faces whose colour the repair of a solid lost
void noteLostFaceColours(CadFile& file, std::size_t count);
void noteLeftOut(CadFile& file, const StepData_StepModel& model);
void noteLeftOut(CadFile& file, const IGESData_IGESModel& model);

} // namespace burin
