// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit_step.h"

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

Error refused(ErrorCode code, const EditTraits& edit, const EditTraits* other = nullptr) {
    return Error{code, edit.title.text, other != nullptr ? other->title.text : "", {}};
}

Error unguarded(const EditTraits& entering, const EditTraits& relying) {
    Error error = refused(ErrorCode::editUnguarded, entering, &relying);
    error.detail = traitsOf(HoldOut{}).title.text;
    return error;
}

} // namespace

Result<void> checkOrder(std::span<const Edit> edits) {
    std::vector<const EditTraits*> before;
    const EditTraits* entering = nullptr; // edit that may have led the path into the part
    for (const Edit& edit : edits) {
        if (!edit.enabled) continue;
        if (Result<void> valid = validate(edit); !valid) return valid;
        const EditTraits& traits = traitsOf(edit.parameters);
        if (traits.once && std::ranges::find(before, &traits) != before.end())
            return refused(ErrorCode::editRepeated, traits);
        if (!before.empty() && traits.step < before.back()->step)
            return refused(ErrorCode::editMisplaced, traits, before.back());
        if (entering != nullptr && traits.step > EditStep::surface) return unguarded(*entering, traits);
        if (traits.mayEnter) entering = &traits;
        if (traits.holdsOut) entering = nullptr;
        before.push_back(&traits);
    }
    return {};
}

} // namespace burin
