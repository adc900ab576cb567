// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.h"
#include "tests/architecture/tree_of_files.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <filesystem>

namespace burin::tst_includes {

using namespace burin::architecture;
namespace fs = std::filesystem;

namespace {

/// core/README.md of this tree.
Arrows ourArrows() {
    return Arrows::read(fs::path(BURIN_SOURCE_DIRECTORY) / "core/README.md");
}

Arrows arrowsOf(const QTemporaryDir& tree, const QString& tables) {
    place(tree, QStringLiteral("core/README.md"), tables);
    return Arrows::read(tree.filePath(QStringLiteral("core/README.md")).toStdString());
}

const QString licence = QStringLiteral("// SPDX-FileCopyrightText: 2026 The Burin authors\n"
                                       "// SPDX-License-Identifier: Apache-2.0\n");

} // namespace

class TestIncludes : public QObject {
    Q_OBJECT
private slots:
    void ourSourcesKeepToTheArrows() {
        QCOMPARE(told(forbiddenIncludes(BURIN_SOURCE_DIRECTORY, ourArrows())), QString());
    }

    void ourLibrariesLinkWhatTheyMayUse() {
        QCOMPARE(told(forbiddenLinks(BURIN_SOURCE_DIRECTORY, ourArrows())), QString());
    }

    /// The page names every existing room, and no other.
    void thePageNamesTheRooms() {
        QCOMPARE(told(ourArrows().faults()), QString());
        const fs::path root(BURIN_SOURCE_DIRECTORY);
        std::vector<std::string> rooms{"app", "plugins"};
        for (const char* top : {"core", "ui"})
            for (const fs::directory_entry& entry : fs::directory_iterator(root / top))
                if (entry.is_directory()) rooms.push_back(fs::relative(entry.path(), root).generic_string());
        std::ranges::sort(rooms);
        QCOMPARE(listed(ourArrows().libraries()), listed(rooms));
        QStringList foreign = listed(ourArrows().foreignLibraries());
        QCOMPARE(foreign, listed(watchedForeignLibraries()));
    }

    void ourTypesHaveNamesOfTheirOwn() { QCOMPARE(told(typesDefinedTwice(BURIN_SOURCE_DIRECTORY)), QString()); }

    void ourSourcesStateTheirLicence() {
        const std::vector<std::string> files = projectFiles(BURIN_SOURCE_DIRECTORY);
        QVERIFY(files.size() > 100);
        QCOMPARE(told(missingLicences(BURIN_SOURCE_DIRECTORY, files)), QString());
    }

    void ourFilesNameNoMachine() {
        const std::vector<std::string> files = projectFiles(BURIN_SOURCE_DIRECTORY);
        QCOMPARE(told(namedMachines(BURIN_SOURCE_DIRECTORY, files)), QString());
    }

