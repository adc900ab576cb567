// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/picture_options.h"

#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "ui/scene/picture.h"

#include <map>

namespace burin {
namespace {

const std::map<std::string, StandardView> views{{"back", StandardView::back},   {"bottom", StandardView::bottom},
                                                {"front", StandardView::front}, {"isometric", StandardView::isometric},
                                                {"left", StandardView::left},   {"right", StandardView::right},
                                                {"top", StandardView::top}};

Error unreadable(const std::string& section) {
    return {ErrorCode::argumentInvalid, "--section", section,
            worded(BURIN_TEXT("Command", "X=, Y= or Z= and a position in mm, such as X=12.5"))};
}

Result<PictureSection> sectionOf(const std::string& text) {
    constexpr std::string_view axes = "XYZ", smallAxes = "xyz";
    if (text.size() < 3 || text[1] != '=') return unreadable(text);
    const std::size_t axis = std::min(axes.find(text[0]), smallAxes.find(text[0]));
    const std::optional<double> position = parseNumber(std::string_view(text).substr(2));
    if (axis == std::string_view::npos || !position) return unreadable(text);
    return PictureSection{static_cast<int>(axis), *position};
}

} // namespace

void addPictureOptions(CommandParser command, PictureOptions& options) {
    command.option("--view", options.view, BURIN_TEXT("Help", "View direction of the picture"))
        .choices(keysOf(views))
        .showDefault();
    command.option(
        "--section", options.section,
        BURIN_TEXT("Help", "Section plane: X=, Y= or Z= and its position, mm; the side towards the viewer is hidden"));
    command
        .option("--transparency", options.transparency,
                BURIN_TEXT("Help", "Transparency of the workpiece, %; shows the part inside it"))
        .range(0.0, 100.0)
        .showDefault();
}

Result<void> checkPictureOptions(const PictureOptions& options) {
    if (options.section.empty()) return {};
    const Result<PictureSection> section = sectionOf(options.section);
    return section ? Result<void>() : section.error();
}

Result<std::string> pictureOf(PictureContent content, const PictureOptions& options) {
    content.view = views.at(options.view);
    content.opacity = 1.0 - options.transparency / 100.0;
    if (!options.section.empty()) {
        const Result<PictureSection> section = sectionOf(options.section);
        if (!section) return section.error();
        const Box box = content.workpiece.grid().box();
        const double low = box.low[section->axis], high = box.high[section->axis];
        if (!(section->position > low && section->position < high))
            return Error{ErrorCode::argumentInvalid, "--section", options.section,
                         worded(BURIN_TEXT("Command", "a position between %1 and %2 mm"),
                                {formatFixed(low, 3), formatFixed(high, 3)})};
        content.section = *section;
    }
    return drawPicture(content);
}

Result<void> writePicture(PictureContent content, const PictureOptions& options, const std::string& file) {
    const Result<std::string> png = pictureOf(std::move(content), options);
    if (!png) return png.error();
    return writeFileAtomically(file, *png);
}

} // namespace burin
