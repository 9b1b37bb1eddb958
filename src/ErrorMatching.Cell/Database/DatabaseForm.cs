using System.Data.Common;
using ErrorMatching.Reporting;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>The schema that the migrations leave in a database: everything in it except rows. A planted trigger, rule or view would act in
/// the cell's name.</summary>
internal static class DatabaseForm
{
    private const string Things = "SELECT type, name, sql FROM sqlite_master";
    private const string InSchema = "(SELECT oid FROM pg_namespace WHERE nspname = current_schema())";

    // Before an update, a deletion or a truncation, once per statement. Source: postgresql.org, catalog pg_trigger and
    // src/include/catalog/pg_trigger.h.
    private const string BeforeEachStatement = "58";

    private const string ThingsOnServer = $"""
        SELECT CASE WHEN c.relkind IN ('v', 'm') THEN 'view' ELSE 'table' END, c.relname::text
            FROM pg_class c WHERE c.relnamespace = {InSchema} AND c.relkind IN ('r', 'p', 'f', 'v', 'm')
        UNION ALL SELECT 'column', c.relname || '.' || a.attname || CASE WHEN a.atthasdef THEN ' with a value of its own' ELSE '' END
            FROM pg_attribute a JOIN pg_class c ON c.oid = a.attrelid
            WHERE c.relnamespace = {InSchema} AND c.relkind IN ('r', 'p', 'f') AND a.attnum > 0 AND NOT a.attisdropped
        UNION ALL SELECT 'trigger', c.relname || '.' || t.tgname || ' ' || t.tgtype || ' ' || t.tgenabled::text || ' ' || p.proname
            FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid JOIN pg_proc p ON p.oid = t.tgfoid
            WHERE c.relnamespace = {InSchema} AND NOT t.tgisinternal
        UNION ALL SELECT 'function', p.proname || ' ' || p.prosrc FROM pg_proc p WHERE p.pronamespace = {InSchema}
        UNION ALL SELECT 'rule', c.relname || '.' || r.rulename
            FROM pg_rewrite r JOIN pg_class c ON c.oid = r.ev_class WHERE c.relnamespace = {InSchema} AND c.relkind IN ('r', 'p', 'f')
        UNION ALL SELECT 'policy', c.relname || '.' || p.polname
            FROM pg_policy p JOIN pg_class c ON c.oid = p.polrelid WHERE c.relnamespace = {InSchema}
        UNION ALL SELECT 'index', i.relname::text
            FROM pg_index x JOIN pg_class i ON i.oid = x.indexrelid JOIN pg_class c ON c.oid = x.indrelid
            WHERE c.relnamespace = {InSchema} AND c.relkind IN ('r', 'p')
                AND NOT EXISTS (SELECT 1 FROM pg_constraint k WHERE k.conindid = x.indexrelid AND k.contype IN ('p', 'u', 'x'))
        """;

    private static readonly Lazy<(Dictionary<(string Kind, string Name), string> File,
        HashSet<(string Kind, string Name)> Server)> Expected = new(Expect);

    /// <summary>The first difference from the migrations' schema in a SQLite database; null if there is none.</summary>
    public static AuditFault? FaultOfFile(DbConnection connection, DbTransaction transaction)
    {
        var expected = Expected.Value.File;
        var found = OfFile(connection, transaction);
        return Fault(found.Keys, expected.Keys)
            ?? expected.Where(e => found[e.Key] != e.Value).OrderBy(e => e.Key)
                .Select(e => Of(Recorded.FormOther.With(e.Key.Kind, e.Key.Name))).FirstOrDefault();
    }

    /// <summary>The first difference from the migrations' schema on a PostgreSQL server; null if there is none.</summary>
    public static AuditFault? FaultOnServer(DbConnection connection, DbTransaction transaction) =>
        Fault([.. Rows.Query(connection, ThingsOnServer, r => (r.GetString(0), r.GetString(1)), null, transaction)], Expected.Value.Server);

    private static AuditFault? Fault(IReadOnlyCollection<(string Kind, string Name)> found,
        IReadOnlyCollection<(string Kind, string Name)> expected)
    {
        // An extra object can act, so it is reported first.
        if (found.Except(expected).Order().Select(f => ((string, string)?)f).FirstOrDefault() is var (kind, name)) return Of(
            Recorded.FormUnknown.With(kind, name));
        return expected.Except(found).Order().Select(e => Of(Recorded.FormLacks.With(e.Kind, e.Name))).FirstOrDefault();
    }

    private static AuditFault Of(Statement what) => new(AuditFaultKind.FormDiffers, 0, Recorded.FormDiffers.With(what));

    // Statistics tables belong to the engine.
    private static Dictionary<(string Kind, string Name), string> OfFile(DbConnection connection, DbTransaction? transaction) => Rows
        .Query(connection, Things, r => (Kind: r.GetString(0), Name: r.GetString(1), Sql: r.TextOrNull(2)), null, transaction)
        .Where(t => !t.Name.StartsWith("sqlite_stat", StringComparison.Ordinal))
        .ToDictionary(t => (t.Kind, t.Name), t =>
            string.Join(' ', (t.Sql ?? "").Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)));

    private static (Dictionary<(string Kind, string Name), string> File, HashSet<(string Kind, string Name)> Server) Expect()
    {
        SQLitePCL.Batteries_V2.Init();
        using var made = new SqliteConnection("Data Source=:memory:;Pooling=False");
        made.Open();
        foreach (var sql in Migrations.Statements(SqliteDatabase.WordOf)) made.Execute(sql);
        var file = OfFile(made, null);
        var tables = file.Keys.Where(k => k.Kind == "table" && !k.Name.StartsWith("sqlite_", StringComparison.Ordinal)).ToArray();
        var columns = tables.SelectMany(t =>
            Rows.Query(
                made, "SELECT name FROM pragma_table_info(@Name)", r => ("column", $"{t.Name}.{r.GetString(0)}"), [("Name", t.Name)]));
        var indexes = file.Where(f => f.Key.Kind == "index" && f.Value.Length > 0).Select(f => f.Key);
        var triggers = Migrations.Arguments("append_only").SelectMany(table => new[]
        {
            ("function", $"{PostgresDatabase.Keeper(table)} {PostgresDatabase.KeeperBody(table)}"),
            ("trigger", $"{table}.{table}_change {BeforeEachStatement} O {PostgresDatabase.Keeper(table)}"),
        });
        return (file, [.. tables, .. columns, .. indexes, .. triggers]);
    }
}
