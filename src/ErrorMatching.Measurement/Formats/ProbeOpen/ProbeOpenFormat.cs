namespace ErrorMatching.Measurement;

/// <summary>What LinuxCNC writes between <c>(PROBEOPEN file)</c> and <c>(PROBECLOSE)</c>: nine numbers for each probing move, X, Y, Z, A,
/// B, C, U, V and W, separated by blanks, in the current work coordinates. No header and no labels.</summary>
internal sealed class ProbeOpenFormat : SelfDescribingFormat
{
    private const int Axes = 9;

    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) => Numbers(FirstLine(head).ToString()).Length == Axes
        && Numbers(FirstLine(head).ToString()).All(n => DecimalNumber.TryRead(n, decimalComma: false) is not null);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var points = new LogPoints(source.File, format.Unit);
        TextLine last = default;
        foreach (var line in LogLines.Of(source, format))
        {
            var numbers = Numbers(line.Text);
            if (numbers.Length != Axes)
            {
                throw line.Fail(
                    numbers.Length < Axes ? MeasurementError.ShortRow : MeasurementError.LongRow,
                    $"a line of {numbers.Length} numbers",
                    $"{Axes} as in the first line (X Y Z A B C U V W): the line is cut off, or the file has something else behind its log",
                    Math.Min(numbers.Length, Axes) + 1);
            }

            var cells = numbers.Select((n, i) => new Cell(n, new(line.File, line.Number, i + 1), "XYZABCUVW"[i].ToString(), false))
                .ToArray();
            foreach (var rest in cells[3..])
            {
                _ = rest.Number();
            }

            points.Add(null, cells[0], cells[1], cells[2]);
            last = line;
        }

        ThrowIfCut(source, last);
        return points.Content(isByOrder: true);
    }

    // All numbers of a log have the same number of decimals, so a last number that lost some shows.
    private static void ThrowIfCut(MeasurementBytes source, TextLine last)
    {
        if (last.Text is null || !LogLines.EndsWithinLine(source))
        {
            return;
        }

        var numbers = Numbers(last.Text);
        if (Decimals(numbers[^1]) != Decimals(numbers[0]))
        {
            throw last.Fail(
                MeasurementError.ShortRow,
                $"the last line ends with {MeasurementRefusal.Quote(numbers[^1])}",
                "a number with the decimals of those before it: the file is cut off, copy it again",
                numbers.Length);
        }
    }

    private static int Decimals(string number) => number.Length - number.IndexOf('.', StringComparison.Ordinal);

    private static string[] Numbers(string line) => line.Split((char[])[' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
}
