namespace ErrorMatching.Measurement;

/// <summary>What grbl answers to probing moves: <c>[PRB:x,y,z:1]</c> in machine coordinates, where 1 says that the probe touched and 0 that
/// it did not. No labels.</summary>
/// <remarks>Answers to other commands may be between them. Behind <c>[TLO:...]</c>, in the answer to <c>$#</c>, the last probing move is
/// repeated.</remarks>
internal sealed class GrblFormat : SelfDescribingFormat
{
    private const string Start = "[PRB:";
    private const string Layout = "[PRB:x,y,z:1], as grbl writes it";

    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).Any(l => AnswerIn(l).StartsWith(Start, StringComparison.Ordinal));

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var (unit, isNamed) = (format.Unit, false);
        LogPoints? points = null;
        var (before, last) = ("", "");
        foreach (var whole in LogLines.Of(source, format))
        {
            var line = whole with { Text = AnswerIn(whole.Text) };
            if (line.Text is "$13=0" or "$13=1")
            {
                var named = line.Text[^1] == '1' ? LengthUnit.Inch : LengthUnit.Millimeter;
                if ((points is not null || isNamed) && named != unit)
                {
                    throw line.Fail(
                        MeasurementError.UnknownUnit, MeasurementRefusal.Quote(line.Text), "one unit in the whole log: probe again");
                }

                (unit, isNamed) = (named, true);
            }
            else if (line.Text.StartsWith(Start, StringComparison.Ordinal))
            {
                if (!(line.Text == last && before.StartsWith("[TLO:", StringComparison.Ordinal)))
                {
                    Add(points ??= new(source.File, unit), line);
                }

                last = line.Text;
            }
            else if (!IsAnswer(line.Text))
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    MeasurementRefusal.Quote(line.Text),
                    Layout + ", or another of its answers: a log of grbl has nothing else");
            }

            before = line.Text;
        }

        return (points ?? new(source.File, unit)).Content(isByOrder: true);
    }

    private static void Add(LogPoints points, TextLine line)
    {
        var colon = line.Text.LastIndexOf(':');
        var values = colon > Start.Length && line.Text[^1] == ']' ? line.Text[Start.Length..colon].Split(',') : [];
        var flag = values.Length >= 3 ? line.Text[(colon + 1)..^1] : "";
        if (flag == "0")
        {
            throw line.Fail(
                MeasurementError.MissedTouch,
                $"{MeasurementRefusal.Quote(line.Text)}: the probe touched nothing",
                "a contact in each probing move ([PRB:x,y,z:1]): measure this point again",
                values.Length + 1);
        }

        if (flag != "1")
        {
            throw line.Fail(
                MeasurementError.BadStructure,
                MeasurementRefusal.Quote(line.Text),
                Layout + ": the line is cut off or damaged",
                Math.Max(1, values.Length));
        }

        var cells = values.Select((v, i) => new Cell(v, new(line.File, line.Number, i + 1), "XYZABC"[Math.Min(i, 5)].ToString(), false))
            .ToArray();
        foreach (var rest in cells[3..])
        {
            _ = rest.Number();
        }

        points.Add(null, cells[0], cells[1], cells[2]);
    }

    // Some terminals write the command that was sent before its answer: G38.2Z-5F50 < [PRB:...].
    private static string AnswerIn(string line)
    {
        var at = line.LastIndexOf("< ", StringComparison.Ordinal);
        return at == 0 || (at > 0 && line[at - 1] == ' ') ? line[(at + 2)..].TrimStart() : line;
    }

    // Answers, reports and settings, and the command that was sent where a terminal repeats it. An alarm or an error ends a program.
    private static bool IsAnswer(string line) =>
        line is "" or "ok" or ['G' or 'M' or 'T' or 'S' or 'F', >= '0' and <= '9', ..]
        || line.StartsWith("ok ", StringComparison.Ordinal) || line.StartsWith("Grbl", StringComparison.Ordinal)
        || (line[0] == '[' && line[^1] == ']') || (line[0] == '<' && line[^1] == '>') || line[0] is '$' or '>';
}
