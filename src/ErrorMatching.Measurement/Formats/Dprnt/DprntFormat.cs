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
