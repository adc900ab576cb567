// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/reach_rules.h"
#include "tests/architecture/tree_of_files.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <initializer_list>
#include <utility>

namespace burin::tst_reach {

using namespace burin::architecture;

namespace {

using Files = QList<std::pair<QString, QString>>;

QStringList unreachedOf(const Files& files) {
    const QTemporaryDir tree;
    for (const auto& [file, content] : files) place(tree, file, content);
    return listed(unreachedSources(tree.path().toStdString()));
}

} // namespace

class TestReach : public QObject {
    Q_OBJECT
private slots:
    /// Code that a user can't reach is removed, or has a reason to stay.
    void whatNoProgramReachesHasAReason() {
        const std::filesystem::path root(BURIN_SOURCE_DIRECTORY);
        const std::vector<std::string> unreached = unreachedSources(root);
        const auto reasons = reasonsToStay(root / "tests/architecture/unreached_sources.md");
        QVERIFY(!reasons.empty());
        const std::vector<std::string> faults = faultsOfReasons(unreached, reasons);
        QVERIFY2(faults.empty(), qPrintable(told(faults)));
    }

    /// The rule itself: trees of a few files, and the files of core that no program reaches.
    void theRuleIsWatched_data() {
        QTest::addColumn<Files>("files");
        QTest::addColumn<QStringList>("unreached");
        const auto row = [](const char* name, std::initializer_list<std::pair<const char*, const char*>> files,
                            const QStringList& unreached) {
            Files list;
            for (const auto& [file, content] : files)
                list.append({QString::fromLatin1(file), QString::fromLatin1(content)});
            QTest::newRow(name) << list << unreached;
        };
        const char* includesA = "#include \"core/a/a.h\"\nint main() { return f(); }\n";
        row("a header, and the source of its name",
            {{"app/main.cpp", includesA}, {"core/a/a.h", "int f();\n"}, {"core/a/a.cpp", "#include \"core/a/a.h\"\n"}},
            {});
        row("what that source includes",
            {{"app/main.cpp", includesA},
             {"core/a/a.h", "int f();\n"},
             {"core/a/a.cpp", "#include \"core/b/b.h\"\n"},
             {"core/b/b.h", ""},
             {"core/b/b.cpp", ""}},
            {});
        row("what the import program includes",
            {{"app/import/main.cpp", "#include \"core/a/a.h\"\n"}, {"core/a/a.h", ""}}, {});
        row("what a plugin includes", {{"plugins/devices/x/x.cpp", "#include \"core/a/a.h\"\n"}, {"core/a/a.h", ""}},
            {});
        row("nobody includes it",
            {{"app/main.cpp", ""}, {"core/a/a.h", ""}, {"core/a/a.cpp", "#include \"core/a/a.h\"\n"}},
            {"core/a/a.cpp", "core/a/a.h"});
        row("a test includes it",
            {{"app/main.cpp", ""}, {"core/a/a.h", ""}, {"tests/core/a/tst_a.cpp", "#include \"core/a/a.h\"\n"}},
            {"core/a/a.h"});
        row("a source of another name, called",
            {{"app/main.cpp", includesA},
             {"core/a/a.h", "int f();\n"},
             {"core/a/other.cpp", "#include \"core/a/a.h\"\n\nint f() {\n    return 0;\n}\n"}},
            {});
        row("a source of another name, called by its class",
            {{"app/main.cpp", "#include \"core/a/a.h\"\nint main() { return A().f(); }\n"},
             {"core/a/a.h", "struct A {\n    int f();\n};\n"},
             {"core/a/other.cpp", "#include \"core/a/a.h\"\n\nint A::f() {\n    return 0;\n}\n"}},
            {});
        row("a source of another name, not called",
            {{"app/main.cpp", includesA},
             {"core/a/a.h", "int f();\nint g();\n"},
             {"core/a/other.cpp", "#include \"core/a/a.h\"\n\nint g() {\n    return 0;\n}\n"}},
            {"core/a/other.cpp"});
        row("a source of another name, called in a comment",
            {{"app/main.cpp", "#include \"core/a/a.h\" // g\n// g()\n"},
             {"core/a/a.h", "int g();\n"},
             {"core/a/other.cpp", "#include \"core/a/a.h\"\n\nint g() {\n    return 0;\n}\n"}},
            {"core/a/other.cpp"});
        row("called by what is not reached",
            {{"app/main.cpp", includesA},
             {"core/a/a.h", "int f();\nint g();\n"},
             {"core/a/b.h", ""},
             {"core/a/b.cpp", "int h() {\n    return g();\n}\n"},
             {"core/a/other.cpp", "#include \"core/a/a.h\"\n\nint g() {\n    return 0;\n}\n"}},
            {"core/a/b.cpp", "core/a/b.h", "core/a/other.cpp"});
    }
    void theRuleIsWatched() {
        QFETCH(Files, files);
        QFETCH(QStringList, unreached);
        QCOMPARE(unreachedOf(files), unreached);
    }

    void aReasonThatIsMissingIsSeen() {
        QCOMPARE(faultsOfReasons({"core/a/a.cpp", "core/a/a.h"}, {{"core/a/a", "Later"}}).size(), std::size_t{0});
        QCOMPARE(told(faultsOfReasons({"core/a/a.h"}, {})),
                 QStringLiteral("core/a/a.h is reached by no program, and no reason says why it stays"));
    }
    void aReasonThatIsNoLongerNeededIsSeen() {
        QCOMPARE(told(faultsOfReasons({}, {{"core/a/a", "Later"}})),
                 QStringLiteral("core/a/a needs no reason: a program reaches it, or it is gone"));
        QCOMPARE(told(faultsOfReasons({"core/a/a.h"}, {{"core/a/a", ""}})),
                 QStringLiteral("core/a/a has an empty reason"));
    }
};

BURIN_TEST(TestReach, NoApplication)

} // namespace burin::tst_reach

#include "tst_reach.moc"
