// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_libraries.h"
#include "core/tool/tool_library.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace burin::tst_tool_libraries {

namespace {

using Names = std::vector<std::string>;

Names names() {
    return loadToolLibraries().value().names;
}
std::string libraryOf(const std::string& tool) {
    return loadToolLibraries().value().libraryOf(tool);
}

} // namespace

/// Named libraries of the user's own tools.
class TestToolLibraries : public QObject {
    Q_OBJECT
    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }
    void init() { QDir(userData_.filePath("burin")).removeRecursively(); }

    /// Without a file there are no libraries: tools of an older Burin are the user's own, at the same place.
    void ownToolsNeedNoLibrary() {
        QVERIFY(saveTool(copyOf(*loadTool("ball-6"), "own", "Own"), false));
        QCOMPARE(libraryOf("own"), std::string(ownLibrary));
        QCOMPARE(libraryOf("ball-6"), std::string(starterLibrary));
        QVERIFY(names().empty());
        QVERIFY(putTool("own", std::string(ownLibrary)));
        QVERIFY(!QFile::exists(userData_.filePath("burin/tool-libraries.json")));
        const ToolLibraries libraries = *loadToolLibraries();
        QVERIFY(libraries.isIn("own", allTools) && libraries.isIn("ball-6", allTools));
        QVERIFY(!libraries.isIn("own", starterLibrary));
    }

    void toolsMoveFromLibraryToLibrary() {
        QVERIFY(addToolLibrary("Zahnrad & Co") && addToolLibrary("铝材"));
        QCOMPARE(names(), (Names{"Zahnrad & Co", "铝材"}));
        QVERIFY(saveTool(copyOf(*loadTool("ball-6"), "own", "Own"), false));
        QVERIFY(putTool("own", "铝材"));
        QCOMPARE(libraryOf("own"), std::string("铝材"));
        QVERIFY(QFile::exists(userData_.filePath("burin/tools/own.json"))); // the file stays where it was
        QVERIFY(renameToolLibrary("铝材", "Aluminium"));
        QCOMPARE(names(), (Names{"Aluminium", "Zahnrad & Co"}));
        QCOMPARE(libraryOf("own"), std::string("Aluminium"));
        QVERIFY(putTool("own", "Zahnrad & Co"));
        QCOMPARE(libraryOf("own"), std::string("Zahnrad & Co"));
        QVERIFY(removeToolLibrary("Zahnrad & Co"));
        QCOMPARE(libraryOf("own"), std::string(ownLibrary));
        QVERIFY(loadTool("own"));
    }

    void wrongNamesChangeNothing() {
        QVERIFY(addToolLibrary("One"));
        for (const char* name : {"", " ", " x", "x ", "all", "Mine", "STARTER", "two\nlines", "One"})
            QCOMPARE(addToolLibrary(name).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(addToolLibrary(std::string(81, 'x')).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(renameToolLibrary("Two", "Three").error().code, ErrorCode::nameUnknown);
        QCOMPARE(renameToolLibrary("One", "mine").error().code, ErrorCode::argumentInvalid);
        QCOMPARE(removeToolLibrary("Two").error().code, ErrorCode::nameUnknown);
        const Result<void> unknown = putTool("own", "Two");
        QCOMPARE(unknown.error().code, ErrorCode::nameUnknown);
        QCOMPARE(unknown.error().detail, std::string("mine, One"));
        QCOMPARE(putTool("own", "starter").error().code, ErrorCode::argumentInvalid);
        QCOMPARE(names(), Names{"One"});
    }

    void freeNamesArePermitted() {
        ToolLibraries libraries;
        libraries.names = {"fusion", "fusion 2"};
        QCOMPARE(freeLibraryName(libraries, "fusion"), std::string("fusion 3"));
        QCOMPARE(freeLibraryName(libraries, "all"), std::string("all 2"));
        QCOMPARE(freeLibraryName(libraries, "  \n "), std::string("Tools"));
        std::string longName; // each letter has three bytes
        for (int i = 0; i < 60; ++i) longName += "刀";
        QVERIFY(checkLibraryName(freeLibraryName(libraries, longName)));
    }

    /// A file that can't be read is reported and never replaced.
    void aDamagedFileStays() {
        QVERIFY(QDir(userData_.path()).mkpath("burin"));
        QFile file(userData_.filePath("burin/tool-libraries.json"));
        for (const QByteArray text : {R"({"libraries": [{"name": "a"}]})", "{", R"({"libraries": [], "more": 1})",
                                      R"({"libraries": [{"name": "a", "tools": []}, {"name": "a", "tools": []}]})"}) {
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(text) == text.size());
            file.close();
            QCOMPARE(loadToolLibraries().error().code, ErrorCode::resourceInvalid);
            QVERIFY(!addToolLibrary("b"));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), text);
            file.close();
        }
    }
};

BURIN_TEST(TestToolLibraries, QCoreApplication)

} // namespace burin::tst_tool_libraries

#include "tst_tool_libraries.moc"