    /// The rules themselves: a tree of one file with one include line.
    void eachRuleIsWatched_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const char* file, const char* line, const char* fault) {
            QTest::newRow(name) << QString::fromLatin1(file) << QString::fromLatin1(line) << QString::fromLatin1(fault);
        };
        row("a library uses itself", "core/volume/a.cpp", "#include \"core/volume/b.h\"", "");
        row("a library uses what it names", "core/volume/a.h", "#include \"core/geometry/box.h\"", "");
        row("a library uses what those use", "core/job/a.cpp", "#include \"core/field/tool_field.h\"", "");
        row("upwards", "core/volume/a.h", "#include \"core/setup/setup.h\"", "core/volume may not use core/setup");
        row("sideways", "core/cutting/a.cpp", "#include \"core/cad/model.h\"", "core/cutting may not use core/cad");
        row("spaces hide nothing", "core/base/a.cpp", "  #  include  \"core/geometry/box.h\"",
            "core/base may not use core/geometry");
        row("core uses the user interface", "core/nc/a.cpp", "#include \"ui/messages/messages.h\"",
            "core/nc may not use ui/messages");
        row("core uses the program", "core/nc/a.cpp", "#include \"app/command.h\"", "core/nc may not use app");
        row("core uses tests", "core/nc/a.cpp", "#include \"tests/oracles/grid.h\"", "core/nc may not use tests");
        row("core includes Qt", "core/verify/a.cpp", "#include <QString>", "core/verify may not include Qt");
        row("core includes Qt by its module", "core/verify/a.h", "#include <QtCore/qstring.h>",
            "core/verify may not include Qt");
        row("core includes VTK", "core/volume/a.cpp", "#include <vtkPolyData.h>", "core/volume may not include VTK");
        row("OpenCASCADE behind glass", "core/cad/a.cpp", "#include <BRep_Builder.hxx>", "");
        row("OpenCASCADE elsewhere", "core/setup/a.cpp", "#include <gp_Pnt.hxx>",
            "core/setup may not include OpenCASCADE");
        row("SQLite elsewhere", "app/a.cpp", "#include <sqlite3.h>", "app may not include SQLite");
        row("VTK in the scene", "ui/scene/a.cpp", "#include <vtkPolyData.h>", "");
        row("VTK elsewhere", "ui/panels/a.cpp", "#include <vtkPolyData.h>", "ui/panels may not include VTK");
        row("messages use the scene", "ui/messages/a.cpp", "#include \"ui/scene/picture.h\"",
            "ui/messages may not use ui/scene");
        row("the program uses everything", "app/a.cpp", "#include \"ui/scene/picture.h\"", "");
        row("the program uses a plugin", "app/a.cpp", "#include \"plugins/dialects/linuxcnc/words.h\"",
            "app may not use plugins");
        row("a plugin uses its interface", "plugins/dialects/linuxcnc/a.cpp", "#include \"core/nc/dialect.h\"", "");
        row("a plugin uses itself", "plugins/dialects/linuxcnc/a.cpp", "#include \"plugins/dialects/linuxcnc/words.h\"",
            "");
        row("a plugin uses another", "plugins/dialects/haas/a.cpp", "#include \"plugins/dialects/linuxcnc/words.h\"",
            "plugins may not use plugins");
        row("a device plugin uses what those share", "plugins/devices/spacemouse/a.cpp",
            "#include \"plugins/devices/hid/hid_bus.h\"", "");
        row("another kind of plugin uses that", "plugins/dialects/haas/a.cpp",
            "#include \"plugins/devices/hid/hid_bus.h\"", "plugins may not use plugins");
        row("hidapi elsewhere", "core/device/a.cpp", "#include <hidapi.h>", "core/device may not include hidapi");
        row("a plugin uses code of core", "plugins/dialects/haas/a.cpp", "#include \"core/nc/parser.h\"",
            "plugins may not use core/nc");
        row("a file that is handed out names its neighbour", "plugins/devices/open_stylus/firmware/a.c",
            "#include \"open_stylus.h\"", "");
        row("a file that is handed out names our tree", "plugins/devices/open_stylus/firmware/a.c",
            "#include \"core/device/stylus.h\"", "what is handed out stands alone");
        row("a name from nowhere", "core/nc/a.cpp", "#include \"parser.h\"", "our headers are named from the root");
        row("a library from nowhere", "core/utils/a.cpp", "#include <vector>",
            "core/utils has no row in core/README.md");
        row("a comment includes nothing", "core/base/a.cpp", "// #include <QString>", "");
    }
    void eachRuleIsWatched() {
        QFETCH(QString, file);
        QFETCH(QString, line);
        QFETCH(QString, fault);
        const QTemporaryDir tree;
        place(tree, file, licence + QStringLiteral("#include <vector>\n") + line + QStringLiteral("\n"));
        const QStringList faults = listed(forbiddenIncludes(tree.path().toStdString(), ourArrows()));
        if (fault.isEmpty()) {
            QCOMPARE(faults, QStringList());
        } else {
            QCOMPARE(faults.size(), 1);
            QVERIFY2(faults.front().startsWith(file) && faults.front().endsWith(fault), qPrintable(faults.front()));
        }
    }

    /// The tables of a page, and their faults.
    void aPageThatContradictsItselfIsSeen_data() {
        QTest::addColumn<QString>("rows");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const char* rows, const char* fault) {
            QTest::newRow(name) << QString::fromLatin1(rows) << QString::fromLatin1(fault);
        };
        row("in order", "| `core/a` | - | x |\n| `core/b` | `core/a` | x |\n| `app` | `core` | x |\n", "");
        row("a room twice", "| `core/a` | - | x |\n| `core/a` | - | x |\n", "core/a stands in two rows");
        row("a room that is not there", "| `core/a` | `core/z` | x |\n", "core/a may use core/z, which has no row");
        row("a circle", "| `core/a` | `core/b` | x |\n| `core/b` | `core/a` | x |\n",
            "core/a and core/b make a circle\ncore/b and core/a make a circle");
    }
    void aPageThatContradictsItselfIsSeen() {
        QFETCH(QString, rows);
        QFETCH(QString, fault);
        const QTemporaryDir tree;
        const Arrows arrows = arrowsOf(tree, QStringLiteral("text\n\n| room | may use | for |\n|---|---|---|\n") +
                                                 rows + QStringLiteral("\ntext\n"));
        QCOMPARE(told(arrows.faults()), fault);
    }

    /// A library of core, what it links, and the fault in that.
    void aForbiddenLinkIsSeen() {
        const QTemporaryDir tree;
        const Arrows arrows =
            arrowsOf(tree, QStringLiteral("| room | may use | for |\n|---|---|---|\n"
                                          "| `core/a` | - | |\n| `core/b` | `core/a` | |\n| `core/c` | - | |\n"));
        place(tree, QStringLiteral("core/a/CMakeLists.txt"), QStringLiteral("burin_library(a\n    SOURCES a.cpp)\n"));
        place(tree, QStringLiteral("core/b/CMakeLists.txt"),
              QStringLiteral("burin_library(b UNITY\n    SOURCES b.cpp\n    PUBLIC burin::a\n    PRIVATE burin::c)\n"
                             "burin_library(b_interface\n    PUBLIC burin::a)\n"));
        place(tree, QStringLiteral("core/c/CMakeLists.txt"), QStringLiteral("burin_library(c\n    PUBLIC burin::d)\n"));
        QCOMPARE(listed(forbiddenLinks(tree.path().toStdString(), arrows)),
                 (QStringList{QStringLiteral("core/b: burin::b may not link burin::c"),
                              QStringLiteral("core/c: burin::c may not link burin::d")}));
    }

    /// Two files of a tree, each with a definition in Burin's namespace.
    void typesOfOneNameAreSeen_data() {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<bool>("fault");
        const auto row = [](const char* name, const char* one, const char* other, bool fault) {
            QTest::newRow(name) << QString::fromLatin1(one) << QString::fromLatin1(other) << fault;
        };
        row("a struct and a class", "struct Range {\n};", "class Range {\n};", true);
        row("on one line", "struct Range { int low; };", "struct Range {};", true);
        row("an enumeration", "enum class Side : char { left };", "enum class Side { right };", true);
        row("a final one, a derived one", "class Part final : public Piece {\n};", "struct Part : Piece {\n};", true);
        row("a head of two lines", "class Part\n    : public Piece {\n};", "struct Part {\n};", true);
        row("a template", "template <class T>\nclass Box {\n};", "template <class T> class Box {\n};", true);
        row("with attributes", "struct alignas(64) Row {\n};", "class [[nodiscard]] Row {\n};", true);
        row("in an inner namespace", "namespace inner {\nstruct A {\n};\n} // namespace inner",
            "namespace inner {\nstruct A {\n};\n} // namespace inner", true);
        row("another name", "struct Range {\n};", "struct Ranges {\n};", false);
        row("a declaration", "struct Range {\n};", "struct Range;", false);
        row("one of its own within another type", "struct Range {\n};", "struct Row {\n    struct Range {};\n};",
            false);
        row("within types of other names", "struct A::Range {\n};", "struct B::Range {\n};", false);
        row("specialised for another type", "template <>\nclass Box<int> {\n};", "template <>\nclass Box<char> {\n};",
            false);
        row("in an unnamed namespace", "struct Range {\n};", "namespace {\nstruct Range {\n};\n} // namespace", false);
        row("in another namespace", "struct A {\n};", "namespace inner {\nstruct A {\n};\n} // namespace inner", false);
    }
    void typesOfOneNameAreSeen() {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(bool, fault);
        const QTemporaryDir tree;
        const QString frame = QStringLiteral("namespace burin {\n\n%1\n\n} // namespace burin\n");
        place(tree, QStringLiteral("core/volume/a.h"), frame.arg(one));
        place(tree, QStringLiteral("ui/scene/b.cpp"), frame.arg(other));
        const QStringList faults = listed(typesDefinedTwice(tree.path().toStdString()));
        QCOMPARE(faults.size(), fault ? 1 : 0);
        if (fault)
            QVERIFY2(faults.front().startsWith(QLatin1String("ui/scene/b.cpp: burin::")), qPrintable(faults.front()));
    }

    void aMissingLicenceIsSeen() {
        const QTemporaryDir tree;
        place(tree, QStringLiteral("with.cpp"), licence);
        place(tree, QStringLiteral("without.h"), QStringLiteral("#pragma once\n"));
        place(tree, QStringLiteral("script"), QStringLiteral("#!/bin/sh\n"));
        place(tree, QStringLiteral("data.json"), QStringLiteral("{}\n"));
        place(tree, QStringLiteral("build/made.cpp"), QStringLiteral("int made;\n"));
        const std::string root = tree.path().toStdString();
        QStringList faults = listed(missingLicences(root, projectFiles(root)));
        faults.sort();
        QCOMPARE(faults, (QStringList{QStringLiteral("script"), QStringLiteral("without.h")}));
    }

    void anotherMachinesPlaceIsSeen() {
        const QTemporaryDir tree;
        place(tree, QStringLiteral("a.md"), QStringLiteral("See /tmp/") + QStringLiteral("burin/a.\n"));
        place(tree, QStringLiteral("b.md"), QStringLiteral("See /tmp and work/.\n"));
        const std::string root = tree.path().toStdString();
        QCOMPARE(namedMachines(root, projectFiles(root)).size(), std::size_t{1});
    }
};

BURIN_TEST(TestIncludes, NoApplication)

} // namespace burin::tst_includes

#include "tst_includes.moc"
