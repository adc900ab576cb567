// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/texts.h"

#include "ui/messages/messages.h"

#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "core/tool/tool_solid.h"
#include "ui/panels/quantity.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

class PanelLabels {
    Q_DECLARE_TR_FUNCTIONS(PanelLabels)
};

/// A number with three or four significant digits.
QString fewDigits(double value) {
    const double size = std::abs(value);
    if (size > 0.0 && size < 0.1) return QLocale().toString(value, 'g', 2);
    const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
    return QLocale().toString(value, 'f', decimals);
}

QString withUnit(const QString& number, const QString& unit) {
    return number + QChar(QChar::Nbsp) + unit;
}

QString withoutTrailingZeros(QString number) {
    const QString point = QLocale().decimalPoint();
    if (!number.contains(point)) return number;
    while (number.endsWith(QLocale().zeroDigit())) number.chop(1);
    if (number.endsWith(point)) number.chop(point.size());
    return number;
}

} // namespace

QString toolName(const Tool& tool) {
    return Messages::resourceName(tool.name);
}

QString toolName(const std::vector<Tool>& tools, const std::string& id) {
    const auto tool = std::ranges::find(tools, id, &Tool::id);
    return tool == tools.end() ? QString::fromStdString(id) : toolName(*tool);
}

QString materialName(const Property& material) {
    return Messages::resourceName(material.name);
}

namespace {

QString plainTakeName(const std::string& name) {
    static const QRegularExpression numbered(QStringLiteral("^take ([0-9]+)$"));
    const QRegularExpressionMatch match = numbered.match(QString::fromStdString(name));
    if (match.hasMatch()) return QCoreApplication::translate("Take", "take %1").arg(match.captured(1));
    return QCoreApplication::translate("Take", name.c_str());
}

} // namespace

QString takeName(const std::string& name) {
    constexpr std::string_view copy = " (copy)";
    constexpr int mostCopies = 8; // limit for nested copies, because a file may come from an untrusted source
    std::string original = name;
    int copies = 0;
    for (; copies < mostCopies && original.size() > copy.size() && original.ends_with(copy); ++copies)
        original.resize(original.size() - copy.size());
    QString text = plainTakeName(original);
    for (int i = 0; i < copies; ++i) text = QCoreApplication::translate("Take", "%1 (copy)").arg(text);
    return text;
}

QString toolSummary(const Tool& tool, LengthUnit unit) {
    QStringList parts{QStringLiteral("Ø ") + shortLength(tool.cutter.diameter, unit)};
    if (tool.cutter.cornerRadius > 0.0)
        parts.append(QStringLiteral("R ") + shortLength(tool.cutter.cornerRadius, unit));
    if (tool.cutter.isHollow())
        parts.append(PanelLabels::tr("hollow Ø %1 × %2")
                         .arg(shortLength(tool.cutter.solid->hollowWidth, unit),
                              shortLength(tool.cutter.solid->hollowDepth, unit)));
    if (!tool.cutter.turns())
        parts.append(PanelLabels::tr("doesn't turn"));
    else
        parts.append(tool.fluteCount == 1 ? PanelLabels::tr("1 flute")
                                          : PanelLabels::tr("%n flutes", nullptr, tool.fluteCount));
    return parts.join(QStringLiteral(", "));
}

/// The text after the name of a value that applies to one kind of cutter.
QString cutterText(CutterType type) {
    switch (type) {
    case CutterType::ball:
        return PanelLabels::tr("%1, ball end mills");
    case CutterType::flat:
        return PanelLabels::tr("%1, flat end mills");
    case CutterType::bullNose:
        return PanelLabels::tr("%1, bull-nose end mills");
    case CutterType::taper:
        return PanelLabels::tr("%1, tapered end mills");
    case CutterType::taperBall:
        return PanelLabels::tr("%1, tapered ball end mills");
    case CutterType::drill:
        return PanelLabels::tr("%1, drills");
    case CutterType::chamfer:
        return PanelLabels::tr("%1, chamfer mills");
    case CutterType::lollipop:
        return PanelLabels::tr("%1, lollipop mills");
    case CutterType::profile:
        return PanelLabels::tr("%1, form tools");
    }
    return {};
}

