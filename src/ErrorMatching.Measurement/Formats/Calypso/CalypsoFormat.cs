namespace ErrorMatching.Measurement;

/// <summary>The table of characteristics that ZEISS CALYPSO exports (<c>..._chr.txt</c>).</summary>
internal sealed class CalypsoFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head)
    {
        var line = FirstLine(head);
        return line.StartsWith("planid\t", StringComparison.OrdinalIgnoreCase)
            && line.Contains("\tactual\t", StringComparison.OrdinalIgnoreCase);
    }

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new CalypsoReader(source, format.Encoding).Read();
}
