namespace ErrorMatching.Measurement;

/// <summary>Recognizes a table by its header, for files of a job that describes no format.</summary>
internal static class TableRecognition
{
    private const int LongestHeader = 16_384;

    private static readonly ColumnSelector X = ColumnSelector.Either("x", "x_mm");
    private static readonly ColumnSelector Y = ColumnSelector.Either("y", "y_mm");
    private static readonly ColumnSelector Z = ColumnSelector.Either("z", "z_mm");

    /// <summary>The format of the table in a text: its columns, and its delimiter unless it is stated.</summary>
    public static MeasurementFormat FormatOf(string text, MeasurementFormat format)
    {
        var at = 0;
        for (var line = 0; line < format.SkipLines; line++)
        {
            at = LineBreaks.NextLine(text, at);
        }

        var start = text.AsSpan(at).TrimStart();
        var end = start.IndexOfAny('\n', '\r');
        var header = (end < 0 ? start : start[..end])[..Math.Min(end < 0 ? start.Length : end, LongestHeader)].ToString();

        // Names of columns contain none of these characters, so the first one in the header separates the cells. Without any, blanks do.
        var found = header.FirstOrDefault(c => c is ';' or '\t' or '|', ',');
        var delimiter = format.Delimiter != '\0' ? format.Delimiter
            : found == ',' && header.Contains(' ') && !header.Contains(',') ? ' '
            : found;
        var names = header.Split(delimiter).Select(n => n.Trim().Trim('"').Trim().ToLowerInvariant()).ToHashSet(StringComparer.Ordinal);
        return format with { Delimiter = delimiter, Columns = Columns(names) };
    }

    private static MeasurementColumns Columns(HashSet<string> names)
    {
        if (names.Contains("feature") && names.Contains("item"))
        {
            var columns = (FeatureTableColumns)MeasurementFormat.FeatureTable.Columns;
            return names.Contains("deviation") ? columns : columns with { Deviation = null };
        }

        return names.Contains("i") && names.Contains("j") && !names.Contains("point") && !names.Contains("label")
            ? new GridColumns(ColumnSelector.Named("i"), ColumnSelector.Named("j"), X, Y, Z)
            : new PointColumns(ColumnSelector.Either("point", "label"), X, Y, Z);
    }
}
