// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/generated_moves.h"

#include "core/recording/tool_place.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

Error wrong(std::size_t stroke, std::size_t point, const char* allowed) {
    return {ErrorCode::argumentInvalid, "generated moves",
            "stroke " + std::to_string(stroke + 1) + ", point " + std::to_string(point + 1), allowed};
}

} // namespace

Result<void> checkGenerated(const GeneratedMoves& moves) {
    if (!(moves.info.allowance >= 0.0 && moves.info.allowance <= largestAllowance))
        return Error{ErrorCode::argumentInvalid, "generated moves", "allowance", "0 to 10 mm"};
    using Span = std::pair<std::int64_t, std::int64_t>; // moments of a stroke, first and last
    std::vector<std::pair<Span, std::size_t>> spans;
    for (std::size_t s = 0; s < moves.strokes.size(); ++s) {
        const std::vector<GeneratedPoint>& stroke = moves.strokes[s];
        if (stroke.empty()) return wrong(s, 0, "a point at least");
        std::int64_t last = -1;
        for (std::size_t p = 0; p < stroke.size(); ++p) {
            if (!isToolPlace(stroke[p].pose)) return wrong(s, p, "a place within 1e6 mm and an axis of unit length");
            for (const double stated : {stroke[p].feed, stroke[p].spindleSpeed})
                if (!(stated >= 0.0) || !std::isfinite(stated)) return wrong(s, p, "a finite feed and speed");
            if (stroke[p].moment <= last) return wrong(s, p, "moments that rise from 0 on");
            last = stroke[p].moment;
        }
        spans.push_back({{stroke.front().moment, last}, s});
    }
    std::ranges::sort(spans);
    for (std::size_t i = 1; i < spans.size(); ++i)
        if (spans[i].first.first <= spans[i - 1].first.second)
            return wrong(spans[i].second, 0, "moments that no other stroke has among its own");
    return {};
}

} // namespace burin
