// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/unit_note.h"

#include "core/base/numbers.h"
#include "core/cad/file_unit.h"
#include "core/cad/import_notes.h"

#include <cmath>
#include <string>
#include <utility>

namespace burin {

using import_notes::fill;

namespace {

/// Empty: none is needed.
std::string unitNote(const Model& model, bool stated) {
    const std::string used = formatShortest(model.unitScale);
    const bool replaced = unitReplaced(model);
    if (!stated && !replaced && model.format == "BREP") return import_notes::brepWithoutUnit.text;
    if (!stated) return fill(import_notes::fileWithoutUnit, {used});
    if (replaced) return fill(import_notes::unitReplaced, {model.lengthUnit, formatShortest(model.statedUnit), used});
    if (std::abs(model.unitScale - 1.0) > 1e-12)
        return fill(import_notes::unitConverted, {model.lengthUnit, model.lengthUnit, used});
    return {};
}

} // namespace

void setUnit(Model& model, double unit, bool stated, double instead) {
    model.statedUnit = unit;
    model.unitScale = instead > 0.0 ? instead : unit;
    if (std::string note = unitNote(model, stated); !note.empty())
        model.notes.push_back({ImportNote::Kind::unit, std::move(note)});
}

} // namespace burin
