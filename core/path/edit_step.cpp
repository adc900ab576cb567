// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit_step.h"

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

Error refused(const EditTraits& edit, std::string allowed) {
    return Error{ErrorCode::argumentInvalid, "edits", std::string(edit.id), std::move(allowed)};
}

std::string text(std::string_view id) {
    return std::string(id);
}

} // namespace

Result<void> checkOrder(std::span<const Edit> edits) {
    std::vector<const EditTraits*> before;
    const EditTraits* entering = nullptr; // what may have led the path into the part
    for (const Edit& edit : edits) {
        if (!edit.enabled) continue;
        if (Result<void> valid = validate(edit); !valid) return valid;
        const EditTraits& traits = traitsOf(edit.parameters);
        if (traits.once && std::ranges::find(before, &traits) != before.end())
            return refused(traits, "one " + text(traits.id) + " in a path");
        if (!before.empty() && traits.step < before.back()->step)
            return refused(traits, text(traits.id) + " before " + text(before.back()->id));
        if (entering != nullptr && traits.step > EditStep::surface)
            return refused(traits, text(entering->id) + ", then hold-out, then " + text(traits.id));
        if (traits.mayEnter) entering = &traits;
        if (traits.holdsOut) entering = nullptr;
        before.push_back(&traits);
    }
    return {};
}

} // namespace burin
