// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/messages/details.h"

#include "core/base/text.h"
#include "ui/messages/filled_text.h"
#include "ui/messages/foreign_details.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

namespace {

/// The places and details of core's errors as in its sources; %1 … stand for inserted values. The first match is used,
/// so the more specific ones come first; `foreignDetails` precede them.
constexpr std::array details{
    // places, names and files
    BURIN_TEXT("Detail", "an id that no shipped machine has; shipped machines can be copied, not changed"),
    BURIN_TEXT("Detail", "an id that no machine has yet, or --replace"),
    BURIN_TEXT("Detail", "an id that no material has yet, or --replace"),
    BURIN_TEXT("Detail", "a machine of your own; those that Burin is shipped with can't be deleted"),
    BURIN_TEXT("Detail", "letters, digits, '-', '_' and '.', a letter or digit first"),
    BURIN_TEXT("Detail", "a file other than \"%1\" and those that Burin keeps beside it"),
    BURIN_TEXT("Detail", "there is no home folder"),
    BURIN_TEXT("Detail", "is a folder"),
    BURIN_TEXT("Detail", "is no plain file"),
    BURIN_TEXT("Detail", "the system states no reason"),
    BURIN_TEXT("Detail", "%1; the new content stands there all the same"),
    BURIN_TEXT("Detail", "%1 is in the way"),
    BURIN_TEXT("Detail", "its folder is protected"),
    BURIN_TEXT("Detail", "it was changed while it was read"),
    BURIN_TEXT("Detail", "a take that no path uses (this one: %1)"),
    BURIN_TEXT("Detail", "another take of the setup of take %1"),
    BURIN_TEXT("Detail", "a take made with %1 that path %2 does not have"),
    BURIN_TEXT("Detail", "one of several sources of path %1"),
    BURIN_TEXT("Detail", "each take once"),
    BURIN_TEXT("Detail", "take %1, undone samples"),
    BURIN_TEXT("Detail", "take %1, sample %2"),
    BURIN_TEXT("Detail", "path %1, edit %2"),
    BURIN_TEXT("Detail", "take %1; the path is for %2"),
    BURIN_TEXT("Detail", "takes of the path's own setup"),
    BURIN_TEXT("Detail", "another take than the one that is scored"),
    BURIN_TEXT("Detail", "a tool that cuts sideways and is nowhere wider below than above"),
    BURIN_TEXT("Detail", "a tool that turns"),
    BURIN_TEXT("Detail", "no feeds, and links at the safe height without ramps: the tool doesn't turn"),
    BURIN_TEXT("Detail", "profile: the tool doesn't turn"),
    BURIN_TEXT("Detail", "%1 to %2 triangles"),
    BURIN_TEXT("Detail", "triangles of the vertices that are there"),
    BURIN_TEXT("Detail", "inside the profile: make the tool from its models again"),
    BURIN_TEXT("Detail", "inside the shank: make the tool from its models again"),
    BURIN_TEXT("Detail", "the height of the model of the shank"),
    // tool libraries
    BURIN_TEXT("Detail", "a short line of text other than all, starter and mine, without spaces around it"),
    BURIN_TEXT("Detail", "mine, or a library of your own"),
    BURIN_TEXT("Detail", "a name that no library has yet"),
    // JSON files
    BURIN_TEXT("Detail", "is not JSON"),
    BURIN_TEXT("Detail", "is not a JSON object"),
    BURIN_TEXT("Detail", "stands twice"),
    BURIN_TEXT("Detail", "is missing"),
    BURIN_TEXT("Detail", "is not known"),
    BURIN_TEXT("Detail", "has to be the file's name"),
    BURIN_TEXT("Detail", "differs from the file's name"),
    BURIN_TEXT("Detail", "names no key of this file"),
    BURIN_TEXT("Detail", "has to be above 0 with this rule"),
    BURIN_TEXT("Detail", "has to be below largest_radius_mm"),
    BURIN_TEXT("Detail", "has to be above 0 and above the one before"),
    BURIN_TEXT("Detail", "has to hold a point at least"),
    BURIN_TEXT("Detail", "has to be above 0"),
    BURIN_TEXT("Detail", "has to be at most maximum_spindle_speed_rpm"),
    BURIN_TEXT("Detail", "has to be at most rapid_feed_mm_per_min, the greatest feed of all"),
    BURIN_TEXT("Detail", "has to be below the travel of Z"),
    BURIN_TEXT("Detail", "has to be at most travel_mm[%1] from the machine's zero"),
    BURIN_TEXT("Detail", "has {%1}, which is none of {%2}"),
    BURIN_TEXT("Detail", "has to hold one of {%1}"),
    BURIN_TEXT("Detail", "has to be one line"),
    BURIN_TEXT("Detail", "has more than %1, which has to stand alone"),
    BURIN_TEXT("Detail", "has to be one of: %1"),
    BURIN_TEXT("Detail", "has to be a whole number from %1 to %2"),
    BURIN_TEXT("Detail", "has to be whole numbers"),
    BURIN_TEXT("Detail", "has to be true or false"),
    BURIN_TEXT("Detail", "has to be a text that is not empty"),
    BURIN_TEXT("Detail", "has to be a list of texts"),
    BURIN_TEXT("Detail", "has to be a list of %1 numbers"),
    BURIN_TEXT("Detail", "has to be a list"),
    BURIN_TEXT("Detail", "has to be an object"),
    BURIN_TEXT("Detail", "has to be a number"),
    BURIN_TEXT("Detail", "has to be a number of at least %1"),
    BURIN_TEXT("Detail", "has to be a number of at most %1"),
    BURIN_TEXT("Detail", "has to be a number from %1 to %2"),
    BURIN_TEXT("Detail", "has to be %1"),
    BURIN_TEXT("Detail", "a number"),
    BURIN_TEXT("Detail", "a number of at least %1"),
    BURIN_TEXT("Detail", "a number of at most %1"),
    BURIN_TEXT("Detail", "a number from %1 to %2"),
    BURIN_TEXT("Detail", "the material needs a value above 0"),
    // tools
    BURIN_TEXT("Detail", "left out: this type has none"),
    BURIN_TEXT("Detail", "half the diameter for a ball end or lollipop"),
    BURIN_TEXT("Detail", "above 0 and below half the diameter"),
    BURIN_TEXT("Detail", "0 for a sharp end"),
    BURIN_TEXT("Detail", "above 0, at most 89"),
    BURIN_TEXT("Detail", "at least 0 and below the diameter"),
    BURIN_TEXT("Detail", "small enough to round the edge of the tip"),
    BURIN_TEXT("Detail", "small enough to leave a cone"),
    BURIN_TEXT("Detail", "at most what the cone reaches at the end of the flutes (%1)"),
    BURIN_TEXT("Detail", "above half the diameter and below the diameter: where the ball ends and the shank begins"),
    BURIN_TEXT("Detail", "at least half the distance of the arc's ends"),
    BURIN_TEXT("Detail", "an arc that rises all the way from its beginning to its end and stays off the axis"),
    BURIN_TEXT("Detail", "at least one line or arc"),
    BURIN_TEXT("Detail",
               "at least the height at which the element begins: profiles never fall, so a cupped tip can't be drawn"),
    BURIN_TEXT("Detail", "a point other than the element's beginning"),
    BURIN_TEXT("Detail", "the height at which the profile ends"),
    BURIN_TEXT("Detail", "twice the profile's largest radius"),
    BURIN_TEXT("Detail", "> 0 and at least the corner radius"),
    BURIN_TEXT("Detail", "at least the length of the flutes"),
    BURIN_TEXT("Detail", "> 0 and at most the length of the flutes"),
    BURIN_TEXT("Detail", "not empty"),
    BURIN_TEXT("Detail", "at least 0"),
    BURIN_TEXT("Detail", "at least 1"),
    BURIN_TEXT("Detail", "above 0"),
    BURIN_TEXT("Detail", "required without chip_load_mm, not allowed with it"),
    BURIN_TEXT("Detail", "at most maximum_depth_of_cut_mm (%1)"),
    BURIN_TEXT("Detail", "at most half of diameter_mm (%1)"),
    BURIN_TEXT("Detail", "one line of text that is not empty"),
    BURIN_TEXT("Detail", "a name that no other preset of the tool has"),
    // setup and fixtures
    BURIN_TEXT("Detail", "two finite corners, each coordinate of the second above the first's"),
    BURIN_TEXT("Detail", "a finite length above 0 mm"),
    BURIN_TEXT("Detail", "a finite length of 0 mm or more"),
    BURIN_TEXT("Detail", "finite lengths of 0 mm or more"),
    BURIN_TEXT("Detail", "finite lengths"),
    BURIN_TEXT("Detail", "a finite box"),
    BURIN_TEXT("Detail", "a model with at least one body"),
    BURIN_TEXT("Detail", "at least one body whose role is part, or free carving"),
    BURIN_TEXT("Detail", "a box whose second corner lies above the first along each axis"),
    BURIN_TEXT("Detail", "a direction"),
    BURIN_TEXT("Detail", "a finite base, a radius and a height above 0 mm"),
    BURIN_TEXT("Detail", "solids where a body has the role stock, a box or a cylinder"),
    BURIN_TEXT("Detail", "a file where one was read, a box, a cylinder or solids"),
    BURIN_TEXT("Detail", "a stated box or cylinder, as there is no body to lay one around"),
    BURIN_TEXT("Detail", "a volume that is not air all over"),
    BURIN_TEXT("Detail", "a closed surface; close its holes"),
    BURIN_TEXT("Detail", "a table of what the values of the array mean"),
    BURIN_TEXT("Detail", "a body that a scanline meets; smaller voxels may help"),
    BURIN_TEXT("Detail", "a first plane below the second"),
    BURIN_TEXT("Detail", "a formula or table whose values are above 0 all over the layer"),
    BURIN_TEXT("Detail", "a name that is not empty"),
    BURIN_TEXT("Detail", "a name that no other layer has"),
    BURIN_TEXT("Detail", "planes between which there is stock"),
    BURIN_TEXT("Detail", "positions that rise"),
    BURIN_TEXT("Detail", "the id of a material"),
    BURIN_TEXT("Detail", "the name of one of the material's values"),
    BURIN_TEXT("Detail", "two lines or more, each a position in mm and a value"),
    BURIN_TEXT("Detail", "values that one entry alone has"),
    BURIN_TEXT("Detail", "a material that is milled needs a value above 0"),
    BURIN_TEXT("Detail", "a material of your own; those that Burin is shipped with can't be deleted"),
    BURIN_TEXT("Detail", "has to be a finite number"),
    BURIN_TEXT("Detail", "has to be letters, digits, '-', '_' and '.'"),
    BURIN_TEXT("Detail", "has to be there"),
    BURIN_TEXT("Detail", "has to be there, as the other half of Kienzle's law is"),
    BURIN_TEXT("Detail", "has to be there, or Kienzle's law: without it nothing is felt"),
    BURIN_TEXT("Detail", "has to be there: feeds and speeds come from it"),
    BURIN_TEXT("Detail", "is out of what can be milled"),
    BURIN_TEXT("Detail", "material has to be an id, null or a material"),
    BURIN_TEXT("Detail", "has to have a value, or from and to that rise"),
    BURIN_TEXT("Detail", "has to name a material"),
    BURIN_TEXT("Detail", "the same spacing along all axes"),
    BURIN_TEXT("Detail", "three dimensions"),
    BURIN_TEXT("Detail", "axes along +X, +Y and +Z"),
    BURIN_TEXT("Detail", "raw or gzip"),
    BURIN_TEXT("Detail", "one file beside the header"),
    BURIN_TEXT("Detail", "data that begin at once"),
    BURIN_TEXT("Detail", "little or big"),
    BURIN_TEXT("Detail", "a known material, or one that a new material is like"),
    BURIN_TEXT("Detail", "%1 voxels on one axis"),
    BURIN_TEXT("Detail", "%1 voxels"),
    BURIN_TEXT("Detail", "its triangles face inwards"),
    BURIN_TEXT("Detail", "no body"),
    BURIN_TEXT("Detail", "%1 mm or more for the other sizes of this fixture"),
    BURIN_TEXT("Detail", "a value for each parameter"),
    BURIN_TEXT("Detail", "a finite angle"),
    BURIN_TEXT("Detail", "a length of %1 to %2 mm"),
    // force records
    BURIN_TEXT("Detail", "noise hides the cutting force; measure deeper cuts or more of them"),
    BURIN_TEXT("Detail", "the forces on the workpiece point against the feed; are they those on the tool?"),
    BURIN_TEXT("Detail",
               "the forces on the tool point along the feed; are they those on the workpiece (--on-workpiece)?"),
    BURIN_TEXT("Detail", "the records disagree too much; look for air cuts, chatter or wrong conditions in them"),
    BURIN_TEXT("Detail", "the force of the edge comes out negative; use another law (--law kienzle or constant)"),
    BURIN_TEXT("Detail", "the radial force pulls the tool into the material; use another projection (--projection)"),
    BURIN_TEXT("Detail", "only %1 records can be used; measure %2 or more"),
    BURIN_TEXT("Detail", "the edge's force needs chips of different thickness; measure feeds that differ by a factor "
                         "of %1 or more, or use another law (--law constant)"),
    BURIN_TEXT("Detail",
               "an exponent needs chips of different thickness; measure feeds that differ by a factor of %1 or more"),
    BURIN_TEXT("Detail",
               "noise hides the exponent; measure feeds that differ more, or more of them, or use a constant K"),
    BURIN_TEXT("Detail", "far off: %1 N tangential, %2 N radial deviation from the fit; %3 N and %4 N would count"),
    BURIN_TEXT("Detail", "far off: %1 N deviation from the fit; %2 N would count"),
    BURIN_TEXT("Detail", "nothing was removed"),
    BURIN_TEXT("Detail", "the feed is along the tool axis"),
    BURIN_TEXT("Detail", "the column immersion does not say up or down"),
    BURIN_TEXT("Detail", "is missing; write a number"),
    BURIN_TEXT("Detail", "\"%1\" is no number with a decimal point"),
    BURIN_TEXT("Detail", "\"%1\" is out of range; %2 to %3"),
    BURIN_TEXT("Detail", "\"%1\" has to be above 0"),
    BURIN_TEXT("Detail", "\"%1\" is no id; letters, digits, '-', '_' and '.', a letter or digit first"),
    BURIN_TEXT("Detail", "\"%1\" has to be a whole number from 1 to 1000"),
    BURIN_TEXT("Detail", "\"%1\" has to be slot, up, down or empty"),
    BURIN_TEXT("Detail", "there is no row below the heading"),
    BURIN_TEXT("Detail", "is not UTF-8; save the table as CSV UTF-8"),
    BURIN_TEXT("Detail", "a quotation mark does not end"),
    BURIN_TEXT("Detail", "has semicolons; save the table with commas and decimal points"),
    BURIN_TEXT("Detail", "is not known; call columns that are for people note…"),
    BURIN_TEXT("Detail", "is there twice"),
    BURIN_TEXT("Detail", "is missing; the first line has to name it"),
    BURIN_TEXT("Detail", "the row has %1 values, the heading %2; write decimal points, not commas"),
    BURIN_TEXT("Detail", "the tool axis has no length"),
    BURIN_TEXT("Detail", "the feed has no direction"),
    BURIN_TEXT("Detail", "is more than the diameter"),
    BURIN_TEXT("Detail", "a slot's radial depth is the diameter; write up or down"),
    BURIN_TEXT("Detail", "its conditions differ from line %1 of the same cut; give it a name of its own"),
    // traces
    BURIN_TEXT("Detail", "value %1 is not a number"),
    BURIN_TEXT("Detail", "buttons is not a whole number from 0 to 4294967295"),
    BURIN_TEXT("Detail", "not %1 values between commas"),
    BURIN_TEXT("Detail", "value 11 is neither 0 nor 1"),
    BURIN_TEXT("Detail", "value 12 is not a number of at least 0"),
    BURIN_TEXT("Detail", "the quaternion's length is not 1"),
    BURIN_TEXT("Detail", "the first line must be %1"),
    BURIN_TEXT("Detail", "the second line must be %1"),
    BURIN_TEXT("Detail", "the time is not later than in the line before"),
    BURIN_TEXT("Detail", "no reading follows"),
    BURIN_TEXT("Detail", "a session begins once, before its first reading"),
    BURIN_TEXT("Detail", "the workpiece was changed there by something else than milling"),
    BURIN_TEXT("Detail", "the boundary that this project's tool has is made of fewer"),
    BURIN_TEXT("Detail", "tile %1"),
    BURIN_TEXT("Detail", "at least one reading"),
    BURIN_TEXT("Detail", "times that rise"),
    BURIN_TEXT("Detail", "realtime with a device that keeps its own time"),
    // programs
    BURIN_TEXT("Detail", "%1; its start is set by line %2 and line %3"),
    BURIN_TEXT("Detail", "%1; its start is set by line %2"),
    BURIN_TEXT("Detail", "%1; distances are incremental since line %2"),
    BURIN_TEXT("Detail", "line %1, column %2"),
    BURIN_TEXT("Detail", "line %1"),
    BURIN_TEXT("Detail", "a move of %1 mm, and up to %2 mm are checked"),
    BURIN_TEXT("Detail", "all moves up to here are longer than the %1 mm that are checked"),
    BURIN_TEXT("Detail", "a number of its own for each tool of a program"),
    BURIN_TEXT("Detail", "has to begin with a rapid move; link it first"),
    BURIN_TEXT("Detail", "has to begin with a rapid move"),
    BURIN_TEXT("Detail", "its tool has no number"),
    BURIN_TEXT("Detail", "missing at point %1"),
    BURIN_TEXT("Detail", "point %1 is not finite"),
    BURIN_TEXT("Detail", "point %1 can't be the end of an arc"),
    BURIN_TEXT("Detail", "%1 characters, limit %2"),
    BURIN_TEXT("Detail", "%1, limit %2"),
    BURIN_TEXT("Detail", "not a time"),
    BURIN_TEXT("Detail", "coordinate is not a valid position"),
    BURIN_TEXT("Detail", "centre is not a valid position"),
    BURIN_TEXT("Detail", "one program a tool"),
    BURIN_TEXT("Detail", "G54 to G59"),
    BURIN_TEXT("Detail", "a line with no cut from an unknown position behind it (line %1)"),
    BURIN_TEXT("Detail", "a line with no cut without a feed behind it (line %1)"),
    BURIN_TEXT("Detail", "a line with no cut without a spindle behind it (line %1)"),
    BURIN_TEXT("Detail", "none; the program cuts nothing"),
    BURIN_TEXT("Detail", "1 to %1, the line of the last cut"),
    // edits
    BURIN_TEXT("Detail", "%1 to %2, a whole number"),
    BURIN_TEXT("Detail", "coordinates from %1 to %2"),
    BURIN_TEXT("Detail", "%1 to %2 points"),
    BURIN_TEXT("Detail", "coordinates up to %1"),
    BURIN_TEXT("Detail", "a take and a tick of it, from 0"),
    BURIN_TEXT("Detail", "a take and two ticks of it, the earlier one first"),
    BURIN_TEXT("Detail", "true or false"),
    BURIN_TEXT("Detail", "one of: %1"),
    BURIN_TEXT("Detail", "three numbers"),
    BURIN_TEXT("Detail", "a list of points, three numbers each"),
    BURIN_TEXT("Detail", "no parameter of %1"),
    BURIN_TEXT("Detail", "a JSON object"),
    BURIN_TEXT("Detail", "below half of the recording's rate"),
    BURIN_TEXT("Detail", "no more than %1 of so long a path"),
    BURIN_TEXT("Detail", "moments that the path still has"),
    BURIN_TEXT("Detail", "a moment that is still in the path"),
    BURIN_TEXT("Detail", "take %1, tick %2"),
    BURIN_TEXT("Detail", "pass %1, tick %2"),
    BURIN_TEXT("Detail", "takes milled with the axis fixed at +Z (--axis fixed), unlike take %1"),
    BURIN_TEXT("Detail", "set-feed, then level-feed"),
    BURIN_TEXT("Detail", "set-feed, then section"),
    BURIN_TEXT("Detail", "at most %1 1/min, the limit of the tool %2"),
    BURIN_TEXT("Detail", "one that has not ended"),
    BURIN_TEXT("Detail", "none: the part alone is there"),
    // computed passes
    BURIN_TEXT("Detail", "fixtures or keep-out volumes are in the way: move them"),
    BURIN_TEXT("Detail", "another tool was loaded before it was computed"),
    BURIN_TEXT("Detail", "%1 recordings and passes"),
    BURIN_TEXT("Detail", "too much stock is in the way of the tool: rough it first, or use a longer tool"),
    BURIN_TEXT("Detail", "no stock is left there"),
    BURIN_TEXT("Detail", "the part is in the way of the drill, or the drill is too short"),
    BURIN_TEXT("Detail", "the part has no upright hole there that fits this drill and is not drilled yet"),
    BURIN_TEXT("Detail", "a round upright hole of the part, or a depth"),
    BURIN_TEXT("Detail", "a drill of at most %1 mm for that hole"),
    BURIN_TEXT(
        "Detail",
        "the holes are not drilled as deep as the thread: drill them first, with the full diameter down to Z %1 mm in "
        "the coordinates of the setup"),
    BURIN_TEXT("Detail", "the part has no upright hole of the thread's major diameter there"),
    BURIN_TEXT("Detail", "a round upright hole of the part"),
    BURIN_TEXT("Detail", "a hole modelled with the major diameter, %1 mm, not with %2 mm"),
    BURIN_TEXT("Detail", "a model whose facets are at most %1 mm inside of that hole's circle"),
    BURIN_TEXT("Detail", "a thread mill of at most %1 mm for that hole"),
    BURIN_TEXT("Detail", "above %1 and at most %2 mm for the hole at %3, %4"),
    BURIN_TEXT("Detail", "a thread mill with one tooth for a pitch of %1 mm"),
    BURIN_TEXT("Detail", "a thread mill with a neck of at most %1 mm"),
    BURIN_TEXT("Detail", "a thread mill"),
    BURIN_TEXT("Detail", "a drill"),
    BURIN_TEXT("Detail", "0 for a thread"),
    BURIN_TEXT("Detail", "above 0, or the holes of the thread"),
    BURIN_TEXT("Detail", "below half of the diameter"),
    BURIN_TEXT("Detail", "the part has no concave edge for this tool there"),
    BURIN_TEXT("Detail", "it has no stroke"),
    BURIN_TEXT("Detail", "at most the cutter's radius, %1 mm"),
    BURIN_TEXT("Detail", "below the top of what is to be taken away, %1 mm"),
    BURIN_TEXT("Detail", "below the top, %1"),
    BURIN_TEXT("Detail", "a part to lay rows on; there is none"),
    BURIN_TEXT("Detail", "a part to go along; there is none"),
    BURIN_TEXT("Detail", "a part with edges to follow; there is none"),
    BURIN_TEXT("Detail", "a point on the part, within 1 mm"),
    BURIN_TEXT("Detail", "a face that is visible from above"),
    BURIN_TEXT("Detail", "less than the rounding of the tool's end, %1 mm"),
    BURIN_TEXT("Detail", "a tool with a rounded end; give a step-over for this one"),
    BURIN_TEXT("Detail", "rings of 3 corners at least"),
    BURIN_TEXT("Detail", "places within 1e5 mm"),
    BURIN_TEXT("Detail", "an area: there is no pocket without one"),
    BURIN_TEXT("Detail", "lines of 2 places at least"),
    BURIN_TEXT("Detail", "a line at least: a stroke or curves of a file"),
    BURIN_TEXT("Detail", "a closed curve at least, as border of an area"),
    // plugins
    BURIN_TEXT("Detail", "\"%1\" has to be a text"),
    BURIN_TEXT("Detail", "unknown key \"%1\""),
    BURIN_TEXT("Detail", "not a JSON object"),
    BURIN_TEXT("Detail", "not JSON"),
    BURIN_TEXT("Detail", "\"interface_version\" has to be a whole number"),
    BURIN_TEXT("Detail", "\"kind\" has to be \"%1\""),
    BURIN_TEXT("Detail", "id \"%1\" is taken already"),
    BURIN_TEXT("Detail", "%1 must be file names without a folder"),
    BURIN_TEXT("Detail", "unknown reason"),
    BURIN_TEXT("Detail", "its entry point threw"),
    BURIN_TEXT("Detail", "its entry point gave nothing"),
    BURIN_TEXT("Detail", "it made nothing"),
    BURIN_TEXT("Detail", "it threw: %1"),
    BURIN_TEXT("Detail", "it threw"),
    // axes of devices
    BURIN_TEXT("Detail", "a device with axes to assign"),
    BURIN_TEXT("Detail", "at least one button that mills"),
    BURIN_TEXT("Detail", "low end, rest and high end in ascending order, from -4 to 4"),
};
[[maybe_unused]] constexpr TextId range = BURIN_TEXT("Detail", "%1 to %2"); // of numbers only

/// The text in the user's language with `values` for %1 …, each of them a detail itself.
QString filledDetail(TextId text, const QStringList& values) {
    QStringList translated;
    for (const QString& value : values) translated << detailText(value.toStdString());
    return filled(QCoreApplication::translate(text.context, text.text), translated);
}

std::optional<QString> knownDetail(const QString& english) {
    static const std::vector<std::pair<QRegularExpression, TextId>> patterns = [] {
        std::vector<std::pair<QRegularExpression, TextId>> list;
        for (const TextId& text : foreignDetails()) list.emplace_back(patternOf(text), text);
        for (const TextId& text : details) list.emplace_back(patternOf(text), text);
        const QString number = QStringLiteral("(-?[0-9][-+.e0-9]*)");
        list.emplace_back(QRegularExpression(QRegularExpression::anchoredPattern(number + " to " + number)), range);
        return list;
    }();
    for (const auto& [pattern, text] : patterns)
        if (const QRegularExpressionMatch match = pattern.match(english); match.hasMatch())
            return filledDetail(text, match.capturedTexts().sliced(1));
    return std::nullopt;
}

/// "decimal point is missing: X1": a problem of a program's text, followed by the words concerned.
QString problemText(const QString& english) {
    const auto translated = [](const QString& text) {
        return QCoreApplication::translate("ProgramProblem", text.toUtf8().constData());
    };
    for (qsizetype end = english.size(); end > 0; end = english.lastIndexOf(QStringLiteral(": "), end - 1)) {
        const QString problem = english.left(end);
        if (const QString text = translated(problem); text != problem) return text + english.sliced(end);
    }
    return english;
}

} // namespace

QString detailText(const std::string& detail) {
    const QString english = QString::fromStdString(detail);
    return knownDetail(english).value_or(problemText(english));
}

} // namespace burin
