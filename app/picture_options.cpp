// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/picture_options.h"

#include "core/base/file.h"
#include "core/base/numbers.h"
#include "ui/scene/picture.h"

#include <CLI/CLI.hpp>

#include <map>

namespace burin {
namespace {

const std::map<std::string, StandardView> views{{"back", StandardView::back},   {"bottom", StandardView::bottom},
                                                {"front", StandardView::front}, {"isometric", StandardView::isometric},
                                                {"left", StandardView::left},   {"right", StandardView::right},
                                                {"top", StandardView::top}};

Error unreadable(const std::string& section) {
    return {ErrorCode::argumentInvalid, "--section", section, "X=, Y= or Z= and a position in mm, such as X=12.5"};
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

void addPictureOptions(CLI::App& command, PictureOptions& options) {
    command.add_option("--view", options.view, "Where the picture is seen from")
        ->check(CLI::IsMember(views))
        ->capture_default_str();
    command.add_option("--section", options.section,
                       "Cut the picture open at a plane: X=, Y= or Z= and its position, mm; the nearer side comes off");
    command.add_option("--transparency", options.transparency, "Of the workpiece, %: the part is seen in it")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
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
                         "a position between " + formatFixed(low, 3) + " and " + formatFixed(high, 3) + " mm"};
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
