using System.Text.RegularExpressions;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The compiled patterns of a job.</summary>
internal sealed class JobPatterns
{
    private readonly Regex? _fileName;
    private readonly (string Name, Regex Pattern)? _headerField;
    private readonly (string Name, Regex Pattern)? _column;

    public JobPatterns(CellJobSettings job)
    {
        Job = job;
        _fileName = job.Recognize.FileName is { } pattern ? RecognitionReader.Expression(pattern) : null;
        _headerField = Named(job.Recognize.HeaderField);
        _column = Named(job.Recognize.Column);
    }

    public CellJobSettings Job { get; }

    /// <summary>What the patterns capture; null if one of them does not match. The content is read only if the name matches.</summary>
    /// <exception cref="InputException">The content is needed and cannot be read.</exception>
    public FoundWords? Match(LookInside file)
    {
        var found = new FoundWords();
        return (_fileName is null || Matches(_fileName, [file.Name], found))
            && (_headerField is not { } field || Matches(field.Pattern, file.HeaderField(field.Name), found))
            && (_column is not { } column || Matches(column.Pattern, file.Column(column.Name), found)) ? found : null;
    }

    /// <summary>What the patterns match.</summary>
    public Statement Like => new[]
    {
        _fileName is null ? null : Recorded.LikeName.With(_fileName),
        _headerField is { } header ? Recorded.LikeField.With(header.Name, header.Pattern) : null,
        _column is { } column ? Recorded.LikeColumn.With(column.Name, column.Pattern) : null,
    }.OfType<Statement>().DefaultIfEmpty("").Aggregate((first, second) => Recorded.LikeAll.With(first, second));

    private static (string, Regex)? Named((string Name, string Pattern)? rule) =>
        rule is { } r ? (r.Name, RecognitionReader.Expression(r.Pattern)) : null;

    // A column repeats the same value in its rows; each distinct value is matched once.
    private static bool Matches(Regex pattern, IReadOnlyList<string> texts, FoundWords found)
    {
        string? last = null;
        foreach (var text in texts.Where(t => t != last))
        {
            if (pattern.Match(text) is not { Success: true } match)
            {
                return false;
            }

            found.Add(match);
            last = text;
        }

        return texts.Count > 0;
    }
}
