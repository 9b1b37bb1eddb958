using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>One subject of an entry of a dialect's file.</summary>
/// <param name="Entry">The entry.</param>
/// <param name="Subject">Its subject.</param>
internal sealed record DialectStatement(JsonItem Entry, SubjectRange Subject);
