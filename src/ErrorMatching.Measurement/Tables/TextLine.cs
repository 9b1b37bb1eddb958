using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A line of a file that is no table.</summary>
internal readonly record struct TextLine(string File, int Number, string Text)
{
    /// <summary>The lines of a text, with all three kinds of line breaks.</summary>
    public static IEnumerable<TextLine> Of(string text, string file)
    {
        var number = 1;
        for (var start = 0; start < text.Length; number++)
        {
            var end = LineBreaks.NextLine(text, start);
            yield return new(file, number, text[start..end].TrimEnd('\r', '\n'));
            start = end;
        }
    }

    /// <summary>A cell of the line.</summary>
    /// <param name="text">Its text.</param>
    /// <param name="column">Its position, from 1.</param>
    /// <param name="name">What it says, for messages.</param>
    public Cell Cell(string text, int column, string name)
    {
        var trimmed = text.Trim();

        // In these formats a comma never separates thousands.
        return new(trimmed, new(File, Number, column), name, trimmed.Contains(',') && !trimmed.Contains('.'));
    }

    public InputException Fail(string code, string found, string expected, int column = 1) =>
        new Place(File, Number, column).Fail(code, found, expected);
}
