using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>One file of a dialect, which may continue another.</summary>
/// <param name="File">Name for messages; for a shop's file, its path.</param>
/// <param name="Root">Its content.</param>
/// <param name="Sha256">Hash of a shop's file; null for a built-in one.</param>
internal sealed record DialectDocument(string File, JsonItem Root, string? Sha256)
{
    public static readonly (string Key, string Subjects, DialectTopic Topic)[] Lists =
    [
        ("codes", "codes", DialectTopic.Code),
        ("letters", "letters", DialectTopic.Letter),
        ("functions", "functions", DialectTopic.Function),
        ("flow", "words", DialectTopic.Flow),
        ("machinePrograms", "programs", DialectTopic.MachineProgram),
        ("offsetTables", "tables", DialectTopic.OffsetTable),
    ];

    public string Name => Root["name"].Text;

    public JsonItem? Like => Root.Find("like");

    public IReadOnlyList<JsonItem> List(string key) => Root.Find(key)?.Items ?? [];
}
