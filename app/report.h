// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/job/program_job.h"
#include "core/machine/machine_profile.h"
#include "core/nc/lint.h"
#include "core/path/evaluate.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

// JSON of things that several commands report. Keys carry their unit (README.md).

nlohmann::json jsonOf(const glm::dvec3& v);
nlohmann::json jsonOf(const Box& box); ///< [[x, y, z], [x, y, z]]
nlohmann::json jsonOf(const Model& model);
nlohmann::json jsonOf(const Tool& tool);              ///< {"type", "diameter_mm", "corner_radius_mm", …}
nlohmann::json jsonOf(const MachineProfile& machine); ///< {"id", "name", "dialect", "typical"}
nlohmann::json jsonOf(const VerifyReport& report);
nlohmann::json jsonOf(const std::vector<EditReport>& reports);
nlohmann::json jsonOf(const std::vector<LintMark>& marks);

/// What edits left out and why, the longest first; lines that follow others, empty where there is nothing.
std::string textOfOmissions(const std::vector<EditReport>& reports);
/// How strokes that begin in material are entered, and where the tool plunges; lines that follow others, or nothing.
std::string textOfEntries(const std::vector<EditReport>& reports);
/// "(1.000, 2.000, 3.000) mm"
std::string placeText(const glm::dvec3& place);
/// The same for people, several lines.
std::string textOf(const Model& model);
/// What the check found, what the control would reject and the machine that the program was judged for.
std::string textOf(const CheckedProgram& program, double gougeTolerance, const MachineProfile& machine);

/// What is doubtful about a part, for JSON: what import said, in English, and what embedding found.
std::vector<std::string> doubtsOf(const Model& model, const EmbeddedSetup& embedded);
/// The same for people, as lines that follow others; empty where there is no doubt.
std::string textOfDoubts(const Model& model, const EmbeddedSetup& embedded);
/// Why a command does not go on with a part of which bodies are too small for the voxels to be protected, and how it
/// does all the same; empty where all are protected.
std::string unprotected(const EmbeddedSetup& embedded);

/// Why a program that failed its check was not written, and how it is all the same.
std::string notWritten(const std::string& file);

} // namespace burin
