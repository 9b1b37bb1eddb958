namespace ErrorMatching.Measurement;

/// <summary>The text report of PC-DMIS: a title for each dimension, and under it a table with the header AX, NOMINAL, ... MEAS.</summary>
internal sealed class PcDmisFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        TextLine.Of(head, source.File).Any(l => PcDmisHeader.Read(l) is not null);

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new PcDmisReader(source, format.Encoding).Read();
}
