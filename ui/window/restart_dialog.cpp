// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/restart_dialog.h"

#include "ui/dialogs/questions.h"
#include "ui/panels/buttons.h"
#include "ui/panels/notice.h"
#include "ui/panels/quantity.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize restartDialogSize(640, 560);

/// Texts of this page.
struct RestartDialog {
    Q_DECLARE_TR_FUNCTIONS(RestartDialog)
};

/// The first cut of the rest; null if there is none.
const NcMotion* firstCutOf(const ParsedProgram& program) {
    const auto found = std::ranges::find_if(program.motions, [](const NcMotion& one) {
        return one.kind == NcMotionKind::line || one.kind == NcMotionKind::arc;
    });
    return found == program.motions.end() ? nullptr : &*found;
}

QString factsOf(const RestartedProgram& rest, LengthUnit unit) {
    QStringList facts{
        RestartDialog::tr("The first cut is line %1 of the interrupted program; all lines before it count "
                          "as done.")
            .arg(rest.line)};
    facts << RestartDialog::tr("The tool comes down from above to X %1, Y %2, Z %3.")
                 .arg(lengthText(rest.place.x, unit), lengthText(rest.place.y, unit), lengthText(rest.place.z, unit));
    if (rest.lead > 0.0)
        facts << RestartDialog::tr("The last %1 of the path before that line are cut again.")
                     .arg(lengthText(rest.lead, unit));
    if (const NcMotion* cut = firstCutOf(rest.program.parsed)) {
        const Tool* tool = rest.program.toolNumbered(cut->tool);
        facts << RestartDialog::tr("Tool %1%2 at %3. Measure the new tool first.")
                     .arg(QString::number(cut->tool),
                          tool == nullptr ? QString() : QStringLiteral(": ") + toolName(*tool),
                          quantityText(cut->spindleSpeed, Quantity::rotation, unit));
    }
    return facts.join(QLatin1Char('\n'));
}

/// The findings that refuse it, one per line; empty: none.
QString findingsOf(const CheckedProgram& program, LengthUnit unit) {
    constexpr qsizetype most = 8;
    QStringList lines;
    const auto add = [&](std::uint32_t line, const QString& text) {
        lines << (line > 0 ? RestartDialog::tr("Line %1: %2").arg(QString::number(line), text)
                           : RestartDialog::tr("Program: %1").arg(text));
    };
    for (const Finding& finding : program.report.findings) add(finding.line, findingText(finding, unit));
    for (const LintMark& mark : program.lint)
        if (mark.severity == LintSeverity::error) add(mark.line, lintText(mark));
    const qsizetype more = lines.size() - most;
    if (more > 0) {
        lines.resize(most);
        lines << RestartDialog::tr("and %n more", nullptr, static_cast<int>(more));
    }
    return lines.join(QLatin1Char('\n'));
}

QString verdictOf(const CheckedProgram& program) {
    if (program.released()) return RestartDialog::tr("Passed its check on the stock that is left.");
    const auto count = static_cast<int>(program.errorCount());
    return count == 1 ? RestartDialog::tr("Did not pass its check on the stock that is left (1 finding). Choose an "
                                          "earlier line, or override the check with a reason.")
                      : RestartDialog::tr("Did not pass its check on the stock that is left (%n findings). Choose an "
                                          "earlier line, or override the check with a reason.",
                                          nullptr, count);
}

QLabel* makeLines(const QString& text, const char* name, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

RestartAnswer askRestart(QWidget* parent, const RestartedProgram& rest, LengthUnit unit) {
    QDialog dialog(parent);
    dialog.setObjectName(QStringLiteral("restartDialog"));
    dialog.setWindowTitle(RestartDialog::tr("Restart"));
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(10);
    auto* title = new QLabel(RestartDialog::tr("Restart at line %1").arg(rest.from), &dialog);
    title->setProperty("look", "title");
    column->addWidget(title);
    column->addWidget(makeLines(factsOf(rest, unit), "restartFacts", &dialog));
    const bool released = rest.program.released();
    auto* verdict = new Notice(&dialog);
    verdict->tell(released ? Notice::Kind::passed : Notice::Kind::error, verdictOf(rest.program));
    column->addWidget(verdict);
    if (const QString findings = findingsOf(rest.program, unit); !findings.isEmpty())
        column->addWidget(makeLines(findings, "restartFindings", &dialog));
    auto* text = new QPlainTextEdit(QString::fromStdString(rest.program.text), &dialog);
    text->setObjectName(QStringLiteral("restartText"));
    text->setAccessibleName(RestartDialog::tr("The rest of the program"));
    text->setReadOnly(true);
    text->setFont(numberFont(text->font()));
    column->addWidget(text, 1);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    auto* cancel =
        makeButton(RestartDialog::tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelButton"), &dialog);
    QPushButton* write =
        makePrimaryButton(RestartDialog::tr("Export…"), QStringLiteral("exportRestartButton"), &dialog);
    auto* override = makeButton(RestartDialog::tr("Override the check…"), QStringLiteral("warning"),
                                QStringLiteral("overrideRestartButton"), &dialog);
    override->setToolTip(RestartDialog::tr("Write the rest nevertheless; its header shows your reason"));
    override->setVisible(!released);
    row->addWidget(cancel);
    row->addWidget(override);
    row->addWidget(write);
    column->addLayout(row);
    cancel->setToolTip(RestartDialog::tr("Write nothing; the program stays as it is (Esc)"));
    enableUnless(
        write, released ? QString() : verdictOf(rest.program),
        RestartDialog::tr("Write the rest as a program of its own; the program of the project stays as it is"));
    QObject::connect(write, &QPushButton::clicked, &dialog, &QDialog::accept);
    RestartAnswer answer;
    QObject::connect(override, &QPushButton::clicked, &dialog, [&] {
        answer.overrideReason = askOverride(&dialog, static_cast<int>(rest.program.errorCount()));
        if (!answer.overrideReason.isEmpty()) dialog.accept();
    });
    QObject::connect(cancel, &QPushButton::clicked, &dialog, &QDialog::reject);
    write->setDefault(released);
    (released ? write : cancel)->setFocus();
    dialog.resize(restartDialogSize);
    answer.write = dialog.exec() == QDialog::Accepted;
    return answer;
}

} // namespace burin
