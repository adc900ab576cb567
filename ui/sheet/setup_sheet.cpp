// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/setup_sheet.h"

#include "core/geometry/upright.h"
#include "core/nc/work_offset.h"
#include "ui/panels/fixture_labels.h"
#include "ui/panels/placement_labels.h"
#include "ui/panels/texts.h"
#include "ui/panels/zero_labels.h"
#include "ui/sheet/sheet_page.h"
#include "ui/sheet/sheet_text.h"
#include "ui/sheet/sheet_tools.h"
#include "ui/sheet/tool_picture.h"

#include <QDate>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

namespace burin {

namespace {

using Facts = std::vector<std::pair<QString, QString>>;

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

/// Writes the sections of a sheet, one after the other.
class Sheet {
public:
    Sheet(const SheetContent& content, LengthUnit unit)
        : content_(content), source_(content.source), unit_(unit), page_(title()) {
        if (source_.program) use_ = useOf(source_.program->parsed, source_.tools, source_.machine);
    }

    /// @param shown PNG, one for each of sheetViews
    QString write(std::span<const std::string> shown) {
        page_.sentence(SheetText::tr("Project %1, %2").arg(text(source_.project), today()));
        warn();
        pictures(shown);
        machine();
        stock();
        fixtures();
        tools();
        program();
        return page_.html();
    }

private:
    QString title() const {
        const QString part = text(std::filesystem::path(source_.model->sourceFile).filename().string());
        const QString name = part.isEmpty() ? text(source_.project) : part;
        return source_.setupName.empty()
                   ? SheetText::tr("Setup sheet: %1").arg(name)
                   : SheetText::tr("Setup sheet: %1, setup %2").arg(name, text(source_.setupName));
    }
    static QString today() { return QLocale().toString(QDate::currentDate(), QLocale::ShortFormat); }
    QString length(double mm) const { return lengthText(mm, unit_); }
    QString number(double mm) const { return lengthNumber(mm, unit_); }
    /// From program zero.
    QString place(const glm::dvec3& setupPlace) const {
        const glm::dvec3 from = setupPlace - source_.setup.workOffset;
        return QStringLiteral("X %1  Y %2  Z %3 %4")
            .arg(number(from.x), number(from.y), number(from.z), unitText(unit_));
    }

    /// Warnings for the machinist.
    void warn() {
        const bool released = source_.program && source_.program->released();
        if (!source_.program)
            page_.sentence(SheetText::tr("There is no checked program for this setup yet."), true);
        else if (!source_.programUpToDate)
            page_.sentence(SheetText::tr("The setup has changed since the program was checked. Check it again."), true);
        else if (source_.program->overridden)
            page_.sentence(SheetText::tr("The program failed its check and was exported with a reason. See below."),
                           true);
        else if (!released)
            page_.sentence(SheetText::tr("The program failed its check. Do not run it."), true);
    }

    void pictures(std::span<const std::string> shown) {
        const std::array captions{SheetText::tr("Stock with the part, as clamped"), SheetText::tr("From above"),
                                  SheetText::tr("From the front")};
        for (std::size_t i = 0; i < std::min(shown.size(), captions.size()); ++i)
            page_.picture(QByteArray::fromStdString(shown[i]), captions[i]);
    }

    void machine() {
        page_.section(SheetText::tr("Machine and zero"));
        const Box& stock = source_.setup.stock;
        const glm::dvec3 low = source_.setup.workOffset - stock.low, high = stock.high - source_.setup.workOffset;
        Facts facts{{SheetText::tr("Machine"), text(source_.machine.name)},
                    {SheetText::tr("Control"), text(source_.dialect)},
                    {SheetText::tr("Units of the program"), text(std::string(idOf(source_.units)))},
                    {SheetText::tr("Work offset"), text(workOffsetName(source_.setup.zero.workOffset))},
                    {SheetText::tr("Program zero"), zeroText(source_.setup.zero)},
                    {SheetText::tr("From zero to the stock: left, front, bottom"),
                     QStringLiteral("%1, %2, %3").arg(length(low.x), length(low.y), length(low.z))},
                    {SheetText::tr("From zero to the stock: right, back, top"),
                     QStringLiteral("%1, %2, %3").arg(length(high.x), length(high.y), length(high.z))}};
        if (source_.axis.free)
            facts.emplace_back(SheetText::tr("Tool axis"), SheetText::tr("free"));
        else if (source_.axis.direction != uprightAxis)
            facts.emplace_back(SheetText::tr("Tool axis"), QStringLiteral("%1, %2, %3")
                                                               .arg(fixedNumber(source_.axis.direction.x, 4),
                                                                    fixedNumber(source_.axis.direction.y, 4),
                                                                    fixedNumber(source_.axis.direction.z, 4)));
        page_.facts(facts);
    }

