// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/database.h"
#include "core/document/schema.h"
#include "tests/test_program.h"

#include <QtTest>
#include <array>

namespace burin::tst_schema {

namespace {

Result<void> addColour(Database& file) {
    return file.execute("ALTER TABLE path ADD COLUMN colour INTEGER DEFAULT 7");
}
Result<void> doubleColour(Database& file) {
    return file.execute("UPDATE path SET colour = 2 * colour");
}
Result<void> failHalfWay(Database& file) {
    if (Result<void> done = file.execute("UPDATE path SET name = 'spoiled'"); !done) return done;
    return Error{ErrorCode::fileDamaged, file.subject(), "path", {}};
}

Database projectWithPath() {
    Database file = *Database::inMemory("p.burin");
    if (!createSchema(file) || !file.execute("INSERT INTO path(name) VALUES('roughing')")) qFatal("no schema");
    return file;
}

} // namespace

class TestSchema : public QObject {
    Q_OBJECT
private slots:
    void aNewProjectIsOfTheCurrentVersion() {
        Database file = projectWithPath();
        QCOMPARE(*file.integer("PRAGMA application_id"), std::int64_t{projectApplicationId});
        QCOMPARE(*file.integer("PRAGMA user_version"), std::int64_t{projectVersion});
        QVERIFY(upgrade(file));
    }
    void everyStepFollowsTheOneBefore() {
        for (std::size_t i = 0; i < projectMigrations.size(); ++i)
            QCOMPARE(projectMigrations[i].from, static_cast<int>(i) + 1);
    }
    void missingStepsAreTakenInOrder() {
        Database file = projectWithPath();
        QVERIFY(file.execute("PRAGMA user_version = 1"));
        const std::array steps{Migration{1, {}, addColour}, Migration{2, {}, doubleColour}};
        QVERIFY(upgrade(file, steps));
        QCOMPARE(*file.integer("SELECT colour FROM path"), std::int64_t{14});
        QCOMPARE(*file.integer("PRAGMA user_version"), std::int64_t{3});
        QVERIFY(upgrade(file, steps)); // nothing is left to do
        QCOMPARE(*file.integer("SELECT colour FROM path"), std::int64_t{14});
    }
    /// Whatever a manipulated file makes a statement do, the statement ends.
    void aStatementWithoutEndIsEnded() {
        Database file = projectWithPath();
        const Result<std::int64_t> counted = file.integer(
            "WITH RECURSIVE counted(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM counted) SELECT count(*) FROM counted");
        QVERIFY(!counted);
        QVERIFY(counted.error().code == ErrorCode::fileDamaged);
        QCOMPARE(*file.integer("SELECT count(*) FROM path"), std::int64_t{1}); // the next one has a limit of its own
    }
    void aStepThatFailsTakesAllBack() {
        Database file = projectWithPath();
        QVERIFY(file.execute("PRAGMA user_version = 1"));
        const std::array steps{Migration{1, {}, addColour}, Migration{2, {}, failHalfWay}};
        const Result<void> done = upgrade(file, steps);
        QVERIFY(!done);
        QCOMPARE(done.error().place, std::string("path"));
        QCOMPARE(*file.integer("PRAGMA user_version"), std::int64_t{1});
        QCOMPARE(*file.integer("SELECT count(*) FROM path WHERE name = 'roughing'"), std::int64_t{1});
        QVERIFY(!file.integer("SELECT colour FROM path"));
    }
    void aTransactionThatIsLeftIsTakenBack() {
        Database file = projectWithPath();
        {
            Result<Transaction> whole = Transaction::begin(file, Transaction::Kind::write);
            QVERIFY(whole && file.execute("DELETE FROM path"));
        }
        QCOMPARE(*file.integer("SELECT count(*) FROM path"), std::int64_t{1});
    }
};

BURIN_TEST(TestSchema, NoApplication)

} // namespace burin::tst_schema

#include "tst_schema.moc"
