// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QApplication>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

#include <vector>

namespace burin::tst_window_languages {

using namespace burin::testing;

namespace {

const QRegularExpression& word() {
    static const QRegularExpression one(QStringLiteral("\\p{L}+(?:['’]\\p{L}+)?"));
    return one;
}

QSet<QString> wordsOf(QString text) {
    static const QRegularExpression mnemonic(QStringLiteral("&(?=\\p{L})")), place(QStringLiteral("%(L?[0-9]+|n)"));
    text.remove(mnemonic).remove(place);
    QSet<QString> words;
    for (auto found = word().globalMatch(text); found.hasNext();) words.insert(found.next().captured().toLower());
    return words;
}

/// Words of the English sources that no translation of a language contains.
QSet<QString> onlyEnglish(const QString& language) {
    QSet<QString> english, translated;
    QFile file(QStringLiteral(BURIN_SOURCE_DIRECTORY "/translations/burin_%1.ts").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QXmlStreamReader reader(&file);
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement) continue;
        if (reader.name() == QLatin1String("source"))
            english += wordsOf(reader.readElementText());
        else if (reader.name() == QLatin1String("translation") || reader.name() == QLatin1String("numerusform"))
            translated += wordsOf(reader.readElementText(QXmlStreamReader::IncludeChildElements));
    }
    english -= translated;
    // Common words, to find texts that were never marked for translation as well.
    for (const char* common : {"the", "of", "and", "with", "is", "are", "not", "from", "were", "states", "taken"})
        english.insert(QLatin1String(common));
    return english;
}

/// Sources of values are shown in the words of their file, which may be a user's own.
void collectSources(const QJsonValue& value, QStringList& sources) {
    for (const QJsonValue& each : value.toArray()) collectSources(each, sources);
    const QJsonObject object = value.toObject();
    for (auto member = object.begin(); member != object.end(); ++member) {
        if (member.key() == QLatin1String("source") && member->isString()) sources << member->toString();
        collectSources(*member, sources);
    }
}

QStringList sourcesOfFigures() {
    QStringList sources;
    QDirIterator files(QStringLiteral(BURIN_SOURCE_DIRECTORY "/resources"), {QStringLiteral("*.json")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly)) return {};
        const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
        collectSources(document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object()), sources);
    }
    return sources;
}

constexpr QSize usualSize(1280, 800);

} // namespace

/// The window of a user whose language is not English.
class TestWindowLanguages : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void noTextOfAJobIsEnglish_data();
    void noTextOfAJobIsEnglish();
    void numbersHaveTheDecimalComma();

private:
    /// Texts that are visible now and contain an English word, each with the widget that shows it.
    QStringList englishTexts(WindowDriver& driver) const;

    QSet<QString> english_;
    QStringList sources_;
};

void TestWindowLanguages::initTestCase() {
    sources_ = sourcesOfFigures();
    QVERIFY(sources_.size() > 30);
}

void TestWindowLanguages::noTextOfAJobIsEnglish_data() {
    QTest::addColumn<QString>("language");
    std::vector<const char*> languages{"de"}; // which texts are marked for translation depends on no language
    if (longRun()) languages.insert(languages.begin(), "zh_CN");
    for (const char* language : languages) // the last one that is installed remains
        QTest::newRow(language) << QString::fromLatin1(language);
}

QStringList TestWindowLanguages::englishTexts(WindowDriver& driver) const {
    static const QRegularExpression hash(QStringLiteral("\\b[0-9a-f]{16}\\b"));
    QStringList found;
    for (const VisibleText& shown : visibleTexts(driver.window())) {
        QString own = shown.text;
        own.remove(driver.folder().path());
        own.remove(hash); // its hexadecimal digits can spell a word
        for (const QString& source : sources_) own.remove(source);
        const QSet<QString> words = wordsOf(own) & english_;
        if (!words.isEmpty()) found << shown.where + QStringLiteral(": ") + shown.text;
    }
    return found;
}

void TestWindowLanguages::noTextOfAJobIsEnglish() {
    QFETCH(QString, language);
    english_ = onlyEnglish(language);
    QVERIFY(english_.size() > 500);
    english_.remove(QStringLiteral("block")); // the name of the test's part
    QVERIFY(Messages::install(QLocale(language)));
    WindowDriver driver(usualSize, QLocale(language));
    Workbench& workbench = driver.window().workbench();
    QStringList english = englishTexts(driver);
    const auto look = [&](JobStep step, const char* name) {
        if (!driver.step(step)) return;
        driver.shoot(language + QLatin1Char('-') + QLatin1String(name));
        english += englishTexts(driver);
    };
    drop(driver.window(), writeBlock(driver, false)); // an open mesh, so that its notes and findings are shown as well
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }));
    QVERIFY(driver.settle());
    look(JobStep::part, "part");
    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}));
    QVERIFY(driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    const std::pair<JobStep, const char*> steps[] = {{JobStep::part, "part-closed"},    {JobStep::stock, "stock"},
                                                     {JobStep::material, "material"},   {JobStep::tool, "tool"},
                                                     {JobStep::allowance, "allowance"}, {JobStep::mill, "mill"},
                                                     {JobStep::path, "path"},           {JobStep::program, "program"}};
    for (const auto& [step, name] : steps) look(step, name);
    english.removeDuplicates();
    QVERIFY2(english.isEmpty(), qPrintable(QLatin1Char('\n') + english.join(QLatin1Char('\n'))));
}

/// In every field. A typed dot is accepted as well, and texts that a machine reads have dots.
void TestWindowLanguages::numbersHaveTheDecimalComma() {
    WindowDriver driver(usualSize, QLocale(QStringLiteral("de_DE")));
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver));
    QVERIFY(driver.step(JobStep::mill));
    auto* depth = driver.visible<QDoubleSpinBox>("depthOfCutField");
    for (const auto& [typed, shown, value] :
         {std::tuple{"0.25", "0,250", 0.25}, {"1,75", "1,750", 1.75}, {".5", "0,500", 0.5}}) {
        QVERIFY(driver.enter("depthOfCutField", QLatin1String(typed)));
        QCOMPARE(depth->cleanText(), QLatin1String(shown));
        QCOMPARE(depth->value(), value);
    }
    QVERIFY(driver.enter("depthOfCutField", QStringLiteral("1.234,5"))); // ambiguous: nothing is entered
    QCOMPARE(depth->value(), 0.5);
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}));
    QVERIFY(driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    QVERIFY(driver.step(JobStep::program));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    QString program = driver.visible<QPlainTextEdit>("programText")->toPlainText();
    program.remove(QRegularExpression(QStringLiteral("\\([^)]*\\)"))); // comments
    QVERIFY(program.contains(QRegularExpression(QStringLiteral("X-?[0-9]+\\.[0-9]"))));
    QVERIFY2(!program.contains(QLatin1Char(',')), qPrintable(program));
    qsizetype fields = 0;
    for (int step = 0; step < StepBar::steps; ++step) {
        if (!driver.step(static_cast<JobStep>(step))) continue;
        for (const auto* field : driver.window().findChildren<QDoubleSpinBox*>()) {
            if (!field->isVisible()) continue;
            ++fields;
            QVERIFY2(!field->text().contains(QLatin1Char('.')), qPrintable(field->objectName() + field->text()));
        }
    }
    QVERIFY(fields > 10);
}

BURIN_TEST(TestWindowLanguages, QApplication)

} // namespace burin::tst_window_languages

#include "tst_window_languages.moc"
