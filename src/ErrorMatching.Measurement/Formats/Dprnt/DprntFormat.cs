namespace ErrorMatching.Measurement;

/// <summary>What a macro prints by <c>DPRNT</c> on Fanuc, Haas and related controls, between the percent signs of <c>POPEN</c> and
/// <c>PCLOS</c>: a line for each point, with letters before its numbers (<c>P1 X  12.0000 Y -10.0377</c>) or without
/// (<c>1,  12.0000, -10.0377</c>).</summary>
internal sealed class DprntFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head)
    {
        if (NoMeasurement.IsProgram(head))
        {
            return false;
        }

        var first = LogLines.OfHead(head).FirstOrDefault(l => l != LogLines.Bracket);
        var words = first is null ? null : LogWord.Read(first);
        return words is not null && DprntLayout.Of(words) is { } layout && (layout.HasLetters || IsBracketed(source, head));
    }

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new DprntReader(source, format).Read();

    // Numbers alone could be any table. The percent sign before or behind them is the control's.
    private static bool IsBracketed(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).First() == LogLines.Bracket
        || source.Bytes.Span.TrimEnd(" \t\r\n\u0011\u0012\u0013\u0014"u8) is [.., (byte)'\n' or (byte)'\r', (byte)'%'];
}

/// <summary>Reads the lines that a macro printed. All of them have the layout of the first one.</summary>
internal sealed class DprntReader(MeasurementBytes source, MeasurementFormat format)
{
    private readonly LogPoints _points = new(source.File, format.Unit);
    private DprntLayout? _layout;
    private List<LogWord>? _before;
    private List<LogWord>? _last;
    private TextLine _lastLine;
    private bool _isOpened;

    public MeasuredContent Read()
    {
        TextLine? end = null;
        foreach (var line in LogLines.Of(source, format))
        {
            if (line.Text == LogLines.Bracket)
            {
                (_isOpened, end) = (true, _layout is null ? null : line);
            }
            else if (end is { } closed)
            {
                throw line.Fail(
                    MeasurementError.SeveralMeasurements,
                    $"{MeasurementRefusal.Quote(line.Text)} behind the % of line {closed.Number}",
                    "one measurement in a file: POPEN, the points of one piece, PCLOS");
            }
            else
            {
                Add(line);
            }
        }

        ThrowIfCut(end is not null);
        return _points.Content(_layout!.Label < 0);
    }

    private void Add(TextLine line)
    {
        var words = LogWord.Read(line.Text);
        var layout = words is null ? null : DprntLayout.Of(words);
        _layout ??= layout;
        if (layout is null || layout != _layout || (_last is not null && !HasLettersOf(_last, words!)))
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(line.Text),
                "the numbers of the first line, in its order and with its letters: the line is cut off, or is none of a point",
                words is null ? 1 : words.Count);
        }

        (_before, _last, _lastLine) = (_last, words, line);
        _points.Add(
            layout.Label < 0 ? null : LabelOf(words![layout.Label]),
            CellOf(layout.X, "X"),
            CellOf(layout.Y, "Y"),
            layout.Z < 0 ? null : CellOf(layout.Z, "Z"));

        Cell LabelOf(LogWord word) => new(word.Letters + word.Number, new(line.File, line.Number, word.Position), "of the point", false);

        Cell CellOf(int at, string axis) => new(words![at].Number, new(line.File, line.Number, at + 1), axis, false);
    }

    // A macro prints a number with the same decimals in each line, and usually all coordinates alike.
    private void ThrowIfCut(bool isClosed)
    {
        if (isClosed || _last is not { } last || !LogLines.EndsWithinLine(source))
        {
            return;
        }

        if (_isOpened || last[^1].Decimals != (_before ?? last[..^1])[^1].Decimals)
        {
            throw _lastLine.Fail(
                MeasurementError.ShortRow,
                $"the last line ends with {MeasurementRefusal.Quote(last[^1].Number)}",
                "the end of the line, and % behind it: the file is cut off, copy it again",
                last.Count);
        }
    }

    private static bool HasLettersOf(List<LogWord> first, List<LogWord> words)
    {
        for (var i = 0; i < words.Count; i++)
        {
            if (words[i].Letters != first[i].Letters)
            {
                return false;
            }
        }

        return true;
    }
}

/// <summary>Which number of a line is which: positions from 0, -1 where there is none.</summary>
/// <param name="Label">The number that names the point.</param>
/// <param name="X">The first coordinate.</param>
/// <param name="Y">The second coordinate.</param>
/// <param name="Z">The third coordinate.</param>
/// <param name="HasLetters">True if the coordinates have their letters before them.</param>
internal sealed record DprntLayout(int Label, int X, int Y, int Z, bool HasLetters)
{
    /// <summary>The layout that a line shows; null if it shows none.</summary>
    public static DprntLayout? Of(List<LogWord> words) =>
        words.Exists(w => w.Letters.Length > 0) ? OfLetters(words) : OfPositions(words);

    // With letters: X and Y, Z if there is one, and one word before them for the point.
    private static DprntLayout? OfLetters(List<LogWord> words)
    {
        var (x, y, z) = (Find("X"), Find("Y"), Find("Z"));
        var label = words[0].Letters is "X" or "Y" or "Z" ? -1 : 0;
        var count = (label < 0 ? 0 : 1) + (z < 0 ? 2 : 3);
        return x >= 0 && y >= 0 && words.Count == count && words.DistinctBy(w => w.Letters).Count() == count
            && (label < 0 || IsWhole(words[0]))
            ? new(label, x, y, z, true)
            : null;

        int Find(string letter) => words.FindIndex(w => w.Letters == letter);
    }

    // Without letters: coordinates have a decimal point, and the number of a point has none.
    private static DprntLayout? OfPositions(List<LogWord> words)
    {
        var label = IsWhole(words[0]) ? 1 : 0;
        return words.Skip(label).All(w => w.Decimals >= 0) && words.Count - label is 2 or 3
            ? new(label - 1, label, label + 1, words.Count - label == 3 ? label + 2 : -1, false)
            : null;
    }

    private static bool IsWhole(LogWord word) => word.Decimals < 0 && char.IsAsciiDigit(word.Number[0]);
}
