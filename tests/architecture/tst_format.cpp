// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"
#include "tests/architecture/tree_of_files.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <array>

namespace burin::tst_format {

using namespace burin::architecture;

namespace {

const QString formatter = QStringLiteral("clang-format-14");

/// Files that the formatter would change. @param files relative to `root`
QStringList deviating(const QString& root, const QStringList& files) {
    std::array<QProcess, 4> processes; // takes a quarter of the time on as many cores
    for (qsizetype i = 0; i < 4; ++i) {
        QStringList arguments{QStringLiteral("--dry-run"), QStringLiteral("--style=file")};
        const qsizetype share = (files.size() + 3) / 4;
        arguments += files.mid(i * share, share);
        QProcess& process = processes[static_cast<std::size_t>(i)];
        process.setWorkingDirectory(root);
        process.setProcessChannelMode(QProcess::MergedChannels);
        if (arguments.size() > 2) process.start(formatter, arguments);
    }
    QStringList found;
    const QRegularExpression warning(QStringLiteral("^([^:\n]+):\\d+:\\d+: warning: code should be clang-formatted"),
                                     QRegularExpression::MultilineOption);
    for (QProcess& process : processes) {
        if (process.state() == QProcess::NotRunning) continue;
        if (!process.waitForFinished(240000) || process.exitCode() != 0) found << QStringLiteral("no answer");
        const QString output = QString::fromUtf8(process.readAll());
        for (auto each = warning.globalMatch(output); each.hasNext();) found << each.next().captured(1);
    }
    found.removeDuplicates();
    return found;
}

} // namespace

class TestFormat : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable(formatter).isEmpty())
            QSKIP("clang-format-14 is not installed (tests/packages.txt names it)");
    }

    void ourSourcesAreFormatted() {
        QStringList sources;
        for (const QString& file : listed(projectFiles(BURIN_SOURCE_DIRECTORY)))
            if (file.endsWith(QLatin1String(".h")) || file.endsWith(QLatin1String(".cpp"))) sources << file;
        QVERIFY(sources.size() > 100);
        const QStringList found = deviating(QStringLiteral(BURIN_SOURCE_DIRECTORY), sources);
        QVERIFY2(found.isEmpty(), qPrintable(QStringLiteral("clang-format-14 -i ") + found.join(QLatin1Char(' '))));
    }

    void aDeviationIsSeen() {
        const QTemporaryDir tree;
        QVERIFY(QFile::copy(QStringLiteral(BURIN_SOURCE_DIRECTORY "/.clang-format"), tree.filePath(".clang-format")));
        place(tree, QStringLiteral("core/a.h"), QStringLiteral("int* a = nullptr;\n"));
        place(tree, QStringLiteral("core/b.cpp"), QStringLiteral("int *b = nullptr;\n"));
        const QStringList files{QStringLiteral("core/a.h"), QStringLiteral("core/b.cpp")};
        QCOMPARE(deviating(tree.path(), files), (QStringList{QStringLiteral("core/b.cpp")}));
    }
};

BURIN_TEST(TestFormat, QCoreApplication)

} // namespace burin::tst_format

#include "tst_format.moc"