    void stock() {
        page_.section(SheetText::tr("Stock"));
        const Box& stock = source_.setup.stock;
        Facts facts{{SheetText::tr("Size"), sizeText(stock.size(), unit_)},
                    {SheetText::tr("From"), place(stock.low)},
                    {SheetText::tr("To"), place(stock.high)}};
        if (source_.setup.form == StockForm::cylinder)
            facts.emplace_back(SheetText::tr("Round bar"), SheetText::tr("diameter %1, length %2")
                                                               .arg(length(2.0 * source_.setup.cylinder.radius),
                                                                    length(source_.setup.cylinder.height)));
        if (source_.setup.leftBy)
            facts.emplace_back(SheetText::tr("Comes from"),
                               SheetText::tr("setup %1").arg(numberOf(source_.setup.leftBy->setup)));
        for (const MaterialAmount& amount : content_.amounts) {
            if (!(amount.volume > 0.0) || amount.isProtected) continue;
            QString value = volumeText(amount.volume, unit_);
            if (amount.mass) value += SheetText::tr(", %1 g").arg(fixedNumber(*amount.mass, 0));
            facts.emplace_back(text(amount.name), value);
        }
        facts.emplace_back(SheetText::tr("Part"), placementText(source_.setup.placement, unit_));
        page_.facts(facts);
    }

    void fixtures() {
        page_.section(SheetText::tr("Fixtures and keep-out volumes"));
        if (source_.obstacles.empty()) return page_.sentence(SheetText::tr("None."));
        std::vector<QStringList> rows;
        for (const Obstacle& obstacle : source_.obstacles) {
            const Box box = boundsOf(obstacle);
            const QString kind =
                obstacle.kind == ObstacleKind::fixture ? SheetText::tr("fixture") : SheetText::tr("keep out");
            rows.push_back({text(obstacle.name), obstacle.on ? kind : SheetText::tr("%1, off").arg(kind),
                            place(box.low), place(box.high), length(obstacle.margin)});
        }
        page_.table({SheetText::tr("Name"), SheetText::tr("Kind"), SheetText::tr("From"), SheetText::tr("To"),
                     SheetText::tr("Clearance")},
                    rows);
        for (const auto& [name, fit] : content_.badFits) page_.sentence(fitText(name, fit, unit_), true);
    }

    static QString range(double least, double most, int decimals) {
        if (!(most > 0.0)) return QStringLiteral("–");
        const QString high = fixedNumber(most, decimals), low = fixedNumber(least, decimals);
        return low == high ? high : low + QStringLiteral(" – ") + high;
    }

    QStringList row(const Tool& tool, const ToolUse* use) const {
        QStringList cells{QStringLiteral("T%1").arg(tool.number), toolName(tool), toolSummary(tool, unit_),
                          length(tool.cutter.stickOut)};
        if (!use) return cells;
        const bool inch = unit_ == LengthUnit::inch;
        const double perUnit = inch ? 1.0 / 25.4 : 1.0;
        cells << range(use->leastSpeed, use->mostSpeed, 0)
              << range(use->leastFeed * perUnit, use->mostFeed * perUnit, inch ? 1 : 0)
              << (std::isfinite(use->deepest) ? number(use->deepest) : QStringLiteral("–"))
              << durationText(use->seconds);
        return cells;
    }

