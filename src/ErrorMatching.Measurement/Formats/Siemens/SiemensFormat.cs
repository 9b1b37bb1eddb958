namespace ErrorMatching.Measurement;

/// <summary>The protocol of Siemens measuring cycles (CYCLE97x): a line for each measured axis. Its layout is assumed.</summary>
internal sealed class SiemensFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).Any(l => SiemensReader.IsResult(l));

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new SiemensReader(source, format).Read();
}
