using ErrorMatching.Reporting;

namespace ErrorMatching.Cell.Tests;

/// <summary>A statement without the words of its sentence, which <c>RecordedSentencesTests</c> pins: code(value, value); several in
/// a row with a semicolon between them. Numbers and times are as the sentence shows them.</summary>
internal static class Stated
{
    public static string As(Statement? statement) => statement is null ? "" : string.Join("; ", statement.Parts.Select(One));

    private static string One(Statement statement)
    {
        if (statement.Code is not { } code) return statement.Words!;
        var kinds = statement.Form?.Kinds;
        var values = statement.Values.Select(
            (v, i) => (v.Words is { } words && kinds?[i] is { Length: > 0 } kind ? SentenceForm.Formatted(kind, words) : null) ?? As(v));
        return statement.Values.Count == 0 ? code : $"{code}({string.Join(", ", values)})";
    }
}
