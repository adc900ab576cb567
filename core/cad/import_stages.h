// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace burin {

/// What the import program is doing, in the order of its work.
enum class ImportStage : std::uint8_t {
    none,         ///< it has not said
    reading,      ///< the text of the file; amounts: MB read, MB in total
    readingBlind, ///< the same by a reader that reports nothing; amounts: 0, MB in total
    interpreting, ///< the entities of the file; its reader reports nothing
    converting,   ///< entities to shapes; progress as the reader reports it
    checking,     ///< and repairing; amounts: solids that are done, solids in total
    meshing       ///< amounts: the number of the body, number of bodies
};

/// In the order of ImportStage; %1, %2: the amounts.
inline constexpr std::array importStageTexts{
    TextId{},
    BURIN_TEXT("ImportStage", "reading the file, %1 of %2 MB"),
    BURIN_TEXT("ImportStage", "reading the file of %2 MB (this step cannot be measured)"),
    BURIN_TEXT("ImportStage", "interpreting the file (this step cannot be measured)"),
    BURIN_TEXT("ImportStage", "converting the shapes"),
    BURIN_TEXT("ImportStage", "checking the solids, %1 of %2"),
    BURIN_TEXT("ImportStage", "meshing, body %1 of %2")};

/// Static, for Progress::describe.
inline const TextId& textOf(ImportStage stage) noexcept {
    return importStageTexts[static_cast<std::size_t>(stage)];
}

} // namespace burin
