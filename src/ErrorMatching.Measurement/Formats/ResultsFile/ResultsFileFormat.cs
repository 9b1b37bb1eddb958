namespace ErrorMatching.Measurement;

/// <summary>The results file of an inspection on the machine, as posts for Fusion's Inspect Surface make the control print it: G800 with
/// the nominal point, its normal and limits, G801 with the ball's center and radius.</summary>
internal sealed class ResultsFileFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) => LogLines.OfHead(head).Any(
        l => l.StartsWith("G800 N", StringComparison.Ordinal) || l.StartsWith("G801 N", StringComparison.Ordinal));

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new ResultsFileReader(source, format).Read();
}
