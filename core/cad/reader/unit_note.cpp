// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/unit_note.h"

#include "core/base/numbers.h"
#include "core/cad/file_unit.h"
#include "core/cad/import_notes.h"

#include <cmath>

namespace burin {

using import_notes::fill;

std::optional<ImportNote> unitNote(const Model& model, bool stated) {
    const auto note = [](std::string text) { return ImportNote{ImportNote::Kind::unit, std::move(text)}; };
    const std::string used = formatShortest(model.unitScale);
    if (unitReplaced(model))
        return note(stated
                        ? fill(import_notes::unitReplaced, {model.lengthUnit, formatShortest(model.statedUnit), used})
                        : fill(import_notes::fileWithoutUnit, {used}));
    if (!stated) return note(import_notes::brepWithoutUnit.text);
    if (std::abs(model.unitScale - 1.0) > 1e-12)
        return note(fill(import_notes::unitConverted, {model.lengthUnit, model.lengthUnit, used}));
    return std::nullopt;
}

} // namespace burin