    void tools() {
        page_.section(SheetText::tr("Tools"));
        if (source_.tools.empty()) return page_.sentence(SheetText::tr("None yet."));
        QStringList heads{SheetText::tr("Number"), SheetText::tr("Tool"), SheetText::tr("Cutter"),
                          SheetText::tr("Stick-out")};
        if (use_)
            heads << SheetText::tr("Speed, 1/min")
                  << (unit_ == LengthUnit::inch ? SheetText::tr("Feed, in/min") : SheetText::tr("Feed, mm/min"))
                  << SheetText::tr("Lowest Z, %1").arg(unitText(unit_)) << SheetText::tr("Time");
        std::vector<QStringList> rows;
        double longest = 0.0;
        for (std::size_t i = 0; i < source_.tools.size(); ++i) {
            rows.push_back(row(source_.tools[i], use_ ? &use_->tools[i] : nullptr));
            longest = std::max(longest, source_.tools[i].cutter.length());
        }
        page_.table(heads, rows);
        constexpr double tallest = 300.0; // pixels
        QStringList pictures;
        for (const Tool& tool : source_.tools)
            pictures << toolPicture(tool, tallest / longest, unit_) +
                            QStringLiteral("<br>T%1 %2").arg(tool.number).arg(toolName(tool).toHtmlEscaped());
        page_.marks(pictures);
    }

    void program() {
        if (!source_.program) return;
        const CheckedProgram& program = *source_.program;
        page_.section(SheetText::tr("Program"));
        Facts facts;
        if (!source_.programName.empty()) facts.emplace_back(SheetText::tr("File"), text(source_.programName));
        facts.emplace_back(SheetText::tr("Check"), program.passed() ? SheetText::tr("passed")
                                                   : program.overridden
                                                       ? SheetText::tr("failed, exported with a reason")
                                                       : SheetText::tr("failed"));
        facts.emplace_back(
            SheetText::tr("Maximum gouge"),
            SheetText::tr("%1 (tolerance %2)").arg(length(program.report.gougeMax), length(program.gougeTolerance)));
        facts.emplace_back(SheetText::tr("Machining time"), durationText(use_->seconds));
        facts.emplace_back(SheetText::tr("Blocks"), countText(program.parsed.blocks));
        page_.facts(facts);
        findings(program.report);
    }

    void findings(const VerifyReport& report) {
        std::vector<QStringList> rows;
        const auto add = [&](const std::vector<Finding>& found, const QString& kind) {
            for (const Finding& finding : found)
                rows.push_back({kind, finding.line > 0 ? QString::number(finding.line) : QString(),
                                findingText(finding, unit_), place(finding.place)});
        };
        add(report.findings, SheetText::tr("error"));
        add(report.warnings, SheetText::tr("warning"));
        for (const NearPass& pass : report.nearPasses)
            rows.push_back(
                {SheetText::tr("warning"), QString::number(pass.line), nearPassText(pass, unit_), place(pass.place)});
        if (rows.empty()) return page_.sentence(SheetText::tr("The check found nothing."));
        page_.table({SheetText::tr("Found"), SheetText::tr("Line"), SheetText::tr("What"), SheetText::tr("Where")},
                    rows);
    }

    const SheetContent& content_;
    const SheetSource& source_;
    LengthUnit unit_;
    SheetPage page_;
    std::optional<ProgramUse> use_; ///< of the program, if there is one
};

} // namespace

PictureContent sheetPicture(const SheetContent& content) {
    const SheetSource& source = content.source;
    PictureContent picture;
    picture.workpiece = content.stock;
    picture.part = source.model;
    picture.obstacles = source.obstacles;
    picture.zero =
        ZeroPlace{source.setup.workOffset, QString::fromStdString(workOffsetName(source.setup.zero.workOffset))};
    picture.opacity = 0.45;
    picture.theme = Theme::light;
    picture.width = 1120;
    picture.height = 760;
    return picture;
}

std::string setupSheet(const SheetContent& content, LengthUnit unit, std::span<const std::string> pictures) {
    return Sheet(content, unit).write(pictures).toStdString();
}

} // namespace burin
