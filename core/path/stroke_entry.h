// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// How the tool descends to a stroke that begins in material.
enum class EntryForm : std::uint8_t {
    plunge, ///< straight down, as there is no room for the others
    ramp,   ///< back and forth along the beginning of the stroke
    helix,  ///< in turns beside the stroke
};
/// Stable id, for JSON: "plunge", "ramp", "helix".
constexpr const char* idOf(EntryForm form) noexcept {
    return form == EntryForm::plunge ? "plunge" : form == EntryForm::ramp ? "ramp" : "helix";
}

/// The entry that a link made where a stroke begins in material.
struct StrokeEntry {
    EntryForm form = EntryForm::plunge;
    std::int64_t source = 0;  ///< PathSource::id
    std::int64_t sample = -1; ///< Moment::tick
    glm::dvec3 tip{0.0};      ///< mm, setup frame, end of the entry
    double depth = 0.0;       ///< mm of material above the tip
};

inline std::size_t countOf(std::span<const StrokeEntry> entries, EntryForm form) {
    return static_cast<std::size_t>(std::ranges::count(entries, form, &StrokeEntry::form));
}

} // namespace burin