QString valueNameText(const std::string& name) {
    for (const std::string_view value : valuesByCutter)
        for (int i = 0; i <= static_cast<int>(CutterType::profile); ++i)
            if (const auto type = static_cast<CutterType>(i); name == valueForCutter(value, type))
                return cutterText(type).arg(valueNameText(std::string(value)));
    if (name == specificCuttingEnergy) return PanelLabels::tr("Specific cutting energy");
    if (name == radialForceRatio) return PanelLabels::tr("Radial force ratio");
    if (name == kienzleForce) return PanelLabels::tr("Specific cutting force kc1.1");
    if (name == kienzleExponent) return PanelLabels::tr("Kienzle exponent mc");
    if (name == density) return PanelLabels::tr("Density");
    if (name == surfaceSpeed) return PanelLabels::tr("Surface speed");
    if (name == chipLoadPerDiameter) return PanelLabels::tr("Chip load per diameter");
    if (name == plungeFeedRatio) return PanelLabels::tr("Plunge feed ratio");
    QString words = QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

QString prettyUnit(const std::string& unit) {
    if (unit == "1") return {};
    return QString::fromStdString(unit)
        .replace(QStringLiteral("^2"), QStringLiteral("²"))
        .replace(QStringLiteral("^3"), QStringLiteral("³"));
}

QString countText(std::size_t count) {
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString wayText(double millimetres, LengthUnit unit) {
    const bool inches = unit == LengthUnit::inch;
    return withUnit(QLocale().toString(inches ? millimetres / millimetresPerInch : millimetres, 'f', inches ? 1 : 0),
                    unitText(unit));
}

QString shortLength(double millimetres, LengthUnit unit) {
    return withUnit(withoutTrailingZeros(lengthNumber(millimetres, unit)), unitText(unit));
}

QString sizeText(const glm::dvec3& size, LengthUnit unit) {
    QStringList numbers;
    for (int axis = 0; axis < 3; ++axis) {
        const double shown = unit == LengthUnit::inch ? size[axis] / millimetresPerInch : size[axis];
        numbers.append(withoutTrailingZeros(fixedNumber(shown, unit == LengthUnit::inch ? 3 : 2)));
    }
    return withUnit(numbers.join(QStringLiteral(" × ")), unitText(unit));
}

QString areaText(double squareMillimetres, LengthUnit unit) {
    if (unit == LengthUnit::inch)
        return withUnit(fewDigits(squareMillimetres / (millimetresPerInch * millimetresPerInch)),
                        QStringLiteral("in²"));
    return withUnit(fewDigits(squareMillimetres), QStringLiteral("mm²"));
}

QString volumeText(double cubicMillimetres, LengthUnit unit) {
    if (unit == LengthUnit::inch)
        return withUnit(fewDigits(cubicMillimetres / std::pow(millimetresPerInch, 3)), QStringLiteral("in³"));
    if (std::abs(cubicMillimetres) < 1000.0) return withUnit(fewDigits(cubicMillimetres), QStringLiteral("mm³"));
    return withUnit(fewDigits(cubicMillimetres / 1000.0), QStringLiteral("cm³"));
}

QString rateText(double cubicMillimetresPerSecond, LengthUnit unit) {
    if (unit == LengthUnit::inch) {
        const double cubicInchesPerMinute = cubicMillimetresPerSecond * 60.0 / std::pow(millimetresPerInch, 3);
        return withUnit(QLocale().toString(cubicInchesPerMinute, 'f', 2), QStringLiteral("in³/min"));
    }
    return withUnit(QLocale().toString(cubicMillimetresPerSecond, 'f', 0), QStringLiteral("mm³/s"));
}

QString feedText(double millimetresPerMinute, LengthUnit unit) {
    if (!(millimetresPerMinute > 0.0)) return QStringLiteral("–");
    const bool inch = unit == LengthUnit::inch;
    const double shown = inch ? millimetresPerMinute / millimetresPerInch : millimetresPerMinute;
    return withUnit(QLocale().toString(shown, 'f', inch ? 1 : 0),
                    inch ? QStringLiteral("in/min") : QStringLiteral("mm/min"));
}

QString spindleSpeedText(double perMinute) {
    if (!(perMinute > 0.0)) return QStringLiteral("–");
    return withUnit(QLocale().toString(perMinute, 'f', 0), PanelLabels::tr("rpm"));
}

QString shareText(double share) {
    return withUnit(QLocale().toString(100.0 * share, 'f', 0), QStringLiteral("%"));
}

QString durationText(double seconds) {
    const auto whole = static_cast<long long>(std::max(0.0, std::floor(std::isfinite(seconds) ? seconds : 0.0)));
    const auto two = [](long long number) { return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0')); };
    if (whole < 3600) return two(whole / 60) + QLatin1Char(':') + two(whole % 60);
    return QString::number(whole / 3600) + QLatin1Char(':') + two(whole / 60 % 60) + QLatin1Char(':') + two(whole % 60);
}

QString clockText(double seconds, int decimals) {
    long long parts = 1; // of a second
    for (int i = 0; i < decimals; ++i) parts *= 10;
    constexpr double rounding = 1e-6; // of the last digit: 0.3 s must not become 0.2
    const auto all = static_cast<long long>(std::floor(std::max(0.0, seconds) * static_cast<double>(parts) + rounding));
    const QString text = durationText(static_cast<double>(all / parts));
    if (decimals == 0) return text;
    return text + QLocale().decimalPoint() + QStringLiteral("%1").arg(all % parts, decimals, 10, QLatin1Char('0'));
}

namespace {

/// The load of a cut on spindle or tool, together with the limit.
QString loadText(const Finding& finding, LengthUnit unit) {
    const auto number = [](double value, int decimals) { return QLocale().toString(value, 'f', decimals); };
    switch (finding.kind) {
    case FindingKind::spindlePower:
        return PanelLabels::tr("The cut takes %1 W, the spindle has %2 W")
            .arg(number(finding.amount, 0), number(finding.limit, 0));
    case FindingKind::spindleTorque:
        return PanelLabels::tr("The cut takes %1 N m, the spindle has %2 N m at this speed")
            .arg(number(finding.amount, 1), number(finding.limit, 1));
    case FindingKind::toolBreakage:
        return PanelLabels::tr("The tool may break: bending stress of %1 N/mm², limit %2 N/mm²")
            .arg(number(finding.amount, 0), number(finding.limit, 0));
    case FindingKind::toolBending:
        return PanelLabels::tr("The tool bends by %1, the tolerance is %2")
            .arg(lengthText(finding.amount, unit), lengthText(finding.limit, unit));
    case FindingKind::chipLoad:
        return PanelLabels::tr("Chip load of %1 per tooth, limit %2")
            .arg(lengthText(finding.amount, unit), lengthText(finding.limit, unit));
    case FindingKind::depthOfCut:
        return PanelLabels::tr("Depth of cut of %1, limit %2")
            .arg(lengthText(finding.amount, unit), lengthText(finding.limit, unit));
    case FindingKind::widthOfCut:
        return PanelLabels::tr("Width of cut of %1, limit %2")
            .arg(lengthText(finding.amount, unit), lengthText(finding.limit, unit));
    default:
        return {};
    }
}

QString kindText(const Finding& finding, LengthUnit unit) {
    const QString volume = volumeText(finding.amount, unit);
    const QString length = lengthText(finding.amount, unit);
    switch (finding.kind) {
    case FindingKind::gouge:
        return PanelLabels::tr("Gouge of %1").arg(length);
    case FindingKind::rapidInStock:
        return PanelLabels::tr("Rapid through %1").arg(volume);
    case FindingKind::shankCollision:
        return PanelLabels::tr("Shank collision, %1").arg(volume);
    case FindingKind::holderCollision:
        return PanelLabels::tr("Holder collision, %1").arg(volume);
    case FindingKind::spindleOff:
        return PanelLabels::tr("Spindle off in %1").arg(volume);
    case FindingKind::spindleOn:
        return PanelLabels::tr("Spindle on in %1").arg(volume);
    case FindingKind::travelLimit:
        return PanelLabels::tr("Travel of %1 needed").arg(length);
    case FindingKind::feedLimit:
        return PanelLabels::tr("Feed of %1 mm/min").arg(QLocale().toString(finding.amount, 'f', 0));
    case FindingKind::spindleLimit:
        return PanelLabels::tr("Spindle at %1 rpm").arg(QLocale().toString(finding.amount, 'f', 0));
    case FindingKind::rotaryLimit:
        return PanelLabels::tr("Rotary axis at %1°, beyond its limits").arg(QLocale().toString(finding.amount, 'f', 2));
    case FindingKind::unknownStart:
        return PanelLabels::tr("Cuts from an unknown position");
    case FindingKind::obstacleCollision:
        return PanelLabels::tr("In a fixture by %1").arg(length);
    case FindingKind::centrePlunge:
        return PanelLabels::tr("Plunge of %1: the tool does not cut at its centre").arg(length);
    case FindingKind::toolUnknown:
        return PanelLabels::tr("T%1 is not in the project; nothing after it was checked").arg(finding.amount);
    case FindingKind::toolNotLoaded:
        return PanelLabels::tr("Feed move before the tool is loaded");
    case FindingKind::lengthOffsetMissing:
        return PanelLabels::tr("The length offset of T%1 is not in force").arg(finding.amount);
    case FindingKind::lengthOffsetOfOther:
        return PanelLabels::tr("H%1 is the length offset of another tool").arg(finding.amount);
    case FindingKind::workOffsetOther:
        return PanelLabels::tr("Not the project's work offset");
    case FindingKind::spindleReversed:
        return PanelLabels::tr("Spindle rotates anticlockwise; the tool is right-handed");
    case FindingKind::cornerGouge:
        return PanelLabels::tr("Blended corners gouge by %1").arg(length);
    case FindingKind::cornerExcess:
        return PanelLabels::tr("Blended corners leave %1 of stock").arg(length);
    case FindingKind::allowanceDiffers:
        return PanelLabels::tr("Leaves %1 on the part, the path leaves %2")
            .arg(length, lengthText(finding.limit, unit));
    case FindingKind::partNotProtected:
        return PanelLabels::tr("Bodies too small for the voxels, not protected: %1").arg(finding.amount);
    case FindingKind::spindlePower:
    case FindingKind::spindleTorque:
    case FindingKind::toolBreakage:
    case FindingKind::toolBending:
    case FindingKind::chipLoad:
    case FindingKind::depthOfCut:
    case FindingKind::widthOfCut:
        return loadText(finding, unit);
    }
    return {};
}

} // namespace

QString findingText(const Finding& finding, LengthUnit unit) {
    const QString text = kindText(finding, unit);
    if (finding.count < 2) return text;
    return PanelLabels::tr("%1 (and on %n more lines)", nullptr, static_cast<int>(finding.count) - 1).arg(text);
}

namespace {

QString passText(const NearPass& pass, const QString& distance) {
    const bool shank = pass.section == ToolSection::shank;
    switch (pass.to) {
    case NearTo::stock:
        return (shank ? PanelLabels::tr("Shank passes the stock at %1")
                      : PanelLabels::tr("Holder passes the stock at %1"))
            .arg(distance);
    case NearTo::part:
        return (shank ? PanelLabels::tr("Shank passes the part at %1")
                      : PanelLabels::tr("Holder passes the part at %1"))
            .arg(distance);
    case NearTo::obstacle:
        return (shank ? PanelLabels::tr("Shank passes a fixture at %1")
                      : PanelLabels::tr("Holder passes a fixture at %1"))
            .arg(distance);
    }
    return {};
}

} // namespace

QString nearPassText(const NearPass& pass, LengthUnit unit) {
    const QString text = passText(pass, lengthText(pass.distance, unit));
    if (pass.lines == 1) return text;
    return text + QStringLiteral("; ") +
           PanelLabels::tr("%n lines near there", "near pass", static_cast<int>(pass.lines));
}

QString lintText(const LintMark& mark) {
    const QString text = Messages::text(textOf(mark.problem));
    return mark.words.empty() ? text : text + QStringLiteral(": ") + QString::fromStdString(mark.words);
}

} // namespace burin
