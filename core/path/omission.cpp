// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/omission.h"

#include <algorithm>
#include <functional>

namespace burin {

const char* idOf(OmissionReason reason) {
    switch (reason) {
    case OmissionReason::part:
        return "part";
    case OmissionReason::access:
        return "access";
    case OmissionReason::shank:
        return "shank";
    case OmissionReason::holder:
        return "holder";
    case OmissionReason::plunge:
        return "plunge";
    }
    return "";
}

TextId textOf(OmissionReason reason) {
    switch (reason) {
    case OmissionReason::part:
        return BURIN_TEXT("Omission",
                          "There is no tool motion past the part here. Use a smaller tool or a smaller allowance.");
    case OmissionReason::access:
        return BURIN_TEXT("Omission", "The tool cannot reach this point from above without entering the part. Use a "
                                      "smaller tool, or mill it from another side.");
    case OmissionReason::shank:
        return BURIN_TEXT("Omission",
                          "The shank would enter material here. Mill the material around it first, or use a "
                          "tool with longer flutes.");
    case OmissionReason::holder:
        return BURIN_TEXT("Omission",
                          "The holder would enter material here. Mill the material around it first, or use a "
                          "tool with a longer stick-out.");
    case OmissionReason::plunge:
        return BURIN_TEXT("Omission",
                          "There is no room for a ramp or helix down into the material here, and the tool cannot "
                          "plunge. Begin beside the material, or use a centre-cutting tool.");
    }
    return {};
}

TextId remedyOf(OmissionReason reason) {
    switch (reason) {
    case OmissionReason::part:
        return BURIN_TEXT("Omission", "use a smaller tool or a smaller allowance");
    case OmissionReason::access:
        return BURIN_TEXT("Omission", "use a smaller tool, or mill it from another side");
    case OmissionReason::shank:
        return BURIN_TEXT("Omission", "mill the material around it first, or use a tool with longer flutes");
    case OmissionReason::holder:
        return BURIN_TEXT("Omission", "mill the material around it first, or use a tool with a longer stick-out");
    case OmissionReason::plunge:
        return BURIN_TEXT("Omission", "begin beside the material, or use a centre-cutting tool");
    }
    return {};
}

double lengthOf(std::span<const Omission> parts) noexcept {
    double length = 0.0;
    for (const Omission& part : parts) length += part.length;
    return length;
}

std::vector<const Omission*> longestFirst(std::span<const Omission> parts) {
    std::vector<const Omission*> sorted;
    for (const Omission& part : parts) sorted.push_back(&part);
    std::ranges::stable_sort(sorted, std::ranges::greater(), &Omission::length);
    return sorted;
}

} // namespace burin
