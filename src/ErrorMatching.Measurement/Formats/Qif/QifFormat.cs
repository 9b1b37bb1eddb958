namespace ErrorMatching.Measurement;

/// <summary>QIF 3.0 results (ANSI/DMSC QIF 3.0, ISO 23952).</summary>
internal sealed class QifFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        head.AsSpan().TrimStart() is ['<', ..] && head.Contains("QIFDocument", StringComparison.Ordinal);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new QifReader(source).Read();
}
