namespace ErrorMatching.Measurement;

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
