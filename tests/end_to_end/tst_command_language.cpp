// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace burin::tst_command_language {

namespace {

struct Translation {
    QString source, target;
};

/// All texts of a language's table, in order.
QList<Translation> translations(const QString& language) {
    QList<Translation> list;
    QFile file(QStringLiteral(BURIN_SOURCE_DIRECTORY "/translations/burin_%1.ts").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return list;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("source")) list.append({xml.readElementText(), {}});
        if (xml.name() == QLatin1String("translation"))
            list.last().target = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    }
    return list;
}

/// Texts that are the same in a language, such as "JSON".
QStringList equalTexts(const QList<Translation>& table) {
    QStringList equal;
    for (const Translation& text : table)
        if (text.source == text.target) equal.append(text.source);
    return equal;
}

/// The descriptions of options, arguments and commands in the right column of --help.
QStringList descriptionsIn(const QString& help) {
    constexpr int column = 30;
    QStringList descriptions;
    const QStringList lines = help.split('\n');
    const QRegularExpression range("\\[[^\\]]*$"); // long names that cross the column in the middle of a range
    for (const QString& line : lines)
        if (line.startsWith("  ") && line.size() > column && line.at(column - 1) == ' ' && line.at(column) != ' ' &&
            !range.match(line.left(column)).hasMatch())
            if (const QString text = line.mid(column).trimmed(); !text.startsWith("--")) // options that exclude it
                descriptions.append(text);
    return descriptions;
}

/// The names of the commands that --help lists.
QStringList commandsIn(const QString& help) {
    QStringList names;
    const qsizetype start = help.indexOf("\nSubcommands:\n");
    if (start < 0) return names;
    auto match = QRegularExpression("^  ([a-z]+) ", QRegularExpression::MultilineOption).globalMatch(help.mid(start));
    while (match.hasNext()) names.append(match.next().captured(1));
    return names;
}

QStringList optionsIn(const QString& help) {
    QStringList names;
    auto match = QRegularExpression("^  (-\\S+)", QRegularExpression::MultilineOption).globalMatch(help);
    while (match.hasNext()) names.append(match.next().captured(1));
    return names;
}

/// `object` without the sentences that are in the user's language by design (README.md).
QJsonObject withoutSentences(QJsonObject object) {
    for (const char* key : {"warnings", "part_warnings", "error"}) object.remove(QLatin1String(key));
    return object;
}

} // namespace

/// The texts of the command line are in the user's language; what programs read from it is the same in all languages.
class CommandLanguageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase_data(); // every language
    void initTestCase();
    void init();
    void helpIsInTheUsersLanguage_data();
    void helpIsInTheUsersLanguage();
    void answersAreInTheUsersLanguage_data();
    void answersAreInTheUsersLanguage();
    void jsonIsTheSameInEveryLanguage_data();
    void jsonIsTheSameInEveryLanguage();
    void faultsAreInTheUsersLanguage_data();
    void faultsAreInTheUsersLanguage();

private:
    QStringList inFolder(QStringList arguments) const { return arguments.replaceInStrings("@", folder_.path()); }
    void write(const char* name, const QByteArray& content) const;
    QString locale_;
    QTemporaryDir folder_;
    QList<Translation> table_;
};

void CommandLanguageTest::write(const char* name, const QByteArray& content) const {
    QFile file(folder_.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
}

void CommandLanguageTest::initTestCase_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("German") << QString("de_DE"); // which texts are marked for translation depends on no language
    if (testing::longRun()) QTest::newRow("Chinese") << QString("zh_CN");
}

void CommandLanguageTest::init() {
    QFETCH_GLOBAL(QString, language);
    locale_ = language + ".UTF-8";
    table_ = translations(language == "de_DE" ? QString("de") : language);
    QVERIFY(table_.size() > 1000);
}

void CommandLanguageTest::initTestCase() {
    QVERIFY(qputenv("XDG_DATA_HOME", folder_.filePath("data").toUtf8()));
    QVERIFY(QFile::copy(BURIN_FIXTURES "/models/cube.brep", folder_.filePath("cube.brep")));
    const QString project = folder_.filePath("cube.burin");
    QCOMPARE(runBurin({"embed", folder_.filePath("cube.brep"), "-o", project, "--voxel", "1", "--keep-out",
                       "40,40,0,50,50,10"})
                 .status,
             0);
    QCOMPARE(runBurin({"mill", project, "--seconds", "20"}).status, 0);
    QCOMPARE(runBurin({"path", project, "new"}).status, 0);
    // It gouges, calls a tool that does not exist, and ends without M2.
    write("wrong.ngc", "G21 G90 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 X0 Y0 Z30\nG1 Z-30 F100\nG1 X5 F100\nT77 M6\nG1 X0\n");
    write("gouge.ngc", "G21 G90 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 X0 Y0 Z30\nG1 Z-30 F100\nG1 X5 F100\nM2\n");
    write("word.ngc", "G21 G90\nG1 X10 F100\nBANANA\nM2\n");
    write("trace.csv", "time_s,x_mm\n0,zero\n");
    const QByteArray machine = runBurin({"machines", "show", "haas-mill"}).output;
    QVERIFY(machine.contains("\"rapid_feed_mm_per_min\": "));
    write("machine.json", QByteArray(machine).replace("\"rapid_feed_mm_per_min\": ", "\"rapid_feed_mm_per_min\": -"));
}

