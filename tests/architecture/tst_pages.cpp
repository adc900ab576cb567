// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"
#include "tests/architecture/page_rules.h"
#include "tests/architecture/tree_of_files.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_pages {

using namespace burin::architecture;

/// Pages and comments cite only files that are in the repository.
class TestPages : public QObject {
    Q_OBJECT
private slots:
    void whatOurPagesNameIsThere() {
        const std::vector<std::string> files = projectFiles(BURIN_SOURCE_DIRECTORY);
        QVERIFY(files.size() > 100);
        const std::vector<std::string> dead = deadReferences(BURIN_SOURCE_DIRECTORY, files);
        QVERIFY2(dead.empty(), qPrintable(told(dead)));
    }

    void aDeadReferenceIsSeen_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("fault");
        // Names of pages are written in two pieces, so that this file names none.
        const auto row = [](const char* name, const char* file, const char* text, bool fault) {
            QTest::newRow(name) << QString::fromLatin1(file) << QString::fromLatin1(text) << fault;
        };
        row("a source", "core/a/README.md", "See `core/a/b.cpp`.", false);
        row("a folder", "README.md", "See `core/a`.", false);
        row("a source by its name alone", "core/a/README.md", "See `b.cpp`.", false);
        row("a command", "README.md", "`core/a/b.cpp --help`", false);
        row("no file of ours", "README.md", "`/dev/hidraw*`, `1/256`, `core/a/<id>.json`", false);
        row("a source that is gone", "README.md", "See `core/a/c.cpp`.", true);
        row("a folder that is gone", "README.md", "See `core/z`.", true);
        row("the name of a source that is gone", "README.md", "See `c.cpp`.", true);
        row("a page by its name alone", "core/b/c.h",
            "int c; // PAGE"
            ".md says why.",
            false);
        row("a page by its path", "app/c.cpp",
            "// core/a/PAGE"
            ".md",
            false);
        row("a page that is not there", "core/a/c.h",
            "// See plan"
            ".md, section 3.",
            true);
        row("no comment", "core/a/c.h",
            "const char* name = \"plan"
            ".md\";",
            false);
    }
    void aDeadReferenceIsSeen() {
        QFETCH(QString, file);
        QFETCH(QString, text);
        QFETCH(bool, fault);
        const QTemporaryDir tree;
        place(tree, QStringLiteral("core/a/b.cpp"), QString());
        place(tree, QStringLiteral("core/a/PAGE.md"), QString());
        place(tree, file, QStringLiteral("\n") + text + QStringLiteral("\n"));
        const std::string root = tree.path().toStdString();
        const QStringList faults = listed(deadReferences(root, projectFiles(root)));
        QCOMPARE(faults.size(), fault ? 1 : 0);
        if (fault) QVERIFY2(faults.front().startsWith(file + QStringLiteral(":2: ")), qPrintable(faults.front()));
    }
};

BURIN_TEST(TestPages, NoApplication)

} // namespace burin::tst_pages

#include "tst_pages.moc"
