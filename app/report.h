// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/job/program_job.h"
#include "core/machine/machine_profile.h"
#include "core/nc/lint.h"
#include "core/path/evaluate.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

// JSON of objects that several commands report. Keys include their unit (README.md).

nlohmann::json jsonOf(const glm::dvec3& v);
nlohmann::json jsonOf(const Box& box); ///< [[x, y, z], [x, y, z]]
nlohmann::json jsonOf(const Model& model);
nlohmann::json jsonOf(const Tool& tool);              ///< {"type", "diameter_mm", "corner_radius_mm", …}
nlohmann::json jsonOf(const MachineProfile& machine); ///< {"id", "name", "dialect", "typical"}
nlohmann::json jsonOf(const VerifyReport& report);
nlohmann::json jsonOf(const std::vector<EditReport>& reports);
nlohmann::json jsonOf(const std::vector<LintMark>& marks);

/// What edits left out and why, the longest first; lines to append to others, empty if nothing was left out.
std::string textOfOmissions(const std::vector<EditReport>& reports);
/// How strokes that begin in material are entered, and where the tool plunges; lines to append to others, or empty.
std::string textOfEntries(const std::vector<EditReport>& reports);
/// "(1.000, 2.000, 3.000) mm"
std::string placeText(const glm::dvec3& place);
/// The model as readable text, several lines.
std::string textOf(const Model& model);
/// The findings of the check, what the control would reject, and the machine for which the program was checked.
std::string textOf(const CheckedProgram& program, double gougeTolerance, const MachineProfile& machine);

/// Doubts about a part, for JSON: messages of the import, in English, and findings of the embedding.
std::vector<std::string> doubtsOf(const Model& model, const EmbeddedSetup& embedded);
/// The same as readable text, lines to append to others; empty if there are none.
std::string textOfDoubts(const Model& model, const EmbeddedSetup& embedded);
/// [{"name", "in_stock_mm", "gap_mm": null if there is no stock where it clamps, "text"}]
nlohmann::json jsonOf(const std::vector<BadFit>& fixtures);
/// The same as readable text, lines to append to others; empty if there are none.
std::string textOf(const std::vector<BadFit>& fixtures);
/// Why a command refuses a part with bodies too small for the voxels to be protected, and how to continue nevertheless;
/// empty if all bodies are protected.
std::string unprotected(const EmbeddedSetup& embedded);

/// Why a program that failed its check was not written, and how to write it nevertheless.
std::string notWritten(const std::string& file);

} // namespace burin
