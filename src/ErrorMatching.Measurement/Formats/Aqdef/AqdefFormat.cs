namespace ErrorMatching.Measurement;

/// <summary>Q-DAS AQDEF (ISO/TR 11462-5): K-fields that describe characteristics, and their values, in one file or in two.</summary>
internal sealed class AqdefFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        source.Has(".dfx") || FirstLine(head) is ['K', '0', '1', '0', '0', ' ' or '\t' or '/', ..];

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var reader = new AqdefReader(source.File, format.Encoding);
        if (source.Description is { } description)
        {
            reader.Add(description);
        }

        reader.Add(source);
        return reader.Content();
    }
}
