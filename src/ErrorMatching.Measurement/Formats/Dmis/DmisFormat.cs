namespace ErrorMatching.Measurement;

/// <summary>DMIS output (ISO 22093): the actual features of a measuring program.</summary>
internal sealed class DmisFormat : SelfDescribingFormat
{
    private static readonly string[] FirstWords = ["DMISMN/", "DMISMD/", "FILNAM/"];

    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head)
    {
        var first = TextLine.Of(head, source.File).Select(l => l.Text.Trim())
            .FirstOrDefault(l => l.Length > 0 && !l.StartsWith("$$", StringComparison.Ordinal));
        return first is not null && FirstWords.Any(w => first.StartsWith(w, StringComparison.OrdinalIgnoreCase));
    }

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format) =>
        new DmisReader(source, format.Encoding).Read();
}
