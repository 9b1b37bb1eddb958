namespace ErrorMatching.Measurement;

/// <summary>The print-out of Renishaw's probing cycles: a head with the numbers of component and feature, and under it a line for each
/// result.</summary>
internal sealed class RenishawFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).Any(l => RenishawReader.HeadOf(l) is not null);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) => new RenishawReader(source, format).Read();
}