void CommandLanguageTest::helpIsInTheUsersLanguage_data() {
    QTest::addColumn<QStringList>("command");
    QTest::newRow("all") << QStringList();
    const QString top = QString::fromUtf8(runBurin({"--help"}).output);
    for (const QString& command : commandsIn(top)) {
        QTest::newRow(qPrintable(command)) << QStringList{command};
        const QString help = QString::fromUtf8(runBurin({command, "--help"}).output);
        QStringList start{command};
        if (command == "path") start.append("PROJECT");
        for (const QString& part : commandsIn(help))
            QTest::newRow(qPrintable(command + " " + part)) << start + QStringList{part};
    }
}

void CommandLanguageTest::helpIsInTheUsersLanguage() {
    QFETCH(QStringList, command);
    const ProgramRun english = runBurin(command + QStringList{"--help"});
    const ProgramRun translated = runBurin(command + QStringList{"--help"}, locale_);
    QCOMPARE(english.status, 0);
    QCOMPARE(translated.status, 0);
    QVERIFY(translated.messages.isEmpty());
    const QString here = QString::fromUtf8(translated.output), there = QString::fromUtf8(english.output);
    QCOMPARE(optionsIn(here), optionsIn(there));
    const QStringList descriptions = descriptionsIn(there), equal = equalTexts(table_);
    QVERIFY(descriptions.size() >= optionsIn(there).size());
    for (const QString& text : descriptions)
        QVERIFY2(equal.contains(text) || !here.contains(text), qPrintable("not translated: " + text));
    QVERIFY2(!here.contains(there.section('\n', 0, 0)), "what the command does");
    for (const char* word : {"Usage", "OPTIONS", "Options:", "Positionals", "Subcommands", "REQUIRED", " FLOAT", " INT",
                             " UINT", "Needs:", "Excludes:"})
        QVERIFY2(!here.contains(word), word);
}

void CommandLanguageTest::answersAreInTheUsersLanguage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const QStringList& arguments, int status = 0) {
        QTest::newRow(name) << arguments << status;
    };
    row("import", {"import", "@/cube.brep"});
    row("import with notes", {"import", BURIN_FIXTURES "/models/of-others/s14b-20-micrometre.stl"});
    row("embed", {"embed", "@/cube.brep", "-o", "@/new.burin", "--voxel", "1"});
    row("embed refuses",
        {"embed", BURIN_FIXTURES "/models/of-others/s14b-20-micrometre.stl", "-o", "@/none.burin", "--voxel", "0.5"},
        1);
    row("setup", {"setup", "@/cube.burin"});
    row("info", {"info", "@/cube.burin"});
    row("path list", {"path", "@/cube.burin", "list"});
    row("path show", {"path", "@/cube.burin", "show", "1"});
    row("take", {"path", "@/cube.burin", "take", "1", "-o", "@/take.csv"});
    row("take score", {"take", "score", "@/cube.burin", "1"});
    row("take deviation", {"take", "deviation", "@/cube.burin", "1"});
    row("post", {"post", "@/cube.burin", "-o", "@/x.ngc", "--machine", "grbl-router"});
    row("verify", {"verify", "@/wrong.ngc", "--project", "@/cube.burin"}, 1);
    row("verify one tool", {"verify", "@/gouge.ngc", "--project", "@/cube.burin", "--tool", "ball-6"}, 1);
    row("machines", {"machines", "list"});
    row("fixtures", {"fixtures"});
    row("picture", {"picture", "@/cube.burin", "-o", "@/x.png"});
    row("bench", {"bench"});
}

/// Each text of the translation table that occurs in the English answer must not occur in the translated one, and no
/// line with a word in it may be the same in both, except ids, files and edits in JSON.
void CommandLanguageTest::answersAreInTheUsersLanguage() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    const ProgramRun english = runBurin(inFolder(arguments)), translated = runBurin(inFolder(arguments), locale_);
    QVERIFY2(english.status == status && translated.status == status, translated.messages.constData());
    const QStringList there = QString::fromUtf8(english.output + english.messages).split('\n'),
                      here = QString::fromUtf8(translated.output + translated.messages).split('\n');
    QCOMPARE(here.size(), there.size());
    const QRegularExpression exempt("^ *[0-9]+  \\{|^/\\S+$|^[^A-Za-z]*$");
    for (const QString& line : there)
        QVERIFY2(exempt.match(line).hasMatch() || !here.contains(line), qPrintable("not translated: " + line));
    static const QRegularExpression place("%[1-9]"), word("[A-Za-z]{4}");
    for (const Translation& text : table_)
        for (const QString& piece : text.source.split(place)) {
            const QString fragment = piece.trimmed();
            if (fragment.size() < 12 || !fragment.contains(word) || text.target.contains(fragment)) continue;
            const auto shows = [&](const QStringList& lines) { return lines.join('\n').contains(fragment); };
            QVERIFY2(!shows(there) || !shows(here), qPrintable("not translated: " + fragment));
        }
}

void CommandLanguageTest::jsonIsTheSameInEveryLanguage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("import") << QStringList{"import", "@/cube.brep"};
    QTest::newRow("setup") << QStringList{"setup", "@/cube.burin"};
    QTest::newRow("info") << QStringList{"info", "@/cube.burin"};
    QTest::newRow("path") << QStringList{"path", "@/cube.burin", "show", "1"};
    QTest::newRow("verify") << QStringList{"verify", "@/wrong.ngc", "--project", "@/cube.burin"};
    QTest::newRow("machines") << QStringList{"machines", "list"};
    QTest::newRow("fault") << QStringList{"info", "@/none.burin"};
}

void CommandLanguageTest::jsonIsTheSameInEveryLanguage() {
    QFETCH(QStringList, arguments);
    const QStringList all = inFolder(arguments) + QStringList{"--json"};
    const QJsonObject english = runBurin(all).json(), translated = runBurin(all, locale_).json();
    QVERIFY(!english.isEmpty());
    QCOMPARE(translated.keys(), english.keys());
    QCOMPARE(QJsonDocument(withoutSentences(translated)).toJson(), QJsonDocument(withoutSentences(english)).toJson());
}

void CommandLanguageTest::faultsAreInTheUsersLanguage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("english"); // what the English sentence has and the translated one must not have
    const auto row = [](const char* name, const QStringList& arguments, const char* words) {
        QTest::newRow(name) << arguments << QString(words);
    };
    row("unknown command", {"engrave"}, "choose one of");
    row("no command and no display", {}, "no display");
    row("missing argument", {"mill"}, "is missing");
    row("out of range", {"mill", "@/cube.burin", "--rate", "3"}, "1000 to 4000");
    row("no number", {"embed", "@/cube.brep", "-o", "@/y.burin", "--voxel", "small"}, "a number");
    row("blank reason", {"post", "@/cube.burin", "-o", "@/x.ngc", "--override", " "}, "state a reason");
    row("axis", {"mill", "@/cube.burin", "--axis", "sideways"}, "not all zero");
    row("section", {"picture", "@/cube.burin", "-o", "@/x.png", "--section", "X=500"}, "a position between");
    row("value of a machine", {"machines", "add", "@/machine.json"}, "has to be a number");
    row("shipped machine", {"machines", "remove", "haas-mill"}, "can't be deleted");
    row("line of a program", {"verify", "@/word.ngc", "--project", "@/cube.burin"}, "line 3, column");
    row("line of a trace", {"mill", "@/cube.burin", "--stylus", "trace:@/trace.csv"}, "(line 1)");
}

void CommandLanguageTest::faultsAreInTheUsersLanguage() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, english);
    const ProgramRun there = runBurin(inFolder(arguments)), here = runBurin(inFolder(arguments), locale_);
    QCOMPARE(here.status, there.status);
    QVERIFY(here.status > 0);
    QVERIFY2(there.messages.contains(english.toUtf8()), there.messages.constData());
    QVERIFY2(!here.messages.contains(english.toUtf8()), here.messages.constData());
    QCOMPARE(here.messages.trimmed().count('\n'), 0);
    const QString sentence = QString::fromUtf8(here.messages).trimmed();
    QVERIFY2(sentence.endsWith('.') || sentence.endsWith(QChar(0x3002)), qPrintable(sentence));
}

BURIN_TEST(CommandLanguageTest, QCoreApplication)

} // namespace burin::tst_command_language

#include "tst_command_language.moc"
